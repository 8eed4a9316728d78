// The outline of an obstacle while it is drawn, corner by corner. No mouse, no window.
#pragma once

#include <vector>

#include "core/maths/vec.h"
#include "core/scene/scene.h"

namespace braitenlab {

// Why an outline cannot become an obstacle.
enum class OutlineFault {
    none,
    too_near,    // a corner lies within 0.1 m of another one
    crosses,     // two edges cross
    dents,       // it turns inwards somewhere: obstacles are convex
    too_many,    // corners
    too_few,     // less than three corners
    too_narrow,  // thinner than 0.1 m somewhere, or all corners in a line
};

// Whether a next corner may stand here; corners in metres, in either direction round. Whatever passes can still become
// a whole outline, since every start of a convex outline is convex itself.
OutlineFault fault_of_next(const std::vector<maths::vec2>& corners, maths::vec2 next);

// Whether the outline may be closed as it is.
OutlineFault fault_of(const std::vector<maths::vec2>& corners);

// The obstacle with these corners, its place amid them. Precondition: fault_of is none.
Obstacle obstacle_from(const std::vector<maths::vec2>& corners);

// The box between two opposite corners, each side at least 0.2 m long.
Obstacle box_between(maths::vec2 a, maths::vec2 b);

}  // namespace braitenlab
