#include "core/world/eye.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/maths/angle.h"
#include "core/maths/geometry.h"
#include "tests/core/chance.h"

namespace braitenlab::tests::eye_test {
namespace {

using maths::vec2;
using tests::Chance;

// How far off the axis a point lies, in rad, and how far away, in m: worked out in another way than the eye does.
struct Polar {
    double off_axis, distance;
};
Polar seen_from(const Sensor& sensor, const Pose& pose, vec2 point) {
    const double h = pose.heading, x = pose.x + std::cos(h) * sensor.x - std::sin(h) * sensor.y,
                 y = pose.y + std::sin(h) * sensor.x + std::cos(h) * sensor.y;
    const double dx = point.x - x, dy = point.y - y;
    return {std::fabs(std::remainder(std::atan2(dy, dx) - h - sensor.angle, 2 * maths::pi_d)), std::hypot(dx, dy)};
}

TEST(Eye, SeesOfASectorOrTheWholeCircleWhatAnglesAndDistancesSayItShould) {
    Chance chance(1);
    int inside = 0, asked = 0;
    for (int i = 0; i < 20000; ++i) {
        Sensor sensor = chance.sensor();
        if (sensor.shape == SensorShape::triangle) sensor.shape = SensorShape::sector;
        const Pose pose = chance.pose();
        const vec2 point = chance.place(12);
        const Polar at = seen_from(sensor, pose, point);
        const bool omni = sensor.shape == SensorShape::omni;
        const double to_rim =
            std::min(std::fabs(at.distance - sensor.range), omni ? 1 : std::fabs(at.off_axis - sensor.field / 2));
        if (to_rim < 1e-4) continue;  // a rounding either way
        const bool expected = at.distance < sensor.range && (omni || at.off_axis < sensor.field / 2);
        const Eye eye(sensor);
        ASSERT_EQ(in_field(eye, carry(eye, {pose.x, pose.y}, maths::direction(pose.heading)), point), expected) << i;
        inside += expected, ++asked;
    }
    EXPECT_GT(inside, asked / 10);
    EXPECT_LT(inside, asked * 9 / 10);
}

TEST(Eye, SeesOfATriangleWhatBarycentricCoordinatesSayItShould) {
    Chance chance(2);
    int inside = 0;
    for (int i = 0; i < 20000; ++i) {
        Sensor sensor = chance.sensor();
        sensor.shape = SensorShape::triangle;
        sensor.field = chance.number(0.05f, 3.1f);
        const Pose pose = chance.pose();
        const Eye eye(sensor);
        const Gaze gaze = carry(eye, {pose.x, pose.y}, maths::direction(pose.heading));
        const vec2 point = gaze.from + maths::rotate(chance.place(sensor.range), gaze.axis);
        const vec2 right = gaze.from + gaze.right_arm * sensor.range, left = gaze.from + gaze.left_arm * sensor.range;
        const maths::vec3 share = maths::barycentric(point, gaze.from, right, left);
        if (std::fabs(std::min({share.x, share.y, share.z})) < 1e-3f) continue;
        const bool expected = maths::in_triangle(point, gaze.from, right, left);
        ASSERT_EQ(in_field(eye, gaze, point), expected) << i;
        inside += expected;
    }
    EXPECT_GT(inside, 1000);
}

TEST(Eye, AnswersByTheGradedFormulaInsideItsFieldAndNotAtAllOutside) {
    Chance chance(3);
    for (int i = 0; i < 20000; ++i) {
        const Sensor sensor = chance.sensor();
        const Pose pose = chance.pose();
        const vec2 point = chance.place(10);
        const float strength = chance.number(0, 1);
        const Eye eye(sensor);
        const Gaze gaze = carry(eye, {pose.x, pose.y}, maths::direction(pose.heading));
        const Polar at = seen_from(sensor, pose, point);
        double expected = strength;
        if (sensor.response == SensorResponse::graded) {
            const double d0 = at.distance / sensor.half_distance, r = at.distance / sensor.range;
            const double cosine = sensor.shape == SensorShape::omni ? 1 : std::max(0.0, std::cos(at.off_axis));
            expected = strength * cosine / (1 + d0 * d0) * (1 - r * r) * (1 - r * r);
        }
        if (!in_field(eye, gaze, point)) expected = 0;
        ASSERT_NEAR(answer(eye, gaze, point, strength), expected, 1e-5) << i;
    }
}

TEST(Eye, AnswersInFullToWhatSitsOnIt) {
    for (const SensorShape shape : {SensorShape::sector, SensorShape::triangle, SensorShape::omni}) {
        const Eye eye({.shape = shape, .x = 0});
        EXPECT_EQ(answer(eye, carry(eye, {2, 1}, {1, 0}), {2, 1}, 0.7f), 0.7f);
    }
}

TEST(Eye, HasItsWholeFieldWithinItsBounds) {
    Chance chance(4);
    int inside = 0;
    for (int i = 0; i < 20000; ++i) {
        const Eye eye(chance.sensor());
        const Pose pose = chance.pose();
        const Gaze gaze = carry(eye, {pose.x, pose.y}, maths::direction(pose.heading));
        const Bounds bounds = bounds_of(eye, gaze);
        const vec2 p = gaze.from + chance.place(eye.range);
        if (!in_field(eye, gaze, p)) continue;
        ++inside;
        ASSERT_TRUE(p.x >= bounds.low.x && p.x <= bounds.high.x && p.y >= bounds.low.y && p.y <= bounds.high.y) << i;
    }
    EXPECT_GT(inside, 2000);
}

TEST(Eye, HasBoundsNoWiderThanItsField) {
    const Eye eye({.x = 0, .field = maths::radians(60), .range = 6});
    const Bounds bounds = bounds_of(eye, carry(eye, {0, 0}, {1, 0}));
    EXPECT_NEAR(bounds.low.x, 0, 1e-3);
    EXPECT_NEAR(bounds.high.x, 6, 1e-2);
    EXPECT_NEAR(bounds.high.y, 3, 1e-2);
}

}  // namespace
}  // namespace braitenlab::tests::eye_test
