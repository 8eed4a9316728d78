#include <gtest/gtest.h>

#include "core/maths/random.h"
#include "core/mechanics/motion.h"
#include "core/mechanics/wheel.h"

namespace braitenlab::mechanics {
namespace {

constexpr float dt = 1.0f / 60;

TEST(Wheel, MotorForceAcceleratesAWheelToItsSpeedInOneTickWithoutOvershoot) {
    const float mass = 5, wanted = 2;
    float speed = 1.9f;
    speed += motor_force(wanted, speed, mass, 1000, dt) / mass * dt;
    EXPECT_NEAR(speed, wanted, 1e-5f);
    EXPECT_EQ(motor_force(wanted, 0, mass, 24, dt), 24) << "no more than the motor can";
    EXPECT_EQ(motor_force(-wanted, 0, mass, 24, dt), -24);
}

TEST(Wheel, LateralGripStopsASlideInOneTick) {
    const float mass = 5;
    float speed = -0.7f;
    speed += lateral_grip(speed, mass, dt) / mass * dt;
    EXPECT_NEAR(speed, 0, 1e-6f);
}

TEST(Wheel, FrictionLimitsTheSizeOfAForceAndKeepsItsDirection) {
    const maths::vec2 limited = limit_to_friction({30, 40}, 10);
    EXPECT_FLOAT_EQ(limited.x, 6);
    EXPECT_FLOAT_EQ(limited.y, 8);
    EXPECT_EQ(limit_to_friction({3, 4}, 10), (maths::vec2{3, 4}));
}

TEST(Wheel, RollingDragNeverAddsEnergy) {
    maths::Random chance{1, 1};
    for (int i = 0; i < 1000; ++i) {
        const maths::vec2 v{chance.uniform(-5, 5), chance.uniform(-5, 5)};
        EXPECT_LE(maths::dot(rolling_drag(v, chance.uniform(0, 100), chance.uniform(0, 0.1f), 5, dt), v), 0);
    }
}

TEST(Wheel, DifferentialDriveConvertsInBothDirections) {
    maths::Random chance{2, 1};
    for (int i = 0; i < 1000; ++i) {
        const float left = chance.uniform(-3, 3), right = chance.uniform(-3, 3), track = chance.uniform(0.1f, 2);
        const WheelSpeeds back = wheels_of_drive(drive_of_wheels(left, right, track), track);
        EXPECT_NEAR(back.left, left, 1e-5f);
        EXPECT_NEAR(back.right, right, 1e-5f);
    }
    EXPECT_GT(drive_of_wheels(1, 2, 0.5f).turning, 0) << "a faster right wheel turns left, counter-clockwise";
}

TEST(Motion, SemiImplicitEulerKeepsTheEnergyOfASpring) {
    float place = 1, speed = 0;
    for (int i = 0; i < 60 * 60; ++i) integrate(place, speed, -10 * place, dt);
    EXPECT_NEAR(0.5f * speed * speed + 5 * place * place, 5, 0.8f);
}

TEST(Motion, SemiImplicitEulerAgreesWithTheFormulaOfAFreeFall) {
    float place = 0, speed = 0;
    for (int i = 0; i < 60; ++i) integrate(place, speed, gravity, dt);
    EXPECT_NEAR(speed, gravity, 1e-3f);
    EXPECT_NEAR(place, gravity / 2 * (1 + dt), 1e-3f);
}

}  // namespace
}  // namespace braitenlab::mechanics
