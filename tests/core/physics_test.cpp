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
        EXPECT_EQ(now.ahead, maths::direction(now.heading)) << heading;
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

TEST(Physics, ATurningObstacleKeepsItsHeadingWithinOneTurn) {
    Scene scene;
    Obstacle board;
    board.mass = 1;
    scene.obstacles = {board};
    mechanics::Motion motion = mechanics::at_rest({}, 1e6f);
    motion.angular_velocity = 40;
    Physics physics(scene, {motion});
    std::vector<Touch> touching, begun;
    float turned = 0, before = physics.obstacle(0).heading;
    for (int tick = 0; tick < 120; ++tick) {
        physics.step(touching, begun);
        const mechanics::Motion now = physics.obstacle(0);
        EXPECT_LE(std::fabs(now.heading), maths::pi);
        EXPECT_EQ(now.ahead, maths::direction(now.heading));
        turned += maths::wrap_angle(now.heading - before);
        before = now.heading;
    }
    EXPECT_NEAR(turned, 40.0f / 3, 0.3f);  // its damping is 3/s
}

// A vehicle that swings to and fro while it is pressed on the right post, or, turned by 180°, on the left one.
class Pressed {
public:
    explicit Pressed(float side) : side_(side), physics_(posts(), {}) {
        physics_.add(0, 0, Body{}, mechanics::at_rest({side * 1.3f, 0}, side > 0 ? 0 : maths::pi));
    }
    void step(float torque) {
        physics_.push(0, {side_ * 5, 0}, torque);
        physics_.step(touching, begun);
        now = physics_.motion(0);
    }
    std::vector<Touch> touching, begun;
    mechanics::Motion now;

private:
    static Scene posts() {
        Scene scene;
        for (const float side : {1.0f, -1.0f})
            scene.sources.push_back({.name = side > 0 ? "right" : "left", .x = 2 * side, .solid = true});
        return scene;
    }
    float side_;
    Physics physics_;
};

TEST(Physics, AVehicleAtAPostPassesTheHeadingPiAsItPassesZero) {
    Pressed right(1), left(-1);
    int passages = 0;
    for (int tick = 0; tick < 120; ++tick) {
        const float before = left.now.heading, torque = (tick + 4) / 8 % 2 == 0 ? 2.0f : -2.0f;
        right.step(torque), left.step(torque);
        passages += before * left.now.heading < 0;
        EXPECT_EQ(left.touching, right.touching) << tick;
        EXPECT_EQ(left.begun, right.begun) << tick;
        EXPECT_NEAR(left.now.position.x, -right.now.position.x, 2e-6f) << tick;
        EXPECT_NEAR(left.now.angular_velocity, right.now.angular_velocity, 1e-4f) << tick;
    }
    EXPECT_FALSE(right.touching.empty());
    EXPECT_GT(passages, 3);
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
