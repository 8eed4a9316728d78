// Four-by-four matrices in OpenGL's conventions: column vectors, stored column after column, clip volume -1..1.
#pragma once

#include <array>
#include <cmath>

#include "core/maths/vec.h"

namespace braitenlab::maths {

struct mat4 {
    std::array<vec4, 4> column{vec4{1, 0, 0, 0}, vec4{0, 1, 0, 0}, vec4{0, 0, 1, 0}, vec4{0, 0, 0, 1}};  // identity

    constexpr vec4& operator[](int i) { return column[static_cast<unsigned>(i)]; }
    constexpr const vec4& operator[](int i) const { return column[static_cast<unsigned>(i)]; }
    friend constexpr bool operator==(const mat4&, const mat4&) = default;
};
static_assert(sizeof(mat4) == 16 * sizeof(float));

constexpr vec4 operator*(const mat4& m, vec4 v) { return m[0] * v.x + m[1] * v.y + m[2] * v.z + m[3] * v.w; }
constexpr mat4 operator*(const mat4& a, const mat4& b) {
    mat4 product;
    for (int i = 0; i < 4; ++i) product[i] = a * b[i];
    return product;
}

// A point at the eye's place looking at the target; up need not be perpendicular to the line of sight, only not along
// it.
inline mat4 look_at(vec3 eye, vec3 target, vec3 up) {
    const vec3 back = normalise(eye - target);
    const vec3 right = normalise(cross(up, back));
    const vec3 top = cross(back, right);
    mat4 view;
    view[0] = {right.x, top.x, back.x, 0};
    view[1] = {right.y, top.y, back.y, 0};
    view[2] = {right.z, top.z, back.z, 0};
    view[3] = {-dot(right, eye), -dot(top, eye), -dot(back, eye), 1};
    return view;
}

// vertical_field in radians in (0, pi); aspect = width / height > 0; 0 < near < far, all along the line of sight.
inline mat4 perspective(float vertical_field, float aspect, float near, float far) {
    const float focal = 1.0f / std::tan(vertical_field / 2);
    mat4 m;
    m[0] = {focal / aspect, 0, 0, 0};
    m[1] = {0, focal, 0, 0};
    m[2] = {0, 0, (far + near) / (near - far), -1};
    m[3] = {0, 0, 2 * far * near / (near - far), 0};
    return m;
}

// The box left..right, bottom..top, near..far (distances before the eye) onto the clip volume.
constexpr mat4 orthographic(float left, float right, float bottom, float top, float near, float far) {
    mat4 m;
    m[0] = {2 / (right - left), 0, 0, 0};
    m[1] = {0, 2 / (top - bottom), 0, 0};
    m[2] = {0, 0, 2 / (near - far), 0};
    m[3] = {(right + left) / (left - right), (top + bottom) / (bottom - top), (far + near) / (near - far), 1};
    return m;
}

// The inverse of any invertible matrix (by cofactors); of a singular one, a matrix of infinities or NaNs.
inline mat4 inverse(const mat4& m) {
    // 2x2 minors of the upper and lower halves, after the Laplace expansion along two rows.
    const auto at = [&m](int row, int column) { return m[column][row]; };
    const float s0 = at(0, 0) * at(1, 1) - at(1, 0) * at(0, 1), s1 = at(0, 0) * at(1, 2) - at(1, 0) * at(0, 2);
    const float s2 = at(0, 0) * at(1, 3) - at(1, 0) * at(0, 3), s3 = at(0, 1) * at(1, 2) - at(1, 1) * at(0, 2);
    const float s4 = at(0, 1) * at(1, 3) - at(1, 1) * at(0, 3), s5 = at(0, 2) * at(1, 3) - at(1, 2) * at(0, 3);
    const float c0 = at(2, 0) * at(3, 1) - at(3, 0) * at(2, 1), c1 = at(2, 0) * at(3, 2) - at(3, 0) * at(2, 2);
    const float c2 = at(2, 0) * at(3, 3) - at(3, 0) * at(2, 3), c3 = at(2, 1) * at(3, 2) - at(3, 1) * at(2, 2);
    const float c4 = at(2, 1) * at(3, 3) - at(3, 1) * at(2, 3), c5 = at(2, 2) * at(3, 3) - at(3, 2) * at(2, 3);
    const float k = 1 / (s0 * c5 - s1 * c4 + s2 * c3 + s3 * c2 - s4 * c1 + s5 * c0);
    mat4 n;
    n[0] = vec4{at(1, 1) * c5 - at(1, 2) * c4 + at(1, 3) * c3, -at(1, 0) * c5 + at(1, 2) * c2 - at(1, 3) * c1,
                at(1, 0) * c4 - at(1, 1) * c2 + at(1, 3) * c0, -at(1, 0) * c3 + at(1, 1) * c1 - at(1, 2) * c0} *
           k;
    n[1] = vec4{-at(0, 1) * c5 + at(0, 2) * c4 - at(0, 3) * c3, at(0, 0) * c5 - at(0, 2) * c2 + at(0, 3) * c1,
                -at(0, 0) * c4 + at(0, 1) * c2 - at(0, 3) * c0, at(0, 0) * c3 - at(0, 1) * c1 + at(0, 2) * c0} *
           k;
    n[2] = vec4{at(3, 1) * s5 - at(3, 2) * s4 + at(3, 3) * s3, -at(3, 0) * s5 + at(3, 2) * s2 - at(3, 3) * s1,
                at(3, 0) * s4 - at(3, 1) * s2 + at(3, 3) * s0, -at(3, 0) * s3 + at(3, 1) * s1 - at(3, 2) * s0} *
           k;
    n[3] = vec4{-at(2, 1) * s5 + at(2, 2) * s4 - at(2, 3) * s3, at(2, 0) * s5 - at(2, 2) * s2 + at(2, 3) * s1,
                -at(2, 0) * s4 + at(2, 1) * s2 - at(2, 3) * s0, at(2, 0) * s3 - at(2, 1) * s1 + at(2, 2) * s0} *
           k;
    return n;
}

}  // namespace braitenlab::maths
