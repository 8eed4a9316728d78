// The golden hashes: every shipped scene, seed 1, 30 s. They check determinism in debug and release builds.
//
// A hash changes only with the tick, a scene or a physical law. The commit message says which and why.
#include <filesystem>
#include <map>
#include <set>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/scene/scene_file.h"
#include "core/world/world.h"

namespace braitenlab::tests::golden_test {
namespace {

const std::map<std::string, std::string> golden{
    {"tortoise", "390a296e76f54fd8"},
    {"1-alive", "c559d170c05add93"},
    {"2a-coward", "b022473893468258"},
    {"2b-aggressor", "78f2469699485857"},
    {"2c", "41c5e7cc91422fec"},
    {"3a-love", "9187934c6f5877c5"},
    {"3b-explorer", "ba5a0277dd638143"},
    {"3c-values", "5b3b1a00e6068563"},
    {"4a-orbit", "203521625d0deb08"},
    {"4b-decision", "7ddca9f7b2cfc2b4"},
    {"5-logic", "0690bbf597662507"},
    {"7-mnemotrix", "428d3374187eb4b6"},
    {"predator-prey", "fdcd37ba64447b10"},
    {"line-follower", "2fc6f29ccaefde19"},
    {"ice-rink", "23dcd4afdf785919"},
    {"wind-tunnel", "2db0be34c3320185"},
    {"table-edge", "fbd51a05f5a1e7f6"},
    {"torus", "77289864a8bed2eb"},
    {"dance", "8174fb63a231d2ce"},
    {"convoy", "96a674f794bac338"},
    {"moth-and-hunter", "c9e75e4de41af54c"},
    {"drivers", "510170fa8c9f9c34"},
    {"obstacle-course", "5a58a1e9ce5a91ac"},
    {"pushing", "fe69334a7e83ad57"},
    {"empty", "6906852530d75b13"},
};

const std::filesystem::path scenes = std::filesystem::path(BRAITENLAB_SOURCE) / "exercises" / "scenes";

TEST(GoldenHash, OfEveryShippedSceneIsUnchanged) {
    for (const auto& [name, hash] : golden) {
        const auto scene = load_scene(scenes / (name + ".toml"));
        ASSERT_TRUE(scene) << scene.error().text();
        auto world = World::create(*scene, 1);
        ASSERT_TRUE(world);
        while (world->tick() < 30 * 60) world->step();
        EXPECT_EQ(fmt::format("{:016x}", world->hash()), hash) << name;
    }
}

TEST(GoldenHash, ExistsForEveryShippedScene) {
    for (const auto& entry : std::filesystem::directory_iterator(scenes))
        EXPECT_TRUE(golden.contains(entry.path().stem().string())) << entry.path();
}

}  // namespace
}  // namespace braitenlab::tests::golden_test
