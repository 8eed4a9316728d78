#include "core/world/physics.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include "core/maths/random.h"
#include "tests/core/scenes.h"

namespace braitenlab::tests::physics_test {
namespace {

using namespace world;
TEST(Physics, Box2DUsesThePortableSineAndCosineOnEveryProcessor) {
    const Scene scene;
    maths::Random chance{5, 1};
    for (int i = 0; i < 2000; ++i) {
        Physics physics(scene, {});
        const float heading = chance.uniform(-40, 40);
        physics.add(0, 0, Body{}, mechanics::at_rest({0, 0}, heading));
        const mechanics::Motion now = physics.motion(0);
        EXPECT_EQ(now.ahead, maths::direction(heading)) << heading;
    }
}

TEST(Physics, Box2DLeavesSineAndCosineOfTheProgramExactForLargeAndNonFiniteArguments) {
    for (const float angle : {0.0f, 1e-7f, 3.0f, 12345.6f, 1e5f, 3e8f, 1e30f}) {
        EXPECT_FLOAT_EQ(std::sin(angle), static_cast<float>(std::sin(static_cast<double>(angle)))) << angle;
        EXPECT_FLOAT_EQ(std::cos(-angle), static_cast<float>(std::cos(static_cast<double>(angle)))) << angle;
    }
    EXPECT_TRUE(std::isnan(std::sin(INFINITY)));
    EXPECT_TRUE(std::isnan(std::cos(NAN)));
    EXPECT_TRUE(std::signbit(std::sin(-0.0f)));
}

TEST(Physics, Box2DReadsNoClock) {
    b2World world({0, 0});
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    b2CircleShape shape;
    shape.m_radius = 1;
    for (int body = 0; body < 300; ++body) world.CreateBody(&definition)->CreateFixture(&shape, 1);
    world.Step(tick_seconds, 6, 2);  // takes milliseconds, because all touch each other
    EXPECT_GT(world.GetContactCount(), 1000);
    EXPECT_EQ(world.GetProfile().step, 0);
}

// The position after one second of a vehicle that hits a thin fixed board at x = 1 at top speed. Starts at
// several positions, because a tick can skip an obstacle from some of them.
float farthest_at_full_speed(const Body& body, float board) {
    Scene scene;
    Kind kind;
    kind.name = "racer", kind.body = body;
    scene.kinds = {kind};
    Obstacle obstacle;
    obstacle.x = 1, obstacle.length = board, obstacle.width = 10;
    scene.obstacles = {obstacle};
    float farthest = -100;
    for (int begin = 0; begin < 20; ++begin) {
        Physics physics(scene, {mechanics::at_rest({1, 0}, 0)});
        mechanics::Motion motion = mechanics::at_rest({-1 - 0.01f * static_cast<float>(begin), 0}, 0);
        motion.velocity = {body.top_speed, 0};
        physics.add(0, 0, body, motion);
        std::vector<Touch> touching, begun;
        for (int tick = 0; tick < 60; ++tick) physics.step(touching, begun);
        farthest = std::max(farthest, physics.motion(0).position.x);
    }
    return farthest;
}

TEST(Physics, ImpactsAreDetectedForTheSmallestVehicleAtTopSpeed) {
    Body racer;
    racer.length = racer.width = 0.05f, racer.mass = 0.05f, racer.top_speed = 10;
    racer.wheels.clear();
    EXPECT_LT(farthest_at_full_speed(racer, 0.02f), 1);
}

TEST(Physics, ImpactsStopAStandardVehicleAtAThinBoard) {
    EXPECT_LT(farthest_at_full_speed(Body{}, 0.02f), 1 - 0.5f + 0.02f);
}

// The position at which a vehicle pushed sideways against the wall at y = 2 stops.
float pushed_to_the_wall(const Body& body) {
    Scene scene;
    scene.arena.width = scene.arena.height = 4;
    Physics physics(scene, {});
    physics.add(0, 0, body, mechanics::at_rest({0, 0}, 0));
    std::vector<Touch> touching, begun;
    for (int i = 0; i < 300; ++i) {
        physics.push(0, {0, 20}, 0);
        physics.step(touching, begun);
    }
    EXPECT_FALSE(touching.empty());
    return physics.motion(0).position.y;
}

TEST(Physics, WheelsInsideTheChassisStopAtAWallWithTheChassis) {
    EXPECT_NEAR(pushed_to_the_wall(Body{}), 2 - 0.35f, 0.02f);
}

TEST(Physics, WheelsOutsideTheChassisTouchAWallBeforeTheChassis) {
    Body body;
    for (Wheel& wheel : body.wheels) wheel.y *= 2;  // ±0.6 m, plus 0.05 m of wheel width
    EXPECT_NEAR(pushed_to_the_wall(body), 2 - 0.65f, 0.02f);
}

// Access to a protected static member.
struct ContactTable : b2Contact {
    static bool is_filled() { return s_initialized; }
};

// ctest runs each test in a process of its own, so that this is the first world of the process.
TEST(Physics, FillsTheContactTableBeforeItsFirstStepSoThatThreadsCanStepWorlds) {
    const Physics physics(Scene{}, {});
    EXPECT_TRUE(ContactTable::is_filled());
}

}  // namespace
}  // namespace braitenlab::tests::physics_test
