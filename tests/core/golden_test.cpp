// The golden hashes: tests/golden/hashes.json, of every shipped scene and exercise after 60 s. They check determinism
// in debug and release builds.
//
// A hash changes only with the tick, a scene or a physical law. The commit message says which and why.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "core/lesson/shipped_hashes.h"

namespace braitenlab::tests::golden_test {
namespace {

const std::filesystem::path source = BRAITENLAB_SOURCE;

TEST(GoldenHash, OfEveryShippedSceneAndExerciseIsUnchanged) {
    const auto golden = read_hashes(source / "tests" / "golden" / "hashes.json");
    ASSERT_TRUE(golden) << golden.error().text();
    const auto hashes = hashes_of_shipped(source / "exercises", 60);
    ASSERT_TRUE(hashes) << hashes.error().text();
    for (const std::string& line : differences(*hashes, *golden)) ADD_FAILURE() << line;
}

}  // namespace
}  // namespace braitenlab::tests::golden_test
