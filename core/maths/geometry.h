// Points in plane figures.
#pragma once

#include <cmath>

#include "core/maths/vec.h"

namespace braitenlab::maths {

// Weights of a, b and c that add up to p and to 1 (barycentric coordinates). A degenerate triangle gives infinities.
inline vec3 barycentric(vec2 p, vec2 a, vec2 b, vec2 c) {
    const float area = cross(b - a, c - a);
    const float u = cross(c - b, p - b) / area;
    const float v = cross(a - c, p - c) / area;
    return {u, v, 1 - u - v};
}

// Edges belong to the triangle; either winding.
inline bool in_triangle(vec2 p, vec2 a, vec2 b, vec2 c) {
    const vec3 w = barycentric(p, a, b, c);
    return w.x >= 0 && w.y >= 0 && w.z >= 0;
}

// A convex quad with its corners in order, either winding; edges belong to it.
inline bool in_quad(vec2 p, vec2 a, vec2 b, vec2 c, vec2 d) {
    return in_triangle(p, a, b, c) || in_triangle(p, a, c, d);
}

// Within the radius of the apex, clockwise of the left arm and counter-clockwise of the right one. The arms are
// directions of any length; `reflex` says that the sector is the large side (more than 180 degrees).
inline bool in_sector(vec2 p, vec2 apex, vec2 right_arm, vec2 left_arm, float radius, bool reflex) {
    const vec2 d = p - apex;
    if (dot(d, d) > radius * radius) return false;
    const bool left_of_right_arm = cross(right_arm, d) >= 0;
    const bool right_of_left_arm = cross(left_arm, d) <= 0;
    return reflex ? left_of_right_arm || right_of_left_arm : left_of_right_arm && right_of_left_arm;
}

// The point of the segment a..b nearest to p.
inline vec2 nearest_on_segment(vec2 p, vec2 a, vec2 b) {
    const vec2 along = b - a;
    const float span = dot(along, along);
    if (span == 0) return a;
    const float t = dot(p - a, along) / span;
    return a + along * (t < 0 ? 0 : t > 1 ? 1 : t);
}

}  // namespace braitenlab::maths
