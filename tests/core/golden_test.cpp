// The golden hashes: every shipped scene, seed 1, 30 s. They guard determinism, in debug and in release alike.
//
// A hash that changes is a decision: the tick, a scene or a law has changed, and the commit says which and why.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "core/scene/scene_file.h"
#include "core/world/world.h"

namespace braitenlab {
namespace {

const std::map<std::string, std::string> golden{
    {"predator-prey", "e8430d272da39e79"},
    {"1-alive", "de28dc3307594cfa"},
    {"2a-coward", "ff92dd4032f66035"},
    {"2b-aggressor", "a95f8cf51e4bc296"},
    {"3a-love", "9ef100999c69685a"},
    {"3b-explorer", "2f65c34b902d4120"},
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
