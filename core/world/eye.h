// What one sensor makes of one stimulus.
#pragma once

#include <span>
#include <vector>

#include "core/maths/vec.h"
#include "core/scene/scene.h"

namespace braitenlab {

// A sensor with everything worked out that does not change from tick to tick.
struct Eye {
    explicit Eye(const Sensor&);

    Channel channel;
    SensorShape shape;
    SensorResponse response;
    maths::vec2 mount, axis;  // in the vehicle's frame
    maths::vec2 left_arm, right_arm;
    float cos_half_field;
    float range, range_squared, half_distance_squared;
};

// An eye where its vehicle has carried it: world coordinates.
struct Gaze {
    maths::vec2 from, axis, left_arm, right_arm;
};
Gaze carry(const Eye&, maths::vec2 place, maths::vec2 ahead);

// Whether the point lies in the eye's field: a sector (right beyond 180 degrees too), a triangle or the whole circle.
bool in_field(const Eye&, const Gaze&, maths::vec2 point);

// 0..strength. Boolean eyes give the strength of whatever is in the field; graded ones
//     strength · max(0, cos off-axis) · 1/(1 + (d/d0)^2) · (1 − (d/range)^2)^2,   0 beyond the range,
// where an omni eye, having no axis, leaves the cosine out.
float answer(const Eye&, const Gaze&, maths::vec2 point, float strength);

// A closed outline that can be sensed by its nearest visible point: a wall is one segment, a box four.
struct Outline {
    std::vector<maths::vec2> corners;  // two: a segment; more: a loop
};

// The answer to the outline's nearest point inside the field; 0 when no part of it lies there.
float answer_to_outline(const Eye&, const Gaze&, const Outline&);

}  // namespace braitenlab
