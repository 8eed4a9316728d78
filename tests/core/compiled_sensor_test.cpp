#include "core/sensing/compiled_sensor.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/maths/angle.h"
#include "core/maths/geometry.h"
#include "tests/core/chance.h"
#include "tests/response_law.h"

namespace braitenlab::tests::compiled_sensor_test {
namespace {

using namespace sensing;
using maths::vec2;
using tests::Chance;

// The angle of a point from the axis in rad and its distance in m, computed independently of CompiledSensor.
struct Polar {
    double off_axis, distance;
};
Polar seen_from(const Sensor& sensor, const Pose& pose, vec2 point) {
    const double h = pose.heading, x = pose.x + std::cos(h) * sensor.x - std::sin(h) * sensor.y,
                 y = pose.y + std::sin(h) * sensor.x + std::cos(h) * sensor.y;
    const double dx = point.x - x, dy = point.y - y;
    return {std::fabs(std::remainder(std::atan2(dy, dx) - h - sensor.angle, 2 * maths::pi_d)), std::hypot(dx, dy)};
}

TEST(CompiledSensor, AgreesWithAnglesAndDistancesForASectorAndACircle) {
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
            std::min(std::fabs(at.distance - sensor.range), omni ? 1 : std::fabs(at.off_axis - sensor.fov / 2));
        if (to_rim < 1e-4) continue;  // rounding decides here
        const bool expected = at.distance < sensor.range && (omni || at.off_axis < sensor.fov / 2);
        const CompiledSensor compiled(sensor);
        ASSERT_EQ(in_field(compiled, sensor_pose(compiled, {pose.x, pose.y}, maths::direction(pose.heading)), point),
                  expected)
            << i;
        inside += expected, ++asked;
    }
    EXPECT_GT(inside, asked / 10);
    EXPECT_LT(inside, asked * 9 / 10);
}

TEST(CompiledSensor, AgreesWithBarycentricCoordinatesForATriangle) {
    Chance chance(2);
    int inside = 0;
    for (int i = 0; i < 20000; ++i) {
        Sensor sensor = chance.sensor();
        sensor.shape = SensorShape::triangle;
        sensor.fov = chance.number(0.05f, 3.1f);
        const Pose pose = chance.pose();
        const CompiledSensor compiled(sensor);
        const SensorPose placed = sensor_pose(compiled, {pose.x, pose.y}, maths::direction(pose.heading));
        const vec2 point = placed.position + maths::rotate(chance.place(sensor.range), placed.axis);
        const vec2 right = placed.position + placed.right_arm * sensor.range,
                   left = placed.position + placed.left_arm * sensor.range;
        const maths::vec3 share = maths::barycentric(point, placed.position, right, left);
        if (std::fabs(std::min({share.x, share.y, share.z})) < 1e-3f) continue;
        const bool expected = maths::in_triangle(point, placed.position, right, left);
        ASSERT_EQ(in_field(compiled, placed, point), expected) << i;
        inside += expected;
    }
    EXPECT_GT(inside, 1000);
}

TEST(CompiledSensor, FollowsTheGradedFormulaInsideItsFieldAndReadsZeroOutside) {
    Chance chance(3);
    for (int i = 0; i < 20000; ++i) {
        const Sensor sensor = chance.sensor();
        const Pose pose = chance.pose();
        const vec2 point = chance.place(10);
        const float strength = chance.number(0, 1);
        const CompiledSensor compiled(sensor);
        const SensorPose placed = sensor_pose(compiled, {pose.x, pose.y}, maths::direction(pose.heading));
        const Polar at = seen_from(sensor, pose, point);
        double expected = strength;
        if (sensor.response == SensorResponse::graded) {
            const double cosine = sensor.shape == SensorShape::omni ? 1 : std::max(0.0, std::cos(at.off_axis));
            expected = strength * cosine * reading_at(at.distance, sensor.half_distance, sensor.range);
        }
        if (!in_field(compiled, placed, point)) expected = 0;
        ASSERT_NEAR(response_to(compiled, placed, point, strength), expected, 1e-5) << i;
    }
}

TEST(CompiledSensor, ReadsOneAtItsPosition) {
    for (const SensorShape shape : {SensorShape::sector, SensorShape::triangle, SensorShape::omni}) {
        const CompiledSensor compiled({.shape = shape, .x = 0});
        EXPECT_EQ(response_to(compiled, sensor_pose(compiled, {2, 1}, {1, 0}), {2, 1}, 0.7f), 0.7f);
    }
}

TEST(CompiledSensor, HasBoundsThatContainItsField) {
    Chance chance(4);
    int inside = 0;
    for (int i = 0; i < 20000; ++i) {
        const CompiledSensor compiled(chance.sensor());
        const Pose pose = chance.pose();
        const SensorPose placed = sensor_pose(compiled, {pose.x, pose.y}, maths::direction(pose.heading));
        const Bounds bounds = bounds_of(compiled, placed);
        const vec2 p = placed.position + chance.place(compiled.range);
        if (!in_field(compiled, placed, p)) continue;
        ++inside;
        ASSERT_TRUE(p.x >= bounds.low.x && p.x <= bounds.high.x && p.y >= bounds.low.y && p.y <= bounds.high.y) << i;
    }
    EXPECT_GT(inside, 2000);
}

TEST(CompiledSensor, HasBoundsNoWiderThanItsField) {
    const CompiledSensor compiled({.x = 0, .fov = maths::radians(60), .range = 6});
    const Bounds bounds = bounds_of(compiled, sensor_pose(compiled, {0, 0}, {1, 0}));
    EXPECT_NEAR(bounds.low.x, 0, 1e-3);
    EXPECT_NEAR(bounds.high.x, 6, 1e-2);
    EXPECT_NEAR(bounds.high.y, 3, 1e-2);
}

}  // namespace
}  // namespace braitenlab::tests::compiled_sensor_test
