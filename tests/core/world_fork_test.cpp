// Forks, traces, snapshots, edits and the hash.
#include <functional>

#include <gtest/gtest.h>

#include "core/maths/angle.h"
#include "core/scene/scene_file.h"
#include "core/world/world.h"
#include "tests/core/runs.h"
#include "tests/core/scenes.h"

namespace braitenlab::tests::world_fork_test {
namespace {

World shipped(const std::filesystem::path& path) { return make(*load_scene(path), 3); }

void steps(World& world, int count) {
    for (int i = 0; i < count; ++i) world.step();
}

TEST(World, AForkEqualsTheOriginalAfterAKeyframeAtTheSameTick) {
    for (const auto& path : shipped_scenes()) {
        World original = shipped(path);
        steps(original, static_cast<int>(keyframe_ticks));
        ASSERT_TRUE(original.is_at_keyframe());
        World fork = original.fork();
        EXPECT_TRUE(fork.is_at_keyframe());
        for (int i = 0; i < 310; ++i) {
            ASSERT_EQ(fork.hash(), original.hash()) << path << " at tick " << original.tick();
            fork.step(), original.step();
        }
    }
}

TEST(World, AForkBetweenKeyframesEqualsTheRunFromItsCheckpoint) {
    for (const auto& path : shipped_scenes()) {
        World original = shipped(path), undisturbed = shipped(path);
        steps(original, 137), steps(undisturbed, 137);
        ASSERT_FALSE(original.apply(NewPopulation{}));
        ASSERT_FALSE(undisturbed.apply(NewPopulation{}));
        World fork = original.fork();
        EXPECT_EQ(fork.hash(), original.hash()) << path;
        World restored = World::restore(fork.checkpoint());
        steps(fork, 200), steps(restored, 200);
        EXPECT_EQ(fork.hash(), restored.hash()) << path;
        steps(original, 200), steps(undisturbed, 200);
        EXPECT_EQ(original.hash(), undisturbed.hash()) << path << ": a fork does not change the original";
    }
}

TEST(World, ATraceHasTheValuesOfTheSnapshot) {
    World world = make(crowd(5));
    VehicleTrace trace;
    for (int i = 0; i < 60; ++i) {
        world.step();
        const Snapshot now = look(world);
        for (const VehicleView& v : now.vehicles) {
            ASSERT_TRUE(world.trace(v.id, trace));
            EXPECT_EQ(trace.tick, now.tick);
            EXPECT_EQ(trace.pose, (Pose{v.x, v.y, v.heading}));
            EXPECT_EQ(trace.motor, v.motor);
            ASSERT_EQ(trace.sensed.size(), 2u);
            for (std::size_t k = 0; k < 2; ++k)
                EXPECT_EQ(trace.sensed[k], now.sensed[static_cast<std::size_t>(v.first_sensed) + k]);
        }
    }
    EXPECT_FALSE(world.trace(99, trace));
}

// A trace shows the wheel commands of the last tick. A capture after a command must not change them.
TEST(World, ACaptureChangesNothing) {
    World world = make(alone({.LM = 0.5f, .RM = 0.5f}));
    world.step();
    ASSERT_FALSE(world.apply(TurnDial{{.kind = 0}, Dial::LM, -0.5f}));
    EXPECT_EQ(look(world).vehicles[0].motor[0], -0.5f) << "the snapshot shows the next tick's commands";
    VehicleTrace trace;
    ASSERT_TRUE(world.trace(0, trace));
    EXPECT_EQ(trace.motor[0], 0.5f);
}

// Four vehicles that push against each other: rebuilding Box2D loses its contact caches and changes later bits.
TEST(World, EditingASourceThatIsNotSolidDoesNotRebuildTheBodies) {
    Scene scene;
    scene.kinds = {two_eyed("pusher", {.LM = 0.9f, .RM = 0.9f})};
    for (int i = 0; i < 4; ++i)
        scene.starts.push_back({.name = "v" + std::to_string(i),
                                .kind = "pusher",
                                .x = i % 2 ? 0.9f : -0.9f,
                                .y = 0.31f * static_cast<float>(i),
                                .heading = i % 2 ? maths::pi : 0});
    scene.sources = {{.name = "nose", .channel = Channel::smell, .x = 5}};
    const auto end_of = [&](const std::vector<Command>& edits) {
        World world = make(scene);
        steps(world, 45);
        for (const Command& edit : edits) EXPECT_FALSE(world.apply(edit));
        steps(world, 60);
        std::vector<Pose> poses;
        for (const VehicleView& v : look(world).vehicles) poses.push_back({v.x, v.y, v.heading});
        return poses;
    };
    const auto undisturbed = end_of({});
    Source fainter = scene.sources[0];
    fainter.strength = 0.5f;
    EXPECT_EQ(end_of({EditSource{0, fainter}}), undisturbed);
    EXPECT_EQ(end_of({AddSource{fainter}}), undisturbed);
    EXPECT_EQ(end_of({RemoveSource{0}}), undisturbed);
    Zone far_away{.x = 40, .surface = Surface::ice};
    EXPECT_EQ(end_of({AddZone{far_away}, MoveZone{0, 41, 0, 1}}), undisturbed);
    far_away.surface = Surface::sand;
    EXPECT_EQ(end_of({AddZone{far_away}, EditZone{0, far_away}, RemoveZone{0}}), undisturbed);
    Source solid = scene.sources[0];
    solid.solid = true;
    EXPECT_NE(end_of({EditSource{0, solid}}), undisturbed)
        << "the poses must depend on a rebuild, else this test is void";
}

TEST(World, TheHashDependsOnAllStateThatAffectsTheRun) {
    Scene scene = crowd(3);
    scene.sources = {{.name = "lamp", .x = 2}};
    scene.obstacles = {{.name = "box", .x = 4}};
    scene.zones = {{.name = "zone", .x = -4}};
    scene.starts = {{.name = "first", .kind = "hunter", .x = 1}};
    const std::vector<std::function<void(Scene&)>> edits{
        [](Scene& s) { s.sources[0].strength = 0.5f; },
        [](Scene& s) { s.sources[0].channel = Channel::smell; },
        [](Scene& s) { s.sources[0].solid = true; },
        [](Scene& s) { s.obstacles[0].length = 2; },
        [](Scene& s) { s.obstacles[0].mass = 2; },
        [](Scene& s) {
            s.obstacles[0].corners = {{0, 0}, {1, 0}, {0, 1}};
        },
        [](Scene& s) { s.zones[0].wind_x = 1; },
        [](Scene& s) { s.zones[0].surface = Surface::ice; },
        [](Scene& s) {
            s.zones[0].corners = {{0, 0}, {1, 0}, {0, 1}};
        },
        [](Scene& s) { s.kinds[0].sensors[0].range = 3; },
        [](Scene& s) {
            s.kinds[0].sensors[0].latency = 0;
            s.kinds[0].sensors[0].noise = 0.1f;
        },
        [](Scene& s) { s.kinds[0].body.mass = 11; },
        [](Scene& s) { s.kinds[0].lamps = {{.name = "tail"}}; },
        [](Scene& s) { s.kinds[0].memory.marks = 3; },
        [](Scene& s) {
            s.kinds[1].waypoints = {{1, 1}};
        },
        [](Scene& s) {
            s.starts[0].heading_spread = 0;
            s.starts[0].facing = "lamp";
            s.starts[0].heading = -maths::pi;
        },
        [](Scene& s) { s.arena.ambient = 0.2f; },
        [](Scene& s) { s.ecology.bite = 0.3f; },
    };
    const std::uint64_t hash = make(scene).hash();
    for (std::size_t i = 0; i < edits.size(); ++i) {
        Scene edited = scene;
        edits[i](edited);
        EXPECT_NE(make(edited).hash(), hash) << "edit " << i;
    }
    Scene renamed = scene;
    renamed.name = "other", renamed.title = "Other", renamed.story = "Once.";
    EXPECT_EQ(make(renamed).hash(), hash) << "the title does not change the run";
}

}  // namespace
}  // namespace braitenlab::tests::world_fork_test
