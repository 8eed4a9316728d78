// What one sensor makes of one stimulus.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/maths/angle.h"
#include "core/maths/vec.h"
#include "core/scene/scene.h"

namespace braitenlab {

// A sensor with everything worked out that does not change from tick to tick.
//
// One test serves all shapes, without a branch: of a way d from the eye, with `along` its part along the axis,
//     |d| <= range,  along >= cos_half_field · |d|,  along <= reach.
// The cosine falls from the axis to 180 degrees, so this is right for a sector of any field. A triangle is the part of
// its sector before the chord; an omni eye asks nothing of the direction.
struct Eye {
    explicit Eye(const Sensor&);

    Channel channel;
    SensorShape shape;
    SensorResponse response;
    maths::vec2 mount, axis;  // in the vehicle's frame
    maths::vec2 left_arm, right_arm;
    float cos_half_field;  // below −1 for omni
    float reach;           // m along the axis; of a triangle to its chord, else without limit
    float least_cosine;    // what off-axis counts at least: 0, or 1 for omni, which has no axis
    float range, range_squared;
    float inverse_range_squared, inverse_half_distance_squared;
    float noise;              // standard deviation
    std::uint32_t late;       // ticks until the brain gets a reading
    bool is_lit;              // the arena's ambient light reaches it
    bool obstacles_may_hide;  // what it looks for
};

// How many ticks late a sensor's readings are.
std::uint32_t ticks_late(const Sensor&);

// An eye where its vehicle has carried it: world coordinates.
struct Gaze {
    maths::vec2 from, axis, left_arm, right_arm;
};
inline Gaze carry(const Eye& eye, maths::vec2 place, maths::vec2 ahead) {
    return {place + maths::rotate(eye.mount, ahead), maths::rotate(eye.axis, ahead), maths::rotate(eye.left_arm, ahead),
            maths::rotate(eye.right_arm, ahead)};
}

// Whether the point lies in the eye's field: a sector (right beyond 180 degrees too), a triangle or the whole circle.
// What lies on the rim belongs to it.
bool in_field(const Eye&, const Gaze&, maths::vec2 point);

// 0..strength. Boolean eyes give the strength of whatever is in the field; graded ones
//     strength · max(0, cos off-axis) · 1/(1 + (d/d0)^2) · (1 − (d/range)^2)^2,   0 beyond the range,
// where an omni eye, having no axis, leaves the cosine out.
float answer(const Eye&, const Gaze&, maths::vec2 point, float strength);

// The same for a point known to be in the field: `distance` away, squared, and so far along the axis.
inline float graded(const Eye& eye, float squared, float distance, float along, float strength) {
    const float fade = 1 - squared * eye.inverse_range_squared;
    const float off_axis = std::max(along, eye.least_cosine * distance);  // the cosine, times the distance
    const float near = strength * off_axis * fade * fade;
    const float far = distance * (1 + squared * eye.inverse_half_distance_squared);
    return distance > 0 ? near / far : strength;
}

// A rectangle along the axes of the world that holds the eye's whole field.
struct Bounds {
    maths::vec2 low, high;
};
inline Bounds bounds_of(const Eye& eye, const Gaze& gaze) {
    // How far the field stretches in the direction whose parts of axis and arms these are: to its range if the
    // direction lies in it, else to the end of an arm, or not at all.
    constexpr float rounding = 1.0001f;
    const auto stretch = [&](float axis, float left, float right) {
        const float share = axis >= eye.cos_half_field ? 1.0f : std::max({0.0f, left, right});
        return share * eye.range * rounding;
    };
    return {{gaze.from.x - stretch(-gaze.axis.x, -gaze.left_arm.x, -gaze.right_arm.x),
             gaze.from.y - stretch(-gaze.axis.y, -gaze.left_arm.y, -gaze.right_arm.y)},
            {gaze.from.x + stretch(gaze.axis.x, gaze.left_arm.x, gaze.right_arm.x),
             gaze.from.y + stretch(gaze.axis.y, gaze.left_arm.y, gaze.right_arm.y)}};
}

}  // namespace braitenlab
