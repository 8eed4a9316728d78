// 4x4 matrices in OpenGL's conventions: column vectors, column-major storage, clip volume -1..1.
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
constexpr mat4& operator*=(mat4& a, const mat4& b) { return a = a * b; }

// Elementwise.
constexpr mat4& operator+=(mat4& a, const mat4& b) {
    for (int i = 0; i < 4; ++i) a[i] += b[i];
    return a;
}
constexpr mat4& operator-=(mat4& a, const mat4& b) {
    for (int i = 0; i < 4; ++i) a[i] -= b[i];
    return a;
}
constexpr mat4& operator*=(mat4& a, float s) {
    for (int i = 0; i < 4; ++i) a[i] *= s;
    return a;
}
constexpr mat4& operator/=(mat4& a, float s) {
    for (int i = 0; i < 4; ++i) a[i] /= s;
    return a;
}
constexpr mat4 operator+(mat4 a, const mat4& b) { return a += b; }
constexpr mat4 operator-(mat4 a, const mat4& b) { return a -= b; }
constexpr mat4 operator-(mat4 a) { return a *= -1.0f; }
constexpr mat4 operator*(mat4 a, float s) { return a *= s; }
constexpr mat4 operator*(float s, mat4 a) { return a *= s; }
constexpr mat4 operator/(mat4 a, float s) { return a /= s; }

inline bool almost_equal(const mat4& a, const mat4& b, float tolerance) {
    for (int i = 0; i < 4; ++i)
        if (!almost_equal(a[i], b[i], tolerance)) return false;
    return true;
}

// Writes the columns as vectors.
inline std::ostream& operator<<(std::ostream& out, const mat4& m) {
    return out << '(' << m[0] << ", " << m[1] << ", " << m[2] << ", " << m[3] << ')';
}

// Model matrices: translation, scaling along the axes, and rotation by an angle (rad) about a unit axis,
// counter-clockwise when the axis points at the viewer (Rodrigues' formula).
constexpr mat4 translation(vec3 by) {
    mat4 m;
    m[3] = {by.x, by.y, by.z, 1};
    return m;
}
constexpr mat4 scaling(vec3 by) {
    mat4 m;
    m[0].x = by.x, m[1].y = by.y, m[2].z = by.z;
    return m;
}
inline mat4 rotation(float angle, vec3 axis) {
    const float c = std::cos(angle), s = std::sin(angle), k = 1 - c;
    mat4 m;
    m[0] = {c + k * axis.x * axis.x, k * axis.x * axis.y + s * axis.z, k * axis.x * axis.z - s * axis.y, 0};
    m[1] = {k * axis.x * axis.y - s * axis.z, c + k * axis.y * axis.y, k * axis.y * axis.z + s * axis.x, 0};
    m[2] = {k * axis.x * axis.z + s * axis.y, k * axis.y * axis.z - s * axis.x, c + k * axis.z * axis.z, 0};
    return m;
}

// View matrix of an eye that looks at the target. `up` must not be parallel to the line of sight.
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

// Maps the box left..right, bottom..top, near..far (distances in front of the eye) to the clip volume.
constexpr mat4 orthographic(float left, float right, float bottom, float top, float near, float far) {
    mat4 m;
    m[0] = {2 / (right - left), 0, 0, 0};
    m[1] = {0, 2 / (top - bottom), 0, 0};
    m[2] = {0, 0, 2 / (near - far), 0};
    m[3] = {(right + left) / (left - right), (top + bottom) / (bottom - top), (far + near) / (near - far), 1};
    return m;
}

namespace detail {

// The 2x2 minors of the upper two rows (s) and of the lower two (c): Laplace expansion along pairs of rows.
struct Minors {
    explicit constexpr Minors(const mat4& m) {
        const int left[6] = {0, 0, 0, 1, 1, 2}, right[6] = {1, 2, 3, 2, 3, 3};
        for (int i = 0; i < 6; ++i) {
            const vec4 &a = m[left[i]], &b = m[right[i]];
            s[i] = a.x * b.y - a.y * b.x;
            c[i] = a.z * b.w - a.w * b.z;
        }
    }
    constexpr float determinant() const {
        return s[0] * c[5] - s[1] * c[4] + s[2] * c[3] + s[3] * c[2] - s[4] * c[1] + s[5] * c[0];
    }
    float s[6]{}, c[6]{};
};

}  // namespace detail

constexpr float determinant(const mat4& m) { return detail::Minors(m).determinant(); }

// Inverse by cofactors. Contains infinities or NaNs for a singular matrix.
inline mat4 inverse(const mat4& m) {
    const detail::Minors minors(m);
    const auto &s = minors.s, &c = minors.c;
    const float k = 1 / minors.determinant();
    const vec4 &p = m[0], &q = m[1], &r = m[2], &t = m[3];
    mat4 n;
    n[0] = vec4{q.y * c[5] - r.y * c[4] + t.y * c[3], -p.y * c[5] + r.y * c[2] - t.y * c[1],
                p.y * c[4] - q.y * c[2] + t.y * c[0], -p.y * c[3] + q.y * c[1] - r.y * c[0]} *
           k;
    n[1] = vec4{-q.x * c[5] + r.x * c[4] - t.x * c[3], p.x * c[5] - r.x * c[2] + t.x * c[1],
                -p.x * c[4] + q.x * c[2] - t.x * c[0], p.x * c[3] - q.x * c[1] + r.x * c[0]} *
           k;
    n[2] = vec4{q.w * s[5] - r.w * s[4] + t.w * s[3], -p.w * s[5] + r.w * s[2] - t.w * s[1],
                p.w * s[4] - q.w * s[2] + t.w * s[0], -p.w * s[3] + q.w * s[1] - r.w * s[0]} *
           k;
    n[3] = vec4{-q.z * s[5] + r.z * s[4] - t.z * s[3], p.z * s[5] - r.z * s[2] + t.z * s[1],
                -p.z * s[4] + q.z * s[2] - t.z * s[0], p.z * s[3] - q.z * s[1] + r.z * s[0]} *
           k;
    return n;
}

}  // namespace braitenlab::maths
