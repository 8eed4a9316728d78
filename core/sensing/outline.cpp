#include "core/sensing/outline.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "core/maths/angle.h"
#include "core/maths/geometry.h"
#include "core/scene/arena.h"

namespace braitenlab::sensing {

using maths::vec2;

namespace {

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

Segment operator-(const Segment& s, vec2 shift) { return {s.a - shift, s.b - shift}; }

bool is_in_range(const CompiledSensor& sensor, const SensorPose& pose, const Segment& s) {
    const vec2 d = maths::nearest_on_segment(pose.position, s.a, s.b) - pose.position;
    return maths::dot(d, d) <= sensor.range_squared;
}

// Bodies in contact at the start of a step may be slightly apart at its end.
constexpr float touching_distance = 0.05f;  // m

// Clips the part from..to of a segment (fractions of its length) to where it lies between −half and half.
void clip_to_slab(float start, float span, float half, float& from, float& to) {
    if (span == 0) {
        if (start < -half || start > half) to = -1;
        return;
    }
    float enter = (-half - start) / span, leave = (half - start) / span;
    if (enter > leave) std::swap(enter, leave);
    from = std::max(from, enter);
    to = std::min(to, leave);
}

// True when the segment meets the box of these half extents, both in the vehicle's frame.
bool meets_box(const Segment& s, vec2 half) {
    float from = 0, to = 1;
    clip_to_slab(s.a.x, s.b.x - s.a.x, half.x, from, to);
    clip_to_slab(s.a.y, s.b.y - s.a.y, half.y, from, to);
    return from <= to;
}

}  // namespace

Outline outline_of(const std::vector<vec2>& corners, const mechanics::Motion& motion) {
    Outline outline;
    outline.corners.reserve(corners.size());
    for (const vec2 corner : corners) outline.corners.push_back(mechanics::to_world(motion, corner));
    return outline;
}

Clipped clip_to_field(const CompiledSensor& sensor, const SensorPose& pose, const Segment& segment) {
    if (sensor.shape == SensorShape::omni) return {{segment, {}}, 1};
    Clipped clipped;
    const auto keep = [&](std::optional<Segment> part) {
        if (part && sensor.shape == SensorShape::triangle)
            part = clip_left_of(*part, pose.position + pose.axis * sensor.reach, {-pose.axis.y, pose.axis.x});
        if (part) clipped.part[static_cast<std::size_t>(clipped.count++)] = *part;
    };
    // Two wedges of half the field each; both are convex for any opening angle.
    keep(clip_to_wedge(segment, pose.position, pose.right_arm, pose.axis));
    keep(clip_to_wedge(segment, pose.position, pose.axis, pose.left_arm));
    return clipped;
}

float response_to_outline(const CompiledSensor& sensor, const SensorPose& pose, const Outline& outline, vec2 shift) {
    float nearest = std::numeric_limits<float>::max();
    vec2 way;
    constexpr std::size_t most_of_an_object = 8;
    const bool many = side_count(outline) > most_of_an_object;  // a round wall: most sides are out of range
    for (std::size_t i = 0; i < side_count(outline); ++i) {
        const Segment whole = side(outline, i) - shift;
        if (many && !is_in_range(sensor, pose, whole)) continue;
        const Clipped clipped = clip_to_field(sensor, pose, whole);
        for (int k = 0; k < clipped.count; ++k) {
            const Segment& part = clipped.part[static_cast<std::size_t>(k)];
            const vec2 d = maths::nearest_on_segment(pose.position, part.a, part.b) - pose.position;
            if (maths::dot(d, d) < nearest) nearest = maths::dot(d, d), way = d;
        }
    }
    if (nearest > sensor.range_squared) return 0;
    // The nearest point often lies on the field's border, where rounding would fail a second in_field test.
    return response_in_field(sensor, nearest, std::sqrt(nearest), maths::dot(way, pose.axis), 1);
}

bool touches_field(const CompiledSensor& bumper, const Body& body, const mechanics::Motion& motion,
                   const Outline& outline) {
    const SensorPose pose = sensor_pose(bumper, motion.position, motion.ahead);
    const vec2 half = vec2{body.length, body.width} / 2 + vec2{touching_distance, touching_distance};
    const vec2 inverse{motion.ahead.x, -motion.ahead.y};
    for (std::size_t i = 0; i < side_count(outline); ++i) {
        const Clipped clipped = clip_to_field(bumper, pose, side(outline, i));
        for (int k = 0; k < clipped.count; ++k) {
            const Segment& part = clipped.part[static_cast<std::size_t>(k)];
            if (meets_box({maths::rotate(part.a - motion.position, inverse),
                           maths::rotate(part.b - motion.position, inverse)},
                          half))
                return true;
        }
    }
    return false;
}

bool crosses(const Outline& outline, vec2 a, vec2 b) {
    for (std::size_t i = 0; i < side_count(outline); ++i) {
        const Segment s = side(outline, i);
        const bool parts_ends = (maths::cross(b - a, s.a - a) > 0) != (maths::cross(b - a, s.b - a) > 0);
        if (parts_ends && (maths::cross(s.b - s.a, a - s.a) > 0) != (maths::cross(s.b - s.a, b - s.a) > 0)) return true;
    }
    return false;
}

Outlines::Outlines(const Scene& scene, const std::vector<mechanics::Motion>& obstacles) : seam_(scene.arena) {
    if (has_walls(scene.arena.edge) && scene.arena.round) {
        add({round_corners(scene.arena)});
    } else if (has_walls(scene.arena.edge)) {
        const float w = scene.arena.width / 2, h = scene.arena.height / 2;
        const std::array<vec2, 4> corner{{{-w, -h}, {w, -h}, {w, h}, {-w, h}}};
        for (std::size_t i = 0; i < 4; ++i) add({{corner[i], corner[(i + 1) % 4]}});
    }
    first_obstacle_ = outlines_.size();
    first_seen_ = scene.arena.edge == Boundary::rim ? first_obstacle_ : 0;
    for (std::size_t i = 0; i < obstacles.size(); ++i) add(outline_of(corners_of(scene.obstacles[i]), obstacles[i]));
    end_obstacle_ = outlines_.size();
    for (const Source& source : scene.sources) {
        if (!source.solid) continue;
        constexpr int sides = 8;
        Outline post;
        for (int i = 0; i < sides; ++i)
            post.corners.push_back(
                vec2{source.x, source.y} +
                maths::from_polar(source_radius(scene.arena), 2 * maths::pi * static_cast<float>(i) / sides));
        add(std::move(post));
    }
}

void Outlines::add(Outline outline) {
    Circle circle;
    for (const vec2 corner : outline.corners) circle.middle += corner / static_cast<float>(outline.corners.size());
    for (const vec2 corner : outline.corners)
        circle.radius = std::max(circle.radius, maths::distance(corner, circle.middle));
    circles_.push_back(circle);
    boxes_.push_back(box_of(outline));
    outlines_.push_back(std::move(outline));
}

Outlines::Box Outlines::box_of(const Outline& outline) {
    Box box{outline.corners[0], outline.corners[0]};
    for (const vec2 corner : outline.corners) {
        box.low = {std::min(box.low.x, corner.x), std::min(box.low.y, corner.y)};
        box.high = {std::max(box.high.x, corner.x), std::max(box.high.y, corner.y)};
    }
    return box;
}

void Outlines::move(const Scene& scene, const std::vector<mechanics::Motion>& obstacles) {
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
        if (scene.obstacles[i].mass <= 0) continue;
        Outline moved = outline_of(corners_of(scene.obstacles[i]), obstacles[i]);
        Circle& circle = circles_[first_obstacle_ + i];
        circle.middle = {};
        for (const vec2 corner : moved.corners) circle.middle += corner / static_cast<float>(moved.corners.size());
        boxes_[first_obstacle_ + i] = box_of(moved);
        outlines_[first_obstacle_ + i] = std::move(moved);
    }
}

