// The shipped scenes behave as their stories say, in the full simulation and from many starts.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include <gtest/gtest.h>

#include "core/brain/presets.h"
#include "core/maths/angle.h"
#include "tests/core/runs.h"

namespace braitenlab::tests::shipped_scenes_test {
namespace {

constexpr std::uint64_t seeds = 20;

// The recorded distances, speeds and angles of the first vehicle and the first lamp.
struct Story {
    std::vector<float> distance, speed, off;  // m, m/s, degrees; one per tick
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

// The longest time without a break in which the scene has so many vehicles of the goal's role, s.
float longest_time_at_goal(const Scene& scene, std::uint64_t seed, float seconds) {
    auto world = World::create(scene, seed);
    EXPECT_TRUE(world);
    Snapshot now;
    int in_a_row = 0, longest = 0;
    for (int tick = 0; tick < static_cast<int>(60 * seconds); ++tick, world->step()) {
        world->capture(now);
        const int count = scene.goal.role == Role::prey ? now.prey : now.predators;
        in_a_row = count >= scene.goal.count ? in_a_row + 1 : 0;
        longest = std::max(longest, in_a_row);
    }
    return static_cast<float>(longest) / 60;
}

TEST(ShippedScenes, AGoalIsNotMetWithoutAChange) {
    int goals = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(BRAITENLAB_SOURCE) + "/exercises/scenes")) {
        const auto scene = load_scene(entry.path());
        ASSERT_TRUE(scene);
        if (scene->goal.role == Role::none) continue;
        ++goals;
        for (std::uint64_t seed = 1; seed <= 5; ++seed)
            EXPECT_LT(longest_time_at_goal(*scene, seed, 4 * scene->goal.seconds), scene->goal.seconds)
                << scene->name << ", seed " << seed;
    }
    EXPECT_GT(goals, 0);
}

TEST(ShippedScenes, TheGoalOfPredatorAndPreyIsMetWithSlowerPredators) {
    Scene scene = shipped_scene("predator-prey");
    BrainGraph& hunter = scene.kinds[0].brain;
    ASSERT_EQ(scene.kinds[0].role, Role::predator);
    turn(hunter, Dial::LM, 0.1f), turn(hunter, Dial::RM, 0.1f);
    EXPECT_GE(longest_time_at_goal(scene, 2, 2.5f * scene.goal.seconds), scene.goal.seconds);
}

TEST(ShippedScenes, ACowardKeepsItsDistance) {
    const Scene scene = shipped_scene("2a-coward");
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const Story story = watch(scene, seed, 25);
        EXPECT_GT(story.nearest(), 2.5f) << seed;
        EXPECT_GT(story.off.back(), 90) << seed;
    }
}

TEST(ShippedScenes, AnAggressorAcceleratesAndHitsTheLamp) {
    const Scene scene = shipped_scene("2b-aggressor");
    int hits = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const Story story = watch(scene, seed, 25);
        hits += story.nearest() < 0.8f ? 1 : 0;
        const std::size_t near = story.when_within(1.5f);
        ASSERT_LT(near, story.speed.size()) << seed;
        EXPECT_GT(story.speed[near], 2 * story.speed[60]) << seed;
    }
    EXPECT_GE(hits, 18);
}

TEST(ShippedScenes, LoveStopsFacingTheLamp) {
    const Scene scene = shipped_scene("3a-love");
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const Story story = watch(scene, seed, 25);
        EXPECT_GT(story.distance.back(), 1) << seed;
        EXPECT_LT(story.distance.back(), 3) << seed;
        EXPECT_LT(story.off.back(), 10) << seed;
        EXPECT_LT(std::fabs(story.speed.back()), 0.05f) << seed;
    }
}

TEST(ShippedScenes, AnExplorerApproachesSlowsDownTurnsAwayAndNeverStops) {
    const Scene scene = shipped_scene("3b-explorer");
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
    const Scene scene = shipped_scene("1-alive");
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const Story story = watch(scene, seed, 25);
        const auto fastest = std::max_element(story.speed.begin(), story.speed.end()) - story.speed.begin();
        EXPECT_LT(story.distance[static_cast<std::size_t>(fastest)], story.nearest() + 1.5f) << seed;
    }
}

TEST(ShippedScenes, VehicleTwoCNeitherTurnsTowardsTheLampNorAway) {
    const Scene scene = shipped_scene("2c");
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        auto world = World::create(scene, seed);
        ASSERT_TRUE(world);
        Snapshot now;
        world->capture(now);
        const float heading = now.vehicles.front().heading;
        float top = 0;
        for (int tick = 0; tick < 4 * 60; ++tick, world->step()) {
            world->capture(now);
            top = std::max(top, now.vehicles.front().speed);
            EXPECT_NEAR(now.vehicles.front().heading, heading, 0.01f) << seed;
        }
        EXPECT_GT(top, 1) << seed;
    }
}

