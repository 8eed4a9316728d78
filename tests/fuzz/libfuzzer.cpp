// The targets under libFuzzer. BRAITENLAB_FUZZ names one; without it they are listed, each with the folders of its
// inputs.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "tests/fuzz/inputs.h"
#include "tests/fuzz/mutate.h"
#include "tests/fuzz/targets.h"

using namespace braitenlab::fuzz;

namespace {

const Target* target = nullptr;
std::vector<std::string> others;  // whose lines mutants take

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(unsigned char* data, std::size_t size, std::size_t most);

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    const char* name = std::getenv("BRAITENLAB_FUZZ");
    target = find_target(name ? name : "");
    if (target) return others = inputs_of(*target), 0;
    for (const Target& one : targets()) {
        std::printf("%s", one.name.data());
        for (const std::string& folder : folders_of(one)) std::printf(" %s", folder.c_str());
        std::printf("\n");
    }
    std::exit(2);
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    target->run({reinterpret_cast<const char*>(data), size});
    return 0;
}

// A quarter of the mutants are libFuzzer's own.
extern "C" std::size_t LLVMFuzzerCustomMutator(unsigned char* data, std::size_t size, std::size_t most, unsigned seed) {
    if (!target->is_text || seed % 4 == 0) return LLVMFuzzerMutate(data, size, most);
    const std::string mutant = mutant_of({reinterpret_cast<const char*>(data), size}, seed, others);
    const std::size_t length = std::min(mutant.size(), most);
    std::memcpy(data, mutant.data(), length);
    return length;
}
