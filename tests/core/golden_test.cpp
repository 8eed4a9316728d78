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

namespace braitenlab::tests::golden_test {
namespace {

const std::map<std::string, std::string> golden{
    {"tortoise", "a6ff708ad87b1e25"},      {"1-alive", "51836c1c63014715"},   {"2a-coward", "dce8087333897ab6"},
    {"2b-aggressor", "a6f9d571aef16750"},  {"2c", "b90856b781b723fc"},        {"3a-love", "240ac4b43cf3ad47"},
    {"3b-explorer", "248f2cab65bcefa9"},   {"3c-values", "d742ec79ad66cec4"}, {"4a-orbit", "7f8fc0f90c8354a0"},
    {"4b-decision", "7a283553062e3973"},   {"5-logic", "f2ef241eb6c18ef9"},   {"7-mnemotrix", "e6a9c4fd3cace470"},
    {"predator-prey", "45f4001c9edc40fa"},
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
}  // namespace braitenlab::tests::golden_test
