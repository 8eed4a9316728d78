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
    {"predator-prey", "f89b695a1b6f2e8b"}, {"1-alive", "38c3c9891cc656b6"}, {"2a-coward", "0b3c336d659b0b48"},
    {"2b-aggressor", "d877c7f92a36387d"},  {"3a-love", "d7b74f597a6d1489"}, {"3b-explorer", "508e031d48be7bea"},
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
