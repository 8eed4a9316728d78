// One sensor with all constants precomputed, and its response to one stimulus.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/maths/angle.h"
#include "core/maths/vec.h"
#include "core/mechanics/motion.h"
#include "core/scene/scene.h"

namespace braitenlab::sensing {

// One branch-free test serves all shapes. For a displacement d from the sensor with component `along` on its axis:
//     |d| <= range,  along >= cos_half_field · |d|,  along <= reach.
// The cosine decreases from the axis to 180 degrees, so this holds for a sector of any opening angle. A triangle is the
// part of its sector before the chord; an omni sensor has no condition on the direction.
struct CompiledSensor {
    explicit CompiledSensor(const Sensor&);

    Channel channel;
    SensorShape shape;
    SensorResponse response;
    maths::vec2 mount, axis;  // in the vehicle's frame
    maths::vec2 left_arm, right_arm;
    float cos_half_field;  // below −1 for omni
    float reach;           // m along the axis; for a triangle up to its chord, else unlimited
    float least_cosine;    // lower bound of the off-axis cosine: 0, or 1 for omni, which has no axis
    float range, range_squared;
    float inverse_range_squared;  // of the fade; 0 for a hard range
    float inverse_half_distance_squared;
    float gamma;                        // of a photocell
    float per_lux;                      // light of a photocell per lux: 1 at its half_lux
    float per_candela;                  // strength of a lamp for a photocell per candela: 1 cd at 1 m gives 1 lx
    float gain_spread;                  // readings of each vehicle differ by up to ± this share
    std::vector<ResponsePoint> points;  // of a table
    float noise;                        // standard deviation of a reading
    std::uint32_t delay;                // ticks until the brain receives a reading
    std::uint32_t interval;             // microseconds between two samples; 0: a sample at every tick
    float steps;                        // of the converter; 0: none
    bool sees_ambient_light;            // the arena's ambient light is added to its readings
    bool is_blocked;                    // obstacles hide stimuli of its channel
};

// Latency of a sensor in ticks, rounded.
std::uint32_t delay_ticks(const Sensor&);

// Number of readings that a vehicle keeps for a sensor: the last sample if its interval is longer than a tick, then the
// ring of its latency.
std::uint32_t kept_readings(const Sensor&);

// True if a sensor with this interval takes a sample in the tick: the first tick that begins in an interval. All
// intervals are counted from tick 0, so sensors of equal intervals take their samples together.
bool is_sampled(std::uint32_t interval, std::uint64_t tick);

// What a converter of so many steps makes of a reading (0..1): rounded down to a step, of which the last is 1.
inline float converted(float reading, float steps) {
    return std::min(std::floor(reading * steps), steps - 1) / (steps - 1);
}

// A sensor's position, axis and arms in world coordinates.
struct SensorPose {
    maths::vec2 position, axis, left_arm, right_arm;
};
inline SensorPose sensor_pose(const CompiledSensor& sensor, maths::vec2 vehicle, maths::vec2 ahead) {
    return {vehicle + maths::rotate(sensor.mount, ahead), maths::rotate(sensor.axis, ahead),
            maths::rotate(sensor.left_arm, ahead), maths::rotate(sensor.right_arm, ahead)};
}

// True when the point (m) lies in the sensor's field: a sector (right beyond 180 degrees too), a triangle or the whole
// circle. The border belongs to the field.
bool in_field(const CompiledSensor&, const SensorPose&, maths::vec2 point);

// What one stimulus adds to the sum that total_reading() takes; for the responses graded, boolean and table it is a
// reading, 0..strength. 0 beyond the range. With c = max(0, cos off-axis), 1 for an omni sensor:
//     graded     strength · c / (1 + (d/d0)^2) · (1 − (d/range)^2)^2,   without the last factor for a hard range
//     boolean    strength
//     photocell  strength · c / (d/d0)^2: illuminance (inverse square and cosine law) as a multiple of that at d0;
//                of a lamp of I candela the multiple I·c/d^2 of its half_lux, for the strength of strength_for()
//     table      strength · c · the reading of the table at d
float response_to(const CompiledSensor&, const SensorPose&, maths::vec2 point, float strength);

// The strength of a stimulus for this sensor: that in candela, where it is stated and the sensor is a photocell.
inline float strength_for(const CompiledSensor& sensor, float strength, float candela) {
    const bool is_light = sensor.response == SensorResponse::photocell && candela > 0;
    return is_light ? strength * candela * sensor.per_candela : strength;
}

// The same for a point inside the field: its distance (m), the distance squared, and its distance along the axis.
float response_in_field(const CompiledSensor&, float squared, float distance, float along, float strength);

// Reading of a table at a distance (m): linear between its points, that of the first before it, 0 beyond the last.
float table_reading(const std::vector<ResponsePoint>&, float distance);

// Reading of the sum of all stimuli with ambient light: 0..1, the reading that it gives alone, and lx, which only
// photocells read. A photocell adds light before its curve 1/(1 + E^−γ), the divider of a photoresistor of exponent γ
// and a resistor; other responses add readings.
float total_reading(const CompiledSensor&, float sum, float ambient, float lux = 0);

// The graded response to a point inside the field: its distance (m), the distance squared, and its distance along the
// axis.
inline float graded_response(const CompiledSensor& sensor, float squared, float distance, float along, float strength) {
    const float fade = 1 - squared * sensor.inverse_range_squared;
    const float off_axis = std::max(along, sensor.least_cosine * distance);  // the cosine times the distance
    const float numerator = strength * off_axis * fade * fade;
    const float denominator = distance * (1 + squared * sensor.inverse_half_distance_squared);
    return distance > 0 ? numerator / denominator : strength;
}

// An axis-aligned rectangle in world coordinates that contains the sensor's whole field.
struct Bounds {
    maths::vec2 low, high;
};
inline Bounds bounds_of(const CompiledSensor& sensor, const SensorPose& pose) {
    // Extent of the field in one direction, from the components of axis and arms in it: the range if the direction lies
    // in the field, else the end of an arm, or 0.
    constexpr float rounding = 1.0001f;
    const auto extent = [&](float axis, float left, float right) {
        const float share = axis >= sensor.cos_half_field ? 1.0f : std::max({0.0f, left, right});
        return share * sensor.range * rounding;
    };
    return {{pose.position.x - extent(-pose.axis.x, -pose.left_arm.x, -pose.right_arm.x),
             pose.position.y - extent(-pose.axis.y, -pose.left_arm.y, -pose.right_arm.y)},
            {pose.position.x + extent(pose.axis.x, pose.left_arm.x, pose.right_arm.x),
             pose.position.y + extent(pose.axis.y, pose.left_arm.y, pose.right_arm.y)}};
}

}  // namespace braitenlab::sensing
