// Inertia of a vehicle's body and the external forces on it. Units N, kg, m, rad; world axes.
#pragma once

#include <algorithm>

#include "core/maths/vec.h"
#include "core/mechanics/wheel.h"

namespace braitenlab::mechanics {

// Moment of inertia (kg·m^2) of a uniform plate about its centre.
constexpr float plate_inertia(float mass, float length, float width) {
    return mass * (length * length + width * width) / 12;
}

// Force of gravity along a slope, from the sine of its angle; `downhill` is a unit vector.
constexpr maths::vec2 slope_force(maths::vec2 downhill, float sine_of_slope, float mass) {
    return downhill * (sine_of_slope * mass * gravity);
}

// Force from one point towards another; a negative strength (N) pushes away. Its size is |strength| at every distance
// from 0.5 m. Nearer, it falls linearly to 0, so that a body at the target does not oscillate.
inline maths::vec2 pull_force(maths::vec2 from, maths::vec2 to, float strength) {
    constexpr float fading = 0.5f;  // m
    const maths::vec2 way = to - from;
    return way * (strength / std::max(maths::length(way), fading));
}

}  // namespace braitenlab::mechanics
