// Outlines of walls, obstacles and posts: sensors read their nearest point, obstacles block the line of sight, and
// bumpers test whether they touch the chassis.
#pragma once

#include <array>
#include <vector>

#include "core/mechanics/motion.h"
#include "core/sensing/compiled_sensor.h"
#include "core/sensing/seam.h"

namespace braitenlab::sensing {

// Two corners: a segment; more: a closed polygon.
struct Outline {
    std::vector<maths::vec2> corners;  // m, world coordinates
};

struct Segment {
    maths::vec2 a, b;
};

// The sides, in order.
inline std::size_t side_count(const Outline& o) { return o.corners.size() > 2 ? o.corners.size() : 1; }
inline Segment side(const Outline& o, std::size_t i) { return {o.corners[i], o.corners[(i + 1) % o.corners.size()]}; }

// A polygon given in a body's own frame, at the body's pose.
Outline outline_of(const std::vector<maths::vec2>& corners, const mechanics::Motion&);

// The parts of a segment between the field's arms and, for a triangle, before its chord. The range of a sector is not
// tested. Up to two parts, because a field beyond 180 degrees is not convex.
struct Clipped {
    std::array<Segment, 2> part;
    int count = 0;
};
Clipped clip_to_field(const CompiledSensor&, const SensorPose&, const Segment&);

// Response to the nearest point inside the field of the outline moved by −shift; 0 when no part of it lies there.
float response_to_outline(const CompiledSensor&, const SensorPose&, const Outline&, maths::vec2 shift = {});

// True when the straight line from a to b crosses the outline.
bool crosses(const Outline&, maths::vec2 a, maths::vec2 b);

// True when a part of the outline inside the bumper's field is within touching distance of the chassis. The bumper's
// range is ignored: its field ends at the chassis.
bool touches_field(const CompiledSensor& bumper, const Body&, const mechanics::Motion&, const Outline&);

// All outlines of a scene, with bounding circles and boxes so that distant ones cost little.
class Outlines {
public:
    // The arena's four walls or its round wall if it has any, the obstacles at their current poses, and solid sources.
    Outlines(const Scene&, const std::vector<mechanics::Motion>& obstacles);

    // Updates the outlines of movable obstacles.
    void move(const Scene&, const std::vector<mechanics::Motion>& obstacles);

    // Reading of an obstacle sensor: the sum of its responses to all outlines but a rim's, those across a seam
    // included.
    float total(const CompiledSensor&, const SensorPose&) const;

    // True when an obstacle lies within `range` (m) of the position. When false, nothing is hidden from a sensor there.
    bool any_obstacle_near(maths::vec2 position, float range) const;

    // True when an obstacle stands on the straight line from `from` to `to`. Walls and posts do not block.
    bool block(maths::vec2 from, maths::vec2 to) const;

    // Copies every outline within `range` (m) of the position to `found`, shifted across the seam where needed.
    void find_near(maths::vec2 position, float range, std::vector<Outline>& found) const;

private:
    struct Circle {
        maths::vec2 middle;
        float radius = 0;
    };
    struct Box {
        maths::vec2 low, high;
    };
    static Box box_of(const Outline&);
    void add(Outline);

    // Calls visit(index, shift) for the outlines first <= i < end within range and for their images across the seam,
    // until one call returns true. Returns whether one did.
    template <class Visit>
    bool any_image_near(std::size_t first, std::size_t end, maths::vec2 position, float range, Visit visit) const;

    Seam seam_;
    std::vector<Outline> outlines_;  // walls, obstacles, posts
    std::vector<Circle> circles_;    // bounding circle of each
    std::vector<Box> boxes_;  // bounding box of each; that of a wall, unlike its circle, is far from most sensors
    std::size_t first_obstacle_ = 0, end_obstacle_ = 0, first_seen_ = 0;  // a rim is not seen
};

}  // namespace braitenlab::sensing
