#include <array>
#include <functional>
#include <thread>

#include <gtest/gtest.h>

#include "core/maths/random.h"
#include "core/scene/scene_file.h"
#include "core/world/world.h"
#include "tests/core/scenes.h"

namespace braitenlab::tests::checkpoint_test {
namespace {

using namespace world;
World world_of(const std::filesystem::path& path, std::uint64_t seed) {
    const auto scene = load_scene(path);
    EXPECT_TRUE(scene) << scene.error().text();
    return std::move(*World::create(*scene, seed));
}

void steps(World& world, int count) {
    for (int i = 0; i < count; ++i) world.step();
}

TEST(World, ACheckpointContinuesTheSavedRunExactlyFromAnyTickOfEveryShippedScene) {
    maths::Random chance{7, 1};
    for (const auto& path : tests::shipped_scenes()) {
        World world = world_of(path, 3);
        for (int round = 0; round < 4; ++round) {
            steps(world, static_cast<int>(chance.next() % 400));
            World restored = World::restore(world.checkpoint());
            EXPECT_EQ(restored.hash(), world.hash()) << path << " at tick " << world.tick();
            World ahead = World::restore(world.checkpoint());
            const int more = 350;
            steps(restored, more);
            steps(world, more);
            EXPECT_EQ(restored.hash(), world.hash()) << path << " at tick " << world.tick();
            steps(ahead, 1);  // a third world does not change the other two
        }
    }
}

// A prediction may run in another thread: worlds share brains and keyframes, but no mutable state.
TEST(World, ACheckpointContinuesInTwoThreadsAsInOne) {
    for (const auto& path : tests::shipped_scenes()) {
        World alone = world_of(path, 3);
        steps(alone, 130);
        const Checkpoint save = alone.checkpoint();
        steps(alone, 600);
        std::array<std::uint64_t, 2> hashes{};
        const auto go_on = [&save](std::uint64_t& hash) {
            World world = World::restore(save);
            steps(world, 600);
            hash = world.hash();
        };
        std::thread one(go_on, std::ref(hashes[0])), other(go_on, std::ref(hashes[1]));
        one.join(), other.join();
        EXPECT_EQ(hashes[0], alone.hash()) << path;
        EXPECT_EQ(hashes[1], alone.hash()) << path;
    }
}

TEST(World, ACheckpointStoresTheCommandsSinceTheKeyframe) {
    World world = std::move(*World::create(tests::crowd(12), 5));
    steps(world, 130);
    ASSERT_FALSE(world.apply(TurnDial{{.kind = 0}, Dial::LL, 1.5f}));
    ASSERT_FALSE(world.apply(AddVehicle{}));
    steps(world, 40);
    ASSERT_FALSE(world.apply(RemoveVehicle{3}));
    ASSERT_FALSE(world.apply(MoveVehicle{5, 1, 2, 0.5f}));
    ASSERT_FALSE(world.apply(AddSource{{"", Channel::heat, 2, 2, 1, true}}));
    ASSERT_FALSE(world.apply(AddObstacle{{"", -2, -2, 0.3f, 2, 1}}));
    World restored = World::restore(world.checkpoint());
    EXPECT_EQ(restored.hash(), world.hash());
    steps(restored, 400);
    steps(world, 400);
    EXPECT_EQ(restored.hash(), world.hash());
}

TEST(World, ACheckpointStaysSmallDuringALongDragInAPausedRun) {
    World world = std::move(*World::create(tests::crowd(12), 5));
    steps(world, 130);
    for (int i = 0; i < 5000; ++i) {
        const float along = static_cast<float>(i % 97) * 0.05f;
        ASSERT_FALSE(world.apply(MoveVehicle{5, along - 2, 1 - along, along}));
    }
    ASSERT_FALSE(world.apply(TurnDial{{.kind = 0}, Dial::LL, 1.5f}));
    EXPECT_LT(world.checkpoint().commands.size(), keyframe_commands);
    World restored = World::restore(world.checkpoint());
    EXPECT_EQ(restored.hash(), world.hash());
    steps(restored, 500);
    steps(world, 500);
    EXPECT_EQ(restored.hash(), world.hash());
}

TEST(World, CountsNoContactTwiceWhenItIsRebuilt) {
    World world = std::move(*World::create(tests::crowd(40), 2));
    Snapshot before, after;
    while (world.tick() % keyframe_ticks != keyframe_ticks - 1 || world.tick() < 3 * keyframe_ticks) world.step();
    world.capture(before);
    steps(world, 3);  // past the keyframe: 40 vehicles have many contacts, but few new ones in three ticks
    world.capture(after);
    EXPECT_LE(after.events.contacts - before.events.contacts, 6);
}

}  // namespace
}  // namespace braitenlab::tests::checkpoint_test
