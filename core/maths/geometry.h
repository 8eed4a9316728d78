// Tests of points against plane figures.
#pragma once

#include <cmath>

#include "core/maths/vec.h"

namespace braitenlab::maths {

// Barycentric coordinates of p: weights of a, b and c whose weighted sum is p and whose sum is 1. Infinite for a
// degenerate triangle.
inline vec3 barycentric(vec2 p, vec2 a, vec2 b, vec2 c) {
    const float area = cross(b - a, c - a);
    const float u = cross(c - b, p - b) / area;
    const float v = cross(a - c, p - c) / area;
    return {u, v, 1 - u - v};
}

// True inside the triangle and on its edges, for either winding.
inline bool in_triangle(vec2 p, vec2 a, vec2 b, vec2 c) {
    const vec3 w = barycentric(p, a, b, c);
    return w.x >= 0 && w.y >= 0 && w.z >= 0;
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
