// Where bodies are, how they move, and who touches whom.
#pragma once

#include <cmath>
#include <compare>

#include "core/maths/angle.h"
#include "core/maths/vec.h"
#include "core/world/snapshot.h"

namespace braitenlab {

// m, unit vector of the heading, m/s, rad/s, and the heading itself in rad, not wrapped.
struct Motion {
    maths::vec2 place, ahead{1, 0}, velocity;
    float turning = 0;
    float heading = 0;
};

inline bool is_finite(const Pose& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.heading); }

// Standing still.
inline Motion at_rest(const Pose& pose) {
    return {{pose.x, pose.y}, maths::direction(pose.heading), {}, 0, pose.heading};
}

// Two vehicles that touch, the lower id first; or one vehicle and the environment (other == no_vehicle).
struct Touch {
    VehicleId one = no_vehicle, other = no_vehicle;
    friend auto operator<=>(const Touch&, const Touch&) = default;
};

// A vehicle that touches the environment, and where (m).
struct Bump {
    VehicleId vehicle = no_vehicle;
    maths::vec2 at;
};

}  // namespace braitenlab
