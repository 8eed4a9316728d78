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
    {"predator-prey", "63bf88fe4f7c37dd"}, {"1-alive", "0c648bdb694db4a8"}, {"2a-coward", "f2a280d46ec8380f"},
    {"2b-aggressor", "0573ffb446303bb3"},  {"3a-love", "1416d6d4c557a25d"}, {"3b-explorer", "872c386da29d882f"},
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
