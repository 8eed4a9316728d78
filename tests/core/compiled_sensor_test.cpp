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

// The reading of one stimulus of strength 1 at a distance straight ahead.
float reading_of(const Sensor& sensor, float distance, float ambient = 0) {
    const CompiledSensor compiled(sensor);
    const SensorPose placed = sensor_pose(compiled, {0, 0}, {1, 0});
    return total_reading(compiled, response_to(compiled, placed, {distance, 0}, 1), ambient);
}

TEST(CompiledSensor, WithAHardRangeDoesNotFadeTowardsIt) {
    const Sensor hard{.x = 0, .range = 4, .half_distance = 3, .hard_range = true};
    for (const float d : {0.5f, 2.0f, 3.0f, 3.999f}) EXPECT_NEAR(reading_of(hard, d), 1 / (1 + d * d / 9), 1e-6f) << d;
    EXPECT_EQ(reading_of(hard, 4.001f), 0);
}

TEST(CompiledSensor, ReadsAsThePhotoresistorDividerThatItStandsFor) {
    // A GL5528 (γ 0.7, 15 kΩ at 10 lx) over 1.5 kΩ, and a lamp of 63.7 cd: half scale at 268 lx, so at 0.4874 m.
    const double gamma = 0.7, r10 = 15e3, over = 1.5e3, candela = 63.7;
    const double half = 10 * std::pow(r10 / over, 1 / gamma);
    EXPECT_NEAR(half, 268, 1);
    const Sensor eye{.response = SensorResponse::photocell,
                     .x = 0,
                     .range = 20,
                     .half_distance = static_cast<float>(std::sqrt(candela / half)),
                     .gamma = 0.7f};
    for (const double d : {0.1, 0.4874, 1.0, 3.0}) {
        const double lux = candela / (d * d), ldr = r10 * std::pow(lux / 10, -gamma);
        EXPECT_NEAR(reading_of(eye, static_cast<float>(d)), over / (over + ldr), 1e-5) << d;
    }
    EXPECT_NEAR(reading_of(eye, 0), 1, 1e-6f);
    EXPECT_EQ(reading_of(eye, 20.1f), 0);
}

TEST(CompiledSensor, AddsLightBeforeTheCurveOfAPhotocell) {
    const Sensor eye{.response = SensorResponse::photocell, .x = 0, .half_distance = 2, .gamma = 0.7f};
    const CompiledSensor compiled(eye);
    EXPECT_NEAR(total_reading(compiled, 0, 0.3f), 0.3f, 1e-6f) << "ambient light alone";
    EXPECT_EQ(total_reading(compiled, 0, 0), 0);
    EXPECT_NEAR(total_reading(compiled, 1, 0), 0.5f, 1e-6f);
    EXPECT_NEAR(total_reading(compiled, 1, 0.5f), total_reading(compiled, 2, 0), 1e-6f) << "two equal lights";
    EXPECT_LT(total_reading(compiled, 1, 0.5f), 0.65f) << "readings are not added";
    EXPECT_EQ(total_reading(compiled, 5, 1), 1);
    EXPECT_NEAR(total_reading(CompiledSensor({.x = 0}), 0.4f, 0.3f), 0.7f, 1e-6f) << "of a graded sensor they are";
}

TEST(CompiledSensor, ReadsItsTableLinearlyBetweenThePoints) {
    const Sensor eye{
        .response = SensorResponse::table, .x = 0, .range = 5, .points = {{1, 0.9f}, {2, 0.5f}, {4, 0.1f}}};
    EXPECT_EQ(reading_of(eye, 0.2f), 0.9f);
    EXPECT_EQ(reading_of(eye, 1), 0.9f);
    EXPECT_NEAR(reading_of(eye, 1.25f), 0.8f, 1e-6f);
    EXPECT_NEAR(reading_of(eye, 2), 0.5f, 1e-6f);
    EXPECT_NEAR(reading_of(eye, 3), 0.3f, 1e-6f);
    EXPECT_NEAR(reading_of(eye, 4), 0.1f, 1e-6f);
    EXPECT_EQ(reading_of(eye, 4.01f), 0);
    const CompiledSensor compiled(eye);
    const SensorPose placed = sensor_pose(compiled, {0, 0}, {1, 0});
    EXPECT_NEAR(response_to(compiled, placed, maths::from_polar(2, 0.5f), 0.6f), 0.6f * std::cos(0.5f) * 0.5f, 1e-5f);
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