TEST(ShippedScenes, AMothCirclesTheLampAtOneDistance) {
    const Scene scene = shipped_scene("4a-orbit");
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const Story story = watch(scene, seed, 45);
        const auto late = story.distance.end() - 20 * 60;
        const float nearest = *std::min_element(late, story.distance.end());
        const float farthest = *std::max_element(late, story.distance.end());
        EXPECT_LT(farthest, 1.03f * nearest) << seed;
        EXPECT_NEAR(nearest, 2.83f, 0.1f) << seed;
        EXPECT_GT(story.speed.back(), 1.5f) << seed;
    }
}

// The smallest distance of the first vehicle to each source.
std::vector<float> nearest_to_each(const World& world, std::vector<float> before = {}) {
    static Snapshot now;
    world.capture(now);
    before.resize(now.sources.size(), INFINITY);
    const VehicleView& it = now.vehicles.front();
    for (std::size_t s = 0; s < before.size(); ++s)
        before[s] = std::min(before[s], std::hypot(now.sources[s].x - it.x, now.sources[s].y - it.y));
    return before;
}

TEST(ShippedScenes, ADoubterDrivesSlowlyBetweenTwoLampsThenHitsOneOfThem) {
    const Scene scene = shipped_scene("4b-decision");
    int left = 0, right = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        auto world = World::create(scene, seed);
        ASSERT_TRUE(world);
        Snapshot now;
        std::vector<float> nearest;
        bool decided = false;
        for (int tick = 0; tick < 15 * 60; ++tick, world->step()) {
            world->capture(now);
            decided |= std::max(now.sensed[0], now.sensed[1]) >= 0.3f;
            EXPECT_TRUE(decided || now.vehicles.front().speed < 0.95f) << seed;
            nearest = nearest_to_each(*world, nearest);
        }
        EXPECT_NE(nearest[0] < 0.8f, nearest[1] < 0.8f) << seed << ": one lamp and not the other";
        ++(nearest[0] < 0.8f ? left : right);
    }
    EXPECT_GE(left, 5);
    EXPECT_GE(right, 5);
}

TEST(ShippedScenes, ACounterStopsAtTheThirdLamp) {
    const Scene scene = shipped_scene("5-logic");
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        auto world = World::create(scene, seed);
        ASSERT_TRUE(world);
        for (int tick = 0; tick < 10 * 60; ++tick) world->step();
        Snapshot now;
        world->capture(now);
        const VehicleView& it = now.vehicles.front();
        EXPECT_NEAR(it.x, now.sources[2].x, 0.5f) << seed;
        EXPECT_LT(std::fabs(it.speed), 0.01f) << seed;
        const auto on = [&](const char* name) {
            return node_value(now, it, find_node(*now.brains[0], std::string(name))->id);
        };
        EXPECT_EQ(on("THREE"), 1) << seed;
    }
    Scene two_lamps = scene;
    two_lamps.sources.resize(2);
    EXPECT_GT(watch(two_lamps, 1, 6).speed.back(), 1.2f) << "it does not stop at two lamps";
}

TEST(ShippedScenes, AVehicleWithFourSensesAvoidsHeatAndStopsFacingItsSource) {
    const Scene scene = shipped_scene("3c-values");
    int struck_the_lamp = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        auto world = World::create(scene, seed);
        ASSERT_TRUE(world);
        std::vector<float> nearest;
        for (int tick = 0; tick < 60 * 60; ++tick, world->step()) nearest = nearest_to_each(*world, nearest);
        Snapshot now;
        world->capture(now);
        const VehicleView& it = now.vehicles.front();
        struck_the_lamp += nearest[0] < 0.8f;
        EXPECT_GT(nearest[1], 2.5f) << seed << " approached the heat";
        const float dx = now.sources[2].x - it.x, dy = now.sources[2].y - it.y;
        EXPECT_LT(std::hypot(dx, dy), 3) << seed;
        EXPECT_LT(std::fabs(maths::wrap_angle(maths::arctangent2(dy, dx) - it.heading)), maths::radians(15)) << seed;
        EXPECT_LT(std::fabs(it.speed), 0.05f) << seed;
    }
    EXPECT_GE(struck_the_lamp, 5);
}

// Pavlov's experiment, in the shipped scene.
TEST(ShippedScenes, AVehicleLearnsToAvoidRedAndForgetsIt) {
    const Scene scene = shipped_scene("7-mnemotrix");
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        auto world = World::create(scene, seed);
        ASSERT_TRUE(world);
        const auto nearest_to_toy = [&](int seconds) {
            std::vector<float> nearest;
            for (int tick = 0; tick < seconds * 60; ++tick, world->step()) nearest = nearest_to_each(*world, nearest);
            return nearest[0];
        };
        EXPECT_LT(nearest_to_toy(4), 0.6f) << seed << " avoids red before it has learned";
        (void)nearest_to_toy(30);  // heat and red occur together
        ASSERT_FALSE(world->apply(MoveVehicle{0, -6.5f, 0, 0}));
        EXPECT_GT(nearest_to_toy(4), 1.5f) << seed << " has not learned";

        for (const int source : {0, 1, 2}) ASSERT_FALSE(world->apply(MoveSource{source, 500, 500}));
        (void)nearest_to_toy(100);
        ASSERT_FALSE(world->apply(MoveSource{0, -3.2f, 0}));
        ASSERT_FALSE(world->apply(MoveVehicle{0, -6.5f, 0, 0}));
        EXPECT_LT(nearest_to_toy(4), 0.6f) << seed << " has not forgotten";
    }
}

