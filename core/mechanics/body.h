// A vehicle's body as a whole: its inertia, and what pushes it from outside. N, kg, m, rad; world axes.
#pragma once

#include <algorithm>

#include "core/maths/vec.h"
#include "core/mechanics/wheel.h"

namespace braitenlab::mechanics {

// kg·m^2, of a uniform plate about its middle.
constexpr float plate_inertia(float mass, float length, float width) {
    return mass * (length * length + width * width) / 12;
}

// What gravity does along a slope, given the sine of its angle; `downhill` is a unit vector.
constexpr maths::vec2 slope_force(maths::vec2 downhill, float sine_of_slope, float mass) {
    return downhill * (sine_of_slope * mass * gravity);
}

// Draws from one point towards another; a negative strength pushes away. The same at every distance, but for the last
// half metre, where it fades: a force that turned round at full strength would shake what has arrived.
inline maths::vec2 pull_force(maths::vec2 from, maths::vec2 to, float strength) {
    constexpr float fading = 0.5f;  // m
    const maths::vec2 way = to - from;
    return way * (strength / std::max(maths::length(way), fading));
}

}  // namespace braitenlab::mechanics
