#include "core/world/outline.h"

#include <limits>
#include <optional>

#include "core/maths/angle.h"
#include "core/maths/geometry.h"

namespace braitenlab {

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

// As answer_to_outline, of an outline moved by −shift.
float answer_to_shifted(const Eye& eye, const Gaze& gaze, const Outline& outline, vec2 shift) {
    float nearest = std::numeric_limits<float>::max();
    vec2 way;
    for (std::size_t i = 0; i < side_count(outline); ++i) {
        const Clipped clipped = clip_to_field(eye, gaze, side(outline, i) - shift);
        for (int k = 0; k < clipped.count; ++k) {
            const Segment& part = clipped.part[static_cast<std::size_t>(k)];
            const vec2 d = maths::nearest_on_segment(gaze.from, part.a, part.b) - gaze.from;
            if (maths::dot(d, d) < nearest) nearest = maths::dot(d, d), way = d;
        }
    }
    if (nearest > eye.range_squared) return 0;
    // The nearest point lies on the field's very edge as often as not, so it is not asked again whether it is inside.
    if (eye.response == SensorResponse::boolean) return 1;
    return graded(eye, nearest, std::sqrt(nearest), maths::dot(way, gaze.axis), 1);
}

}  // namespace

Outline outline_of(const std::vector<vec2>& corners, const Motion& motion) {
    Outline outline;
    outline.corners.reserve(corners.size());
    for (const vec2 corner : corners) outline.corners.push_back(motion.place + maths::rotate(corner, motion.ahead));
    return outline;
}

Clipped clip_to_field(const Eye& eye, const Gaze& gaze, const Segment& segment) {
    if (eye.shape == SensorShape::omni) return {{segment, {}}, 1};
    Clipped clipped;
    const auto keep = [&](std::optional<Segment> part) {
        if (part && eye.shape == SensorShape::triangle)
            part = clip_left_of(*part, gaze.from + gaze.axis * eye.reach, {-gaze.axis.y, gaze.axis.x});
        if (part) clipped.part[static_cast<std::size_t>(clipped.count++)] = *part;
    };
    // Two wedges of half the field each: both convex for any field.
    keep(clip_to_wedge(segment, gaze.from, gaze.right_arm, gaze.axis));
    keep(clip_to_wedge(segment, gaze.from, gaze.axis, gaze.left_arm));
    return clipped;
}

float answer_to_outline(const Eye& eye, const Gaze& gaze, const Outline& outline) {
    return answer_to_shifted(eye, gaze, outline, {});
}

bool crosses(const Outline& outline, vec2 a, vec2 b) {
    for (std::size_t i = 0; i < side_count(outline); ++i) {
        const Segment s = side(outline, i);
        const bool parts_ends = (maths::cross(b - a, s.a - a) > 0) != (maths::cross(b - a, s.b - a) > 0);
        if (parts_ends && (maths::cross(s.b - s.a, a - s.a) > 0) != (maths::cross(s.b - s.a, b - s.a) > 0)) return true;
    }
    return false;
}

Outlines::Outlines(const Scene& scene, const std::vector<Motion>& obstacles) : seam_(scene.arena) {
    if (scene.arena.edge == Edge::wall) {
        const float w = scene.arena.width / 2, h = scene.arena.height / 2;
        const std::array<vec2, 4> corner{{{-w, -h}, {w, -h}, {w, h}, {-w, h}}};
        for (std::size_t i = 0; i < 4; ++i) add({{corner[i], corner[(i + 1) % 4]}});
    }
    first_obstacle_ = outlines_.size();
    for (std::size_t i = 0; i < obstacles.size(); ++i) add(outline_of(corners_of(scene.obstacles[i]), obstacles[i]));
    end_obstacle_ = outlines_.size();
    for (const Source& source : scene.sources) {
        if (!source.solid) continue;
        constexpr int sides = 8;
        Outline post;
        for (int i = 0; i < sides; ++i)
            post.corners.push_back(
                vec2{source.x, source.y} +
                maths::from_polar(solid_source_radius, 2 * maths::pi * static_cast<float>(i) / sides));
        add(std::move(post));
    }
}

void Outlines::add(Outline outline) {
    Circle circle;
    for (const vec2 corner : outline.corners) circle.middle += corner / static_cast<float>(outline.corners.size());
    for (const vec2 corner : outline.corners)
        circle.radius = std::max(circle.radius, maths::distance(corner, circle.middle));
    circles_.push_back(circle);
    outlines_.push_back(std::move(outline));
}

void Outlines::move(const Scene& scene, const std::vector<Motion>& obstacles) {
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
        if (scene.obstacles[i].mass <= 0) continue;
        Outline moved = outline_of(corners_of(scene.obstacles[i]), obstacles[i]);
        Circle& circle = circles_[first_obstacle_ + i];
        circle.middle = {};
        for (const vec2 corner : moved.corners) circle.middle += corner / static_cast<float>(moved.corners.size());
        outlines_[first_obstacle_ + i] = std::move(moved);
    }
}

template <class Visit>
bool Outlines::any_image_near(std::size_t first, std::size_t end, vec2 place, float range, Visit visit) const {
    const int images = seam_.joined ? 1 : 0;
    for (std::size_t i = first; i < end; ++i) {
        const float reach = circles_[i].radius + range;
        for (int row = -images; row <= images; ++row)
            for (int column = -images; column <= images; ++column) {
                const vec2 shift{static_cast<float>(column) * seam_.size.x, static_cast<float>(row) * seam_.size.y};
                const vec2 d = circles_[i].middle - shift - place;
                if (maths::dot(d, d) <= reach * reach && visit(i, shift)) return true;
            }
    }
    return false;
}

float Outlines::total(const Eye& eye, const Gaze& gaze) const {
    // Of an outline and its images across the seam, the one that answers most counts: it is still one thing.
    float sum = 0, strongest = 0;
    std::size_t last = outlines_.size();
    any_image_near(0, outlines_.size(), gaze.from, eye.range, [&](std::size_t i, vec2 shift) {
        if (i != last) sum += strongest, strongest = 0, last = i;
        strongest = std::max(strongest, answer_to_shifted(eye, gaze, outlines_[i], shift));
        return false;
    });
    return sum + strongest;
}

bool Outlines::any_obstacle_near(vec2 place, float range) const {
    return any_image_near(first_obstacle_, end_obstacle_, place, range, [](std::size_t, vec2) { return true; });
}

bool Outlines::hide(vec2 from, vec2 to) const {
    const vec2 middle = (from + to) / 2;
    return any_image_near(first_obstacle_, end_obstacle_, middle, maths::distance(from, middle),
                          [&](std::size_t i, vec2 shift) { return crosses(outlines_[i], from + shift, to + shift); });
}

void Outlines::near(vec2 place, float range, std::vector<Outline>& found) const {
    found.clear();
    any_image_near(0, outlines_.size(), place, range, [&](std::size_t i, vec2 shift) {
        found.push_back(outlines_[i]);
        for (vec2& corner : found.back().corners) corner = corner - shift;
        return false;
    });
}

}  // namespace braitenlab
