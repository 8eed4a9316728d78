#include "core/scene/driven_wheels.h"

#include <gtest/gtest.h>

namespace braitenlab::tests::driven_wheels_test {
namespace {

// Two driven wheels 0.4 m apart and a castor further out.
Body with_castor() {
    Body body;
    body.wheels = {Wheel{.x = 0, .y = 0.2f, .radius = 0.1f, .motor = Motor::left},
                   Wheel{.x = 0, .y = -0.2f, .radius = 0.08f, .motor = Motor::right},
                   Wheel{.x = 0.3f, .y = 0.5f, .radius = 0.3f, .motor = Motor::none}};
    return body;
}

TEST(DrivenWheels, AreMeasuredWithoutCastors) {
    const DrivenWheels driven = driven_wheels(with_castor());
    EXPECT_FLOAT_EQ(driven.track, 0.4f);
    EXPECT_FLOAT_EQ(driven.radius, 0.1f);
}

TEST(DrivenWheels, AreMovedAndScaledInProportionAndTheCastorStays) {
    const Body to = with_driven_wheels(with_castor(), {0.6f, 0.2f});
    EXPECT_FLOAT_EQ(to.wheels[0].y, 0.3f);
    EXPECT_FLOAT_EQ(to.wheels[1].y, -0.3f);
    EXPECT_FLOAT_EQ(to.wheels[0].radius, 0.2f);
    EXPECT_FLOAT_EQ(to.wheels[1].radius, 0.16f);
    EXPECT_EQ(to.wheels[2], with_castor().wheels[2]);
}

TEST(DrivenWheels, StayInTheRangesOfAWheel) {
    const Body to = with_driven_wheels(with_castor(), {100, 100});
    EXPECT_FLOAT_EQ(to.wheels[0].y, 10);
    EXPECT_FLOAT_EQ(to.wheels[1].radius, 5);
    EXPECT_FLOAT_EQ(with_driven_wheels(with_castor(), {0.4f, 0.0001f}).wheels[0].radius, 0.005f);
}

TEST(DrivenWheels, OfABodyWithoutMotorsHaveNoTrackAndNoRadius) {
    Body body = with_castor();
    for (Wheel& wheel : body.wheels) wheel.motor = Motor::none;
    const DrivenWheels driven = driven_wheels(body);
    EXPECT_EQ(driven.track, 0);
    EXPECT_EQ(driven.radius, 0);
    EXPECT_EQ(with_driven_wheels(body, {1, 1}).wheels, body.wheels);
}

}  // namespace
}  // namespace braitenlab::tests::driven_wheels_test
