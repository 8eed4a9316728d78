#include "core/world/eye.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/maths/angle.h"
#include "core/maths/geometry.h"

namespace braitenlab {

using maths::vec2;

Eye::Eye(const Sensor& s)
    : channel(s.channel),
      shape(s.shape),
      response(s.response),
      mount{s.x, s.y},
      axis(maths::direction(s.angle)),
      left_arm(maths::direction(s.angle + s.field / 2)),
      right_arm(maths::direction(s.angle - s.field / 2)),
      cos_half_field(maths::cosine(s.field / 2)),
      range(s.range),
      range_squared(s.range * s.range),
      half_distance_squared(s.half_distance * s.half_distance) {}

Gaze carry(const Eye& eye, vec2 place, vec2 ahead) {
    return {place + maths::rotate(eye.mount, ahead), maths::rotate(eye.axis, ahead), maths::rotate(eye.left_arm, ahead),
            maths::rotate(eye.right_arm, ahead)};
}

bool in_field(const Eye& eye, const Gaze& gaze, vec2 point) {
    const vec2 d = point - gaze.from;
    const float squared = maths::dot(d, d);
    if (squared > eye.range_squared) return false;
    switch (eye.shape) {
        case SensorShape::omni:
            return true;
        case SensorShape::triangle:
            return maths::in_triangle(point, gaze.from, gaze.from + gaze.right_arm * eye.range,
                                      gaze.from + gaze.left_arm * eye.range);
        case SensorShape::sector:
            break;
    }
    // Within half the field of the axis: the cosine falls from the axis to 180 degrees, so this is right for any field.
    return maths::dot(d, gaze.axis) >= eye.cos_half_field * std::sqrt(squared);
}

float answer(const Eye& eye, const Gaze& gaze, vec2 point, float strength) {
    if (!in_field(eye, gaze, point)) return 0;
    if (eye.response == SensorResponse::boolean) return strength;
    const vec2 d = point - gaze.from;
    const float squared = maths::dot(d, d);
    const float off_axis =
        eye.shape == SensorShape::omni || squared == 0 ? 1.0f : maths::dot(d, gaze.axis) / std::sqrt(squared);
    const float fade = 1 - squared / eye.range_squared;
    return strength * std::max(0.0f, off_axis) * fade * fade / (1 + squared / eye.half_distance_squared);
}

namespace {

struct Segment {
    vec2 a, b;
};

// The part of a segment that lies on the left of a line through `from` along `along`.
std::optional<Segment> clip_left_of(Segment s, vec2 from, vec2 along) {
    const float a = maths::cross(along, s.a - from), b = maths::cross(along, s.b - from);
    if (a < 0 && b < 0) return std::nullopt;
    if (a < 0)
        s.a = s.a + (s.b - s.a) * (a / (a - b));
    else if (b < 0)
        s.b = s.a + (s.b - s.a) * (a / (a - b));
    return s;
}

// The part of a segment between two arms at most 180 degrees apart.
std::optional<Segment> clip_to_wedge(const Segment& s, vec2 from, vec2 right_arm, vec2 left_arm) {
    const auto half = clip_left_of(s, from, right_arm);
    return half ? clip_left_of(*half, from, -left_arm) : std::nullopt;
}

}  // namespace

float answer_to_outline(const Eye& eye, const Gaze& gaze, const Outline& outline) {
    float nearest = std::numeric_limits<float>::max();
    vec2 point;
    const auto consider = [&](const std::optional<Segment>& part) {
        if (!part) return;
        const vec2 p = maths::nearest_on_segment(gaze.from, part->a, part->b);
        const float d = maths::dot(p - gaze.from, p - gaze.from);
        if (d < nearest) nearest = d, point = p;
    };
    const std::size_t count = outline.corners.size();
    for (std::size_t i = 0; i + 1 < count || (count > 2 && i < count); ++i) {
        const Segment side{outline.corners[i], outline.corners[(i + 1) % count]};
        if (eye.shape == SensorShape::omni) {
            consider(side);
        } else {  // two wedges of half the field each: both convex for any field
            consider(clip_to_wedge(side, gaze.from, gaze.right_arm, gaze.axis));
            consider(clip_to_wedge(side, gaze.from, gaze.axis, gaze.left_arm));
        }
    }
    if (nearest > eye.range_squared) return 0;
    // The nearest point lies on the field's very edge as often as not, so it is not asked again whether it is inside.
    if (eye.response == SensorResponse::boolean) return 1;
    const float off_axis = eye.shape == SensorShape::omni || nearest == 0
                               ? 1.0f
                               : maths::dot(point - gaze.from, gaze.axis) / std::sqrt(nearest);
    const float fade = 1 - nearest / eye.range_squared;
    return std::max(0.0f, off_axis) * fade * fade / (1 + nearest / eye.half_distance_squared);
}

}  // namespace braitenlab
