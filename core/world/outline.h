// Walls, obstacles and posts as eyes meet them: felt by their nearest point, and in the way of light.
#pragma once

#include <array>
#include <vector>

#include "core/world/eye.h"
#include "core/world/motion.h"
#include "core/world/seam.h"

namespace braitenlab {

// Two corners: a segment; more: a closed loop.
struct Outline {
    std::vector<maths::vec2> corners;  // m, in the world
};

struct Segment {
    maths::vec2 a, b;
};

// The sides, in order.
inline std::size_t side_count(const Outline& o) { return o.corners.size() > 2 ? o.corners.size() : 1; }
inline Segment side(const Outline& o, std::size_t i) { return {o.corners[i], o.corners[(i + 1) % o.corners.size()]}; }

// A box or polygon where a body has carried it.
Outline outline_of(const std::vector<maths::vec2>& corners, const Motion&);

// The parts of a segment that lie between the field's arms and, for a triangle, before its chord; the range of a sector
// is not asked for. Two parts, since a field beyond 180 degrees is not convex.
struct Clipped {
    std::array<Segment, 2> part;
    int count = 0;
};
Clipped clip_to_field(const Eye&, const Gaze&, const Segment&);

// The answer to the outline's nearest point inside the field; 0 when no part of it lies there.
float answer_to_outline(const Eye&, const Gaze&, const Outline&);

// Whether the straight way from a to b crosses it.
bool crosses(const Outline&, maths::vec2 a, maths::vec2 b);

// All outlines of a scene, with circles round them so that far ones cost little.
class Outlines {
public:
    // The arena's four walls if it has any, the obstacles where they are now, and solid sources.
    Outlines(const Scene&, const std::vector<Motion>& obstacles);

    // Follows the obstacles that can be pushed about.
    void move(const Scene&, const std::vector<Motion>& obstacles);

    // What an eye for obstacles reads: the answers to all outlines added up, those across a seam included.
    float total(const Eye&, const Gaze&) const;

    // Whether an obstacle comes within `range` (m) of a place: else nothing is hidden from an eye there.
    bool any_obstacle_near(maths::vec2 place, float range) const;

    // Whether an obstacle stands on the straight way from `from` to `to`. Walls and posts hide nothing.
    bool hide(maths::vec2 from, maths::vec2 to) const;

    // Every outline that comes within `range` of a place.
    void near(maths::vec2 place, float range, std::vector<Outline>& found) const;

private:
    struct Circle {
        maths::vec2 middle;
        float radius = 0;
    };
    void add(Outline);

    // Calls visit(index, shift) for the outlines first ≤ i < end within range, and for their images across the seam,
    // until one returns true; says whether one did.
    template <class Visit>
    bool any_image_near(std::size_t first, std::size_t end, maths::vec2 place, float range, Visit visit) const;

    Seam seam_;
    std::vector<Outline> outlines_;  // walls, obstacles, posts
    std::vector<Circle> circles_;    // round each
    std::size_t first_obstacle_ = 0, end_obstacle_ = 0;
};

}  // namespace braitenlab
