// Place memory: position, number and lifetime of the marks.
#include <cmath>

#include "tests/core/runs.h"
#include "tests/core/scenes.h"

namespace braitenlab::tests::memory_test {
namespace {

using namespace world;
using tests::after;
using tests::alone;
using tests::look;
using tests::make;

// Drives into the wall at x = 3, its front half a metre ahead.
Scene at_the_wall(PlaceMemory memory) {
    Scene scene = alone({.LM = 0.5f, .RM = 0.5f}, 1, 0.25f, 0);
    scene.arena.width = 6;
    scene.kinds[0].memory = memory;
    return scene;
}

TEST(World, PlaceMemoryAddsAMarkWhereAVehicleTouchesAWall) {
    World world = make(at_the_wall({.marks = 5, .fade = 20, .strength = 0.7f}));
    EXPECT_TRUE(look(world).marks.empty());
    const Snapshot now = after(world, 3);
    ASSERT_EQ(now.marks.size(), 1u) << "one long contact is one mark";
    EXPECT_EQ(now.marks[0].owner, now.vehicles[0].id);
    EXPECT_NEAR(now.marks[0].x, 3, 0.05f);
    EXPECT_NEAR(now.marks[0].y, 0.25f, 0.4f);
    EXPECT_NEAR(now.marks[0].strength, 0.7f, 1e-2f) << "a mark keeps its strength during the contact";
}

TEST(World, PlaceMemoryHasNoMarksForAKindWithoutMemory) {
    World world = make(at_the_wall({.marks = 0}));
    EXPECT_TRUE(after(world, 3).marks.empty());
}

TEST(World, PlaceMemoryHalvesAMarkPerHalfLifeAndRemovesItAfterSeven) {
    World world = make(at_the_wall({.marks = 5, .fade = 2, .strength = 0.8f}));
    after(world, 3);
    ASSERT_FALSE(world.apply(MoveVehicle{0, 0, 0, 0}));
    ASSERT_FALSE(world.apply(ChooseDriver{0, Driver::parked}));
    Snapshot now = after(world, 2);
    ASSERT_EQ(now.marks.size(), 1u);
    EXPECT_NEAR(now.marks[0].strength, 0.4f, 1e-2f);
    EXPECT_EQ(after(world, 11).marks.size(), 1u);
    EXPECT_EQ(after(world, 3).marks.size(), 0u);
}

TEST(World, PlaceMemoryKeepsTheNewestMarksHalfAMetreApart) {
    Scene scene = at_the_wall({.marks = 3, .fade = 1000});
    scene.arena.height = 40;
    World world = make(scene);
    std::vector<float> met;
    for (int i = 0; i < 6; ++i) {
        const float y = static_cast<float>(i) * 3 - 8;
        ASSERT_FALSE(world.apply(MoveVehicle{0, 2.3f, y, 0}));
        after(world, 1);
        met.push_back(y);
    }
    Snapshot now = look(world);
    ASSERT_EQ(now.marks.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(now.marks[i].y, met[3 + i], 0.4f) << "sorted from the oldest";
    // Back at the oldest mark: it is renewed and moves to the end.
    ASSERT_FALSE(world.apply(MoveVehicle{0, 2.3f, met[3], 0}));
    now = after(world, 1);
    ASSERT_EQ(now.marks.size(), 3u);
    EXPECT_NEAR(now.marks[2].y, met[3], 0.4f);
    EXPECT_NEAR(now.marks[0].y, met[4], 0.4f);
}

TEST(World, PlaceMemoryHasMarksCloserTogetherOnATable) {
    const auto marks_on = [](float height) {
        Scene scene = at_the_wall({.marks = 9});
        scene.arena.width = 6, scene.arena.height = height;
        Body& body = scene.kinds[0].body;
        body = resized(body, 0.1f, 0.07f);
        body.mass = 0.2f;
        World world = make(scene);
        for (const float y : {-0.3f, 0.0f, 0.3f}) {
            EXPECT_FALSE(world.apply(MoveVehicle{0, 2.9f, y, 0}));
            after(world, 1);
        }
        return look(world).marks.size();
    };
    EXPECT_EQ(marks_on(6), 2u) << "0 and 0.3 m are closer than 0.5 m to a mark";
    EXPECT_EQ(marks_on(1), 3u) << "0.1 m where the arena has 1 m";
}

TEST(World, PlaceMemoryIsRemovedWithItsVehicle) {
    Scene scene = at_the_wall({.marks = 3});
    scene.starts.push_back({.name = "other", .kind = "tester", .x = 1, .y = -1.5f});
    scene.starts.push_back({.name = "third", .kind = "tester", .x = 1, .y = 1.75f});
    World world = make(scene);
    ASSERT_EQ(after(world, 3).marks.size(), 3u);
    ASSERT_FALSE(world.apply(RemoveVehicle{1}));
    const Snapshot now = look(world);
    ASSERT_EQ(now.marks.size(), 2u);
    EXPECT_EQ(now.marks[0].owner, 0);
    EXPECT_EQ(now.marks[1].owner, 2);
}

TEST(World, PlaceMemoryContinuesExactlyInARestoredRun) {
    Scene scene = tests::crowd(30);
    scene.arena.width = scene.arena.height = 14;
    for (Kind& kind : scene.kinds) kind.memory = {.marks = 6, .fade = 3};
    World world = make(scene);
    after(world, 8.3);
    EXPECT_GT(look(world).marks.size(), 5u);
    World restored = World::restore(world.checkpoint());
    after(world, 7), after(restored, 7);
    EXPECT_EQ(world.hash(), restored.hash());
}

}  // namespace
}  // namespace braitenlab::tests::memory_test
