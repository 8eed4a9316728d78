// The golden hashes: every shipped scene, seed 1, 30 s. They guard determinism, in debug and in release alike.
//
// A hash that changes is a decision: the tick, a scene or a law has changed, and the commit says which and why.
#include <filesystem>
#include <map>
#include <set>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/scene/scene_file.h"
#include "core/world/world.h"

namespace braitenlab {
namespace {

const std::map<std::string, std::string> golden{
    {"1-alive", "38c3c9891cc656b6"},   {"2a-coward", "0b3c336d659b0b48"},   {"2b-aggressor", "e329ff90494eaa24"},
    {"2c", "f7ee9158d1e638a1"},        {"3a-love", "d7b74f597a6d1489"},     {"3b-explorer", "508e031d48be7bea"},
    {"3c-values", "969b4f4991dbbd83"}, {"4a-orbit", "215354366d46d9dd"},    {"4b-decision", "27425ede1f8da0a4"},
    {"5-logic", "f2ef241eb6c18ef9"},   {"7-mnemotrix", "4ee774b821d52a67"}, {"predator-prey", "f89b695a1b6f2e8b"},
};

const std::filesystem::path scenes = std::filesystem::path(BRAITENLAB_SOURCE) / "exercises" / "scenes";

TEST(GoldenHash, OfEveryShippedSceneIsAsItWas) {
    for (const auto& [name, hash] : golden) {
        const auto scene = load_scene(scenes / (name + ".toml"));
        ASSERT_TRUE(scene) << scene.error().text();
        auto world = World::create(*scene, 1);
        ASSERT_TRUE(world);
        while (world->tick() < 30 * 60) world->step();
        EXPECT_EQ(fmt::format("{:016x}", world->hash()), hash) << name;
    }
}

TEST(GoldenHash, IsThereForEveryShippedScene) {
    for (const auto& entry : std::filesystem::directory_iterator(scenes))
        EXPECT_TRUE(golden.contains(entry.path().stem().string())) << entry.path();
}

}  // namespace
}  // namespace braitenlab
