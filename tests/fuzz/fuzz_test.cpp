// The corpus of the fuzzer, and some mutants of it. A broken promise ends the process and names it.
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/scene/toml_tree.h"
#include "tests/fuzz/inputs.h"
#include "tests/fuzz/mutate.h"
#include "tests/fuzz/targets.h"

namespace braitenlab::tests::fuzz_test {
namespace {

using namespace fuzz;

class Fuzz : public testing::TestWithParam<Target> {};

TEST_P(Fuzz, ReadsItsInputsAndSomeMutantsOfThem) {
    const Target& target = GetParam();
    const std::vector<std::string> inputs = inputs_of(target);
    ASSERT_FALSE(inputs.empty()) << "tests/corpus/" << target.name << " has no file";
    constexpr std::uint64_t mutants = 100;
    for (const std::string& input : inputs) target.run(input);
    for (std::uint64_t seed = 0; seed < mutants; ++seed)
        target.run(mutant_of(inputs[seed % inputs.size()], seed, inputs));
}

INSTANTIATE_TEST_SUITE_P(Every, Fuzz, testing::ValuesIn(targets().begin(), targets().end()), [](const auto& given) {
    std::string name(given.param.name);
    std::erase(name, '-');
    return name;
});

TEST(Mutate, KeepsEnoughStructureForMostMutantsToBeToml) {
    const std::vector<std::string> inputs = inputs_of(*find_target("scene"));
    int parsed = 0;
    for (std::uint64_t seed = 0; seed < 500; ++seed)
        parsed += static_cast<bool>(parse_toml(mutant_of(inputs[seed % inputs.size()], seed, inputs), "f.toml"));
    EXPECT_GT(parsed, 220) << "of 500; of random changes of bytes about 80";
    EXPECT_LT(parsed, 490) << "some are refused";
}

}  // namespace
}  // namespace braitenlab::tests::fuzz_test