TEST(ShippedScenes, TheTortoiseEntersItsHutchAtLowEnergyAndLeavesAtFullEnergy) {
    const Scene scene = shipped_scene("tortoise");
    const Zone& hutch = scene.zones.front();
    int starved = 0, remembered = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        auto world = World::create(scene, seed);
        ASSERT_TRUE(world) << world.error().text();
        Snapshot now;
        int meals = 0;
        bool feeding = false, bumped = false;
        for (int tick = 0; tick < 150 * 60; ++tick, world->step()) {
            world->capture(now);
            const VehicleView& it = now.vehicles.front();
            const bool home = std::hypot(it.x - hutch.x, it.y - hutch.y) < hutch.length / 2;
            bumped |= !now.marks.empty();
            if (home && it.energy < 0.4f) feeding = true;
            if (feeding && it.energy > 0.88f) feeding = false, ++meals;
        }
        EXPECT_GE(meals, 2) << seed;
        starved += now.events.deaths > 0;
        remembered += bumped;
    }
    EXPECT_EQ(starved, 0);
    EXPECT_EQ(remembered, 20);
}

// ── Presets and scenes are the same vehicles ────────────────────────────────────────────────────────────────────────

// A brain in a normal form: names instead of ids, no feelers, no wires without effect, in a fixed order.
struct Drawing {
    std::vector<Node> nodes;
    std::vector<std::pair<std::pair<std::string, std::string>, Wire>> wires;
    friend bool operator==(const Drawing&, const Drawing&) = default;
};

Drawing drawing(const BrainGraph& graph) {
    Drawing it;
    const auto is_feeler = [](const std::string& name) {
        return name == "OL" || name == "OR" || name == "KL" || name == "KR";
    };
    for (Node node : graph.nodes) {
        if (is_feeler(node.name)) continue;
        node.id = 0;
        it.nodes.push_back(node);
    }
    for (Wire wire : graph.wires) {
        const std::string from = find_node(graph, wire.from)->name, to = find_node(graph, wire.to)->name;
        if (is_feeler(from) || (wire.weight == 0 && !learns(wire))) continue;
        wire.from = wire.to = 0;
        it.wires.push_back({{from, to}, wire});
    }
    std::sort(it.nodes.begin(), it.nodes.end(), [](const Node& a, const Node& b) { return a.name < b.name; });
    std::sort(it.wires.begin(), it.wires.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    return it;
}

TEST(Presets, EqualTheBrainsOfTheirScenes) {
    for (const Preset& preset : presets()) {
        const Scene scene = shipped_scene(std::string(preset.scene));
        const int named = find_kind(scene, std::string(preset.name));
        ASSERT_FALSE(scene.kinds.empty()) << preset.name;
        const Kind& kind = scene.kinds[static_cast<std::size_t>(std::max(named, 0))];
        EXPECT_TRUE(drawing(kind.brain) == drawing(preset.brain)) << preset.name;
    }
}

TEST(ShippedScenes, PredatorsCatchPreyAndNoVehicleIsStuckForLong) {
    const Scene scene = shipped_scene("predator-prey");
    const auto population = static_cast<std::size_t>(scene.ecology.population);
    std::int64_t captures = 0;
    int worst = 0;
    double still_share = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
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
                still_share += ticks > 60 ? 1.0 / static_cast<double>(seeds * 120 * 60 * population) : 0;
            }
        }
        EXPECT_EQ(now.vehicles.size(), population);
        EXPECT_EQ(now.generation, 1);
        captures += now.events.captures;
        EXPECT_GT(now.events.captures, 0) << seed;
    }
    EXPECT_GT(captures, 5 * static_cast<std::int64_t>(seeds));
    EXPECT_LT(worst, 30 * 60);
    EXPECT_LT(still_share, 0.02);
}

TEST(ShippedScenes, PredatorsAndPreyAreEachAQuarterOrMoreOfThePopulationMostOfTheTime) {
    constexpr int seconds = 180;
    constexpr std::uint64_t few_seeds = 6;  // limits the time of the test
    const Scene scene = shipped_scene("predator-prey");
    int balanced = 0;
    for (std::uint64_t seed = 1; seed <= few_seeds; ++seed) {
        World world = make(scene, seed);
        for (int second = 0; second < seconds; ++second) {
            const Snapshot now = after(world, 1);
            const auto all = static_cast<int>(now.vehicles.size());
            ASSERT_EQ(now.predators + now.prey, all) << seed;
            balanced += 4 * std::min(now.predators, now.prey) >= all;
        }
    }
    EXPECT_GE(balanced, 0.85 * seconds * few_seeds);
}

}  // namespace
}  // namespace braitenlab::tests::shipped_scenes_test
