// The single rigid body of a vehicle, compared with a chassis and four wheels as five bodies.
#include "tests/five_bodies.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "core/world/world.h"
#include "tests/core/scenes.h"

namespace braitenlab::tests::five_bodies_test {
namespace {

using namespace world;
// Motor commands, 1.25 s each: five seconds in total.
using Drive = std::array<std::array<float, 2>, 4>;

const std::array<Drive, 10> drives{{
    {{{0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.5f}}},      // straight on
    {{{1, 1}, {1, 1}, {0, 0}, {0, 0}}},                              // full speed, then brake
    {{{-0.6f, -0.6f}, {-0.6f, -0.6f}, {0.4f, 0.4f}, {0.4f, 0.4f}}},  // back and forth
    {{{0.3f, 0.5f}, {0.3f, 0.5f}, {0.3f, 0.5f}, {0.3f, 0.5f}}},      // a wide circle
    {{{0.5f, 0.1f}, {0.5f, 0.1f}, {0.5f, 0.1f}, {0.5f, 0.1f}}},      // a tight one
    {{{0.2f, 0.7f}, {0.7f, 0.2f}, {0.2f, 0.7f}, {0.7f, 0.2f}}},      // a slalom
    {{{-0.2f, 0.2f}, {0.6f, 0.6f}, {0.3f, -0.3f}, {0.6f, 0.6f}}},    // turns on the spot between legs
    {{{1, 0.6f}, {1, 0.6f}, {0.6f, 1}, {0.6f, 1}}},                  // fast enough to slide
    {{{0.8f, 0}, {0.8f, 0.8f}, {0, 0.8f}, {-0.5f, -0.5f}}},          // about one wheel, then the other
    {{{-0.7f, -0.4f}, {-0.4f, -0.7f}, {0.9f, 0.9f}, {0.1f, 0.4f}}},  // backwards in curves
}};
constexpr int ticks_a_leg = 75;

// The differences between one body and five bodies after the same commands.
struct Gap {
    float position = 0, heading = 0, path = 0;  // m, rad, m
};

Gap gap_after(const Drive& drive, const Arena& arena) {
    Scene scene = tests::alone({});
    scene.arena = arena;
    scene.kinds[0].driver = Driver::manual;
    World one = std::move(*World::create(scene, 1));
    tests::FiveBodies five(arena);
    five.add(scene.kinds[0].body, {});
    Gap gap;
    Snapshot now;
    one.capture(now);
    for (const auto& [left, right] : drive) {
        EXPECT_FALSE(one.apply(Steer{now.vehicles[0].id, left, right}));
        five.command(0, left, right);
        for (int tick = 0; tick < ticks_a_leg; ++tick) {
            one.step(), five.step();
            const maths::vec2 before{now.vehicles[0].x, now.vehicles[0].y};
            one.capture(now);
            gap.path += maths::distance(before, {now.vehicles[0].x, now.vehicles[0].y});
        }
    }
    const mechanics::Motion end = five.motion(0);
    gap.position = maths::distance(end.position, {now.vehicles[0].x, now.vehicles[0].y});
    gap.heading = std::fabs(maths::wrap_angle(end.heading - now.vehicles[0].heading));
    return gap;
}

Arena floor_with(float friction, float grip) {
    return {.width = 200, .height = 200, .friction = friction, .grip = grip};
}

void expect_the_same_drives(const Arena& arena) {
    for (std::size_t i = 0; i < drives.size(); ++i) {
        const Gap gap = gap_after(drives[i], arena);
        EXPECT_GT(gap.path, 0.3f) << "drive " << i;
        EXPECT_LE(gap.position, 0.05f * gap.path) << "drive " << i;
        EXPECT_LE(maths::degrees(gap.heading), 5) << "drive " << i;
    }
}

TEST(FiveBodies, EndTenDrivesAtThePoseOfOneBody) { expect_the_same_drives(floor_with(40, 1)); }
TEST(FiveBodies, EndTenDrivesAtThePoseOfOneBodyOnIce) { expect_the_same_drives(floor_with(8, 0.1f)); }
TEST(FiveBodies, EndTenDrivesAtThePoseOfOneBodyInSand) { expect_the_same_drives(floor_with(400, 0.6f)); }

TEST(FiveBodies, StopAtAWallAtThePoseOfOneBody) {
    Arena arena = floor_with(40, 1);
    arena.width = arena.height = 8;
    const Gap gap = gap_after(drives[1], arena);  // at full speed into the wall
    EXPECT_GT(gap.path, 3);
    EXPECT_LE(gap.position, 0.05f * gap.path);
    EXPECT_LE(maths::degrees(gap.heading), 5);
}

}  // namespace
}  // namespace braitenlab::tests::five_bodies_test
