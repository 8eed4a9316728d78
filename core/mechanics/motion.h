// Position and velocity of a rigid body in the plane, and their integration.
#pragma once

#include "core/maths/angle.h"
#include "core/maths/vec.h"

namespace braitenlab::mechanics {

struct Motion {
    maths::vec2 position, ahead{1, 0}, velocity;  // m, unit vector of the heading, m/s
    float angular_velocity = 0;                   // rad/s, counter-clockwise
    float heading = 0;                            // rad; of a running world in −π..π
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

// Semi-implicit Euler integration: updates the velocity first, then the position with the new velocity. Unlike explicit
// Euler, it does not add energy to oscillations; rigid-body engines use it.
//
// Advances place (m) and speed (m/s), numbers or vectors, by dt seconds under an acceleration (m/s^2).
template <class Vector>
constexpr void integrate(Vector& place, Vector& speed, Vector acceleration, float dt) {
    speed += acceleration * dt;
    place += speed * dt;
}

}  // namespace braitenlab::mechanics
