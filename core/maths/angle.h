// Angles, in radians unless a name says degrees.
#pragma once

#include <cmath>

#include "core/maths/portable.h"
#include "core/maths/vec.h"

namespace braitenlab::maths {

constexpr float radians(float degrees) { return degrees * (pi / 180); }
constexpr float degrees(float radians) { return radians * (180 / pi); }

// The equivalent angle in [-pi, pi).
inline float wrap_angle(float angle) { return angle - 2 * pi * std::floor((angle + pi) / (2 * pi)); }

// Unit vector at an angle counter-clockwise from +x.
inline vec2 direction(float angle) {
    const auto [sine, cosine] = sine_cosine(angle);
    return {cosine, sine};
}

// Conversion between polar (distance, angle in rad) and Cartesian coordinates.
inline vec2 from_polar(float distance, float angle) { return direction(angle) * distance; }
struct Polar {
    float distance = 0, angle = 0;
};
inline Polar to_polar(vec2 v) { return {length(v), arctangent2(v.y, v.x)}; }

// v rotated counter-clockwise by the angle of the unit vector `by`.
constexpr vec2 rotate(vec2 v, vec2 by) { return {v.x * by.x - v.y * by.y, v.x * by.y + v.y * by.x}; }

}  // namespace braitenlab::maths