template <class Visit>
bool Outlines::any_image_near(std::size_t first, std::size_t end, vec2 position, float range, Visit visit) const {
    const int images = seam_.joined ? 1 : 0;
    for (std::size_t i = first; i < end; ++i) {
        const float reach = circles_[i].radius + range;
        for (int row = -images; row <= images; ++row)
            for (int column = -images; column <= images; ++column) {
                const vec2 shift{static_cast<float>(column) * seam_.size.x, static_cast<float>(row) * seam_.size.y};
                const vec2 d = circles_[i].middle - shift - position;
                if (maths::dot(d, d) <= reach * reach && visit(i, shift)) return true;
            }
    }
    return false;
}

float Outlines::total(const CompiledSensor& sensor, const SensorPose& pose) const {
    // An outline and its images across the seam are one object: the strongest response counts.
    // The response to an outline whose box is out of range is 0; `rounding` covers that of its nearest point.
    constexpr float rounding = 0.01f;  // m
    const float reach = sensor.range + rounding;
    float sum = 0, strongest = 0;
    std::size_t last = outlines_.size();
    any_image_near(first_seen_, outlines_.size(), pose.position, sensor.range, [&](std::size_t i, vec2 shift) {
        const Box& box = boxes_[i];
        const vec2 at = pose.position + shift;
        if (at.x < box.low.x - reach || at.x > box.high.x + reach || at.y < box.low.y - reach ||
            at.y > box.high.y + reach)
            return false;
        if (i != last) sum += strongest, strongest = 0, last = i;
        strongest = std::max(strongest, response_to_outline(sensor, pose, outlines_[i], shift));
        return false;
    });
    return sum + strongest;
}

bool Outlines::any_obstacle_near(vec2 position, float range) const {
    return any_image_near(first_obstacle_, end_obstacle_, position, range, [](std::size_t, vec2) { return true; });
}

bool Outlines::block(vec2 from, vec2 to) const {
    const vec2 middle = (from + to) / 2;
    return any_image_near(first_obstacle_, end_obstacle_, middle, maths::distance(from, middle),
                          [&](std::size_t i, vec2 shift) { return crosses(outlines_[i], from + shift, to + shift); });
}

void Outlines::find_near(vec2 position, float range, std::vector<Outline>& found) const {
    found.clear();
    any_image_near(0, outlines_.size(), position, range, [&](std::size_t i, vec2 shift) {
        found.push_back(outlines_[i]);
        for (vec2& corner : found.back().corners) corner = corner - shift;
        return false;
    });
}

}  // namespace braitenlab::sensing
