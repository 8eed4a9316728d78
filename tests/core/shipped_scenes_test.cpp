// The shipped scenes show what their stories say, on the real physics and from many starts.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include <gtest/gtest.h>

#include "core/maths/angle.h"
#include "core/scene/scene_file.h"
#include "core/world/world.h"

namespace braitenlab {
namespace {

constexpr std::uint64_t seeds = 20;

Scene shipped(const std::string& name) {
    auto scene = load_scene(std::filesystem::path(BRAITENLAB_SOURCE) / "exercises/scenes" / (name + ".toml"));
    EXPECT_TRUE(scene) << scene.error().text();
    return scene ? *scene : Scene{};
}

// What the first vehicle and the first lamp went through.
struct Story {
    std::vector<float> distance, speed, off;  // m, m/s, degrees; one a tick
    float nearest() const { return *std::min_element(distance.begin(), distance.end()); }
    std::size_t when_within(float metres) const {
        return static_cast<std::size_t>(
            std::find_if(distance.begin(), distance.end(), [metres](float d) { return d <= metres; }) -
            distance.begin());
    }
};

Story watch(const Scene& scene, std::uint64_t seed, int seconds) {
    Story story;
    auto world = World::create(scene, seed);
    EXPECT_TRUE(world) << world.error().text();
    if (!world) return story;
    Snapshot now;
    for (int tick = 0; tick <= seconds * 60; ++tick, world->step()) {
        world->capture(now);
        const VehicleView& it = now.vehicles.front();
        const float dx = now.sources[0].x - it.x, dy = now.sources[0].y - it.y;
        story.distance.push_back(std::hypot(dx, dy));
        story.speed.push_back(it.speed);
        story.off.push_back(std::fabs(maths::degrees(maths::wrap_angle(maths::arctangent2(dy, dx) - it.heading))));
    }
    return story;
}

TEST(ShippedScenes, ACowardNeverComesNear) {
    const Scene scene = shipped("2a-coward");
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const Story story = watch(scene, seed, 25);
        EXPECT_GT(story.nearest(), 2.5f) << seed;
        EXPECT_GT(story.off.back(), 90) << seed;
    }
}

TEST(ShippedScenes, AnAggressorHitsTheLampFasterAndFaster) {
    const Scene scene = shipped("2b-aggressor");
    int hits = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const Story story = watch(scene, seed, 25);
        hits += story.nearest() < 0.5f ? 1 : 0;
        const std::size_t near = story.when_within(1.5f);
        ASSERT_LT(near, story.speed.size()) << seed;
        EXPECT_GT(story.speed[near], 2 * story.speed[60]) << seed;
    }
    EXPECT_GE(hits, 18);
}

TEST(ShippedScenes, LoveComesToRestFacingTheLamp) {
    const Scene scene = shipped("3a-love");
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const Story story = watch(scene, seed, 25);
        EXPECT_GT(story.distance.back(), 1) << seed;
        EXPECT_LT(story.distance.back(), 3) << seed;
        EXPECT_LT(story.off.back(), 10) << seed;
        EXPECT_LT(std::fabs(story.speed.back()), 0.05f) << seed;
    }
}

TEST(ShippedScenes, AnExplorerComesNearerSlowsDownVeersOffAndNeverStops) {
    const Scene scene = shipped("3b-explorer");
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const Story story = watch(scene, seed, 25);
        const auto at = std::min_element(story.distance.begin(), story.distance.begin() + 15 * 60);
        EXPECT_LT(*at, story.distance.front() - 0.5f) << seed;
        EXPECT_GT(*at, 1) << seed;
        EXPECT_GT(*std::max_element(at, story.distance.end()), *at + 2) << seed;
        EXPECT_GT(*std::min_element(story.speed.begin() + 60, story.speed.end()), 0.3f) << seed;
    }
}

TEST(ShippedScenes, TheLivingVehicleIsFastestNearTheLamp) {
    const Scene scene = shipped("1-alive");
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const Story story = watch(scene, seed, 25);
        const auto fastest = std::max_element(story.speed.begin(), story.speed.end()) - story.speed.begin();
        EXPECT_LT(story.distance[static_cast<std::size_t>(fastest)], story.nearest() + 1.5f) << seed;
    }
}

TEST(ShippedScenes, PredatorsCatchPreyAndNobodyIsStuckForLong) {
    const Scene scene = shipped("predator-prey");
    std::int64_t captures = 0;
    int worst = 0;
    double still_share = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        auto world = World::create(scene, seed);
        ASSERT_TRUE(world) << world.error().text();
        Snapshot now;
        std::map<VehicleId, int> still;
        for (int tick = 0; tick < 120 * 60; ++tick, world->step()) {
            world->capture(now);
            for (const VehicleView& it : now.vehicles) {
                int& ticks = still[it.id];
                ticks = std::fabs(it.speed) < 0.05f ? ticks + 1 : 0;
                worst = std::max(worst, ticks);
                still_share += ticks > 60 ? 1.0 / (5 * 120 * 60 * 10) : 0;
            }
        }
        EXPECT_EQ(now.vehicles.size(), 10u);
        EXPECT_EQ(now.generation, 1);
        captures += now.events.captures;
    }
    EXPECT_GT(captures, 5 * 5);
    EXPECT_LT(worst, 30 * 60);
    EXPECT_LT(still_share, 0.02);
}

}  // namespace
}  // namespace braitenlab
