// Position and velocity of a rigid body in the plane.
#pragma once

#include "core/maths/angle.h"
#include "core/maths/vec.h"

namespace braitenlab::mechanics {

struct Motion {
    maths::vec2 position, ahead{1, 0}, velocity;  // m, unit vector of the heading, m/s
    float angular_velocity = 0;                   // rad/s, counter-clockwise
    float heading = 0;                            // rad, not wrapped
    friend constexpr bool operator==(const Motion&, const Motion&) = default;
};

// A body at rest. Position in m, heading in rad.
inline Motion at_rest(maths::vec2 position, float heading) {
    return {position, maths::direction(heading), {}, 0, heading};
}

// Converts a point (m) from the body's frame to world coordinates.
inline maths::vec2 to_world(const Motion& motion, maths::vec2 point) {
    return motion.position + maths::rotate(point, motion.ahead);
}

}  // namespace braitenlab::mechanics
