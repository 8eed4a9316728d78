// Vectors of two, three and four floats.
//
// Operations are componentwise unless a comment states otherwise.
#pragma once

#include <cmath>
#include <ostream>

namespace braitenlab::maths {

struct vec2 {
    float x = 0, y = 0;
    constexpr float& operator[](int i) { return i == 0 ? x : y; }
    constexpr float operator[](int i) const { return i == 0 ? x : y; }
    friend constexpr bool operator==(const vec2&, const vec2&) = default;
};

struct vec3 {
    float x = 0, y = 0, z = 0;
    constexpr float& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }
    constexpr float operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
    friend constexpr bool operator==(const vec3&, const vec3&) = default;
};

struct vec4 {
    float x = 0, y = 0, z = 0, w = 0;
    constexpr float& operator[](int i) { return i == 0 ? x : i == 1 ? y : i == 2 ? z : w; }
    constexpr float operator[](int i) const { return i == 0 ? x : i == 1 ? y : i == 2 ? z : w; }
    friend constexpr bool operator==(const vec4&, const vec4&) = default;
};

constexpr vec2 operator+(vec2 a, vec2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr vec2 operator-(vec2 a, vec2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr vec2 operator-(vec2 a) { return {-a.x, -a.y}; }
constexpr vec2 operator*(vec2 a, float s) { return {a.x * s, a.y * s}; }
constexpr vec2 operator*(float s, vec2 a) { return a * s; }
constexpr vec2 operator/(vec2 a, float s) { return {a.x / s, a.y / s}; }
constexpr vec2& operator+=(vec2& a, vec2 b) { return a = a + b; }
constexpr vec2& operator-=(vec2& a, vec2 b) { return a = a - b; }
constexpr vec2& operator*=(vec2& a, float s) { return a = a * s; }
constexpr vec2& operator/=(vec2& a, float s) { return a = a / s; }

constexpr vec3 operator+(vec3 a, vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr vec3 operator-(vec3 a, vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr vec3 operator-(vec3 a) { return {-a.x, -a.y, -a.z}; }
constexpr vec3 operator*(vec3 a, float s) { return {a.x * s, a.y * s, a.z * s}; }
constexpr vec3 operator*(float s, vec3 a) { return a * s; }
constexpr vec3 operator/(vec3 a, float s) { return {a.x / s, a.y / s, a.z / s}; }
constexpr vec3& operator+=(vec3& a, vec3 b) { return a = a + b; }
constexpr vec3& operator-=(vec3& a, vec3 b) { return a = a - b; }
constexpr vec3& operator*=(vec3& a, float s) { return a = a * s; }
constexpr vec3& operator/=(vec3& a, float s) { return a = a / s; }

constexpr vec4 operator+(vec4 a, vec4 b) { return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w}; }
constexpr vec4 operator-(vec4 a, vec4 b) { return {a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w}; }
constexpr vec4 operator-(vec4 a) { return {-a.x, -a.y, -a.z, -a.w}; }
constexpr vec4 operator*(vec4 a, float s) { return {a.x * s, a.y * s, a.z * s, a.w * s}; }
constexpr vec4 operator*(float s, vec4 a) { return a * s; }
constexpr vec4 operator/(vec4 a, float s) { return {a.x / s, a.y / s, a.z / s, a.w / s}; }
constexpr vec4& operator+=(vec4& a, vec4 b) { return a = a + b; }
constexpr vec4& operator-=(vec4& a, vec4 b) { return a = a - b; }
constexpr vec4& operator*=(vec4& a, float s) { return a = a * s; }
constexpr vec4& operator/=(vec4& a, float s) { return a = a / s; }

constexpr float dot(vec2 a, vec2 b) { return a.x * b.x + a.y * b.y; }
constexpr float dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr float dot(vec4 a, vec4 b) { return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w; }

// The z component of the 3D cross product: positive when b is counter-clockwise of a.
constexpr float cross(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }
constexpr vec3 cross(vec3 a, vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

inline float length(vec2 a) { return std::sqrt(dot(a, a)); }
inline float length(vec3 a) { return std::sqrt(dot(a, a)); }
inline float length(vec4 a) { return std::sqrt(dot(a, a)); }

inline float distance(vec2 a, vec2 b) { return length(b - a); }
inline float distance(vec3 a, vec3 b) { return length(b - a); }
inline float distance(vec4 a, vec4 b) { return length(b - a); }

// Unit vector along a; the zero vector for the zero vector.
inline vec2 normalise(vec2 a) { return length(a) > 0 ? a / length(a) : a; }
inline vec3 normalise(vec3 a) { return length(a) > 0 ? a / length(a) : a; }
inline vec4 normalise(vec4 a) { return length(a) > 0 ? a / length(a) : a; }

// True when two numbers, or all components, differ by at most `tolerance`. False for NaN.
inline bool almost_equal(float a, float b, float tolerance) { return std::fabs(a - b) <= tolerance; }
inline bool almost_equal(vec2 a, vec2 b, float tolerance) {
    return almost_equal(a.x, b.x, tolerance) && almost_equal(a.y, b.y, tolerance);
}
inline bool almost_equal(vec3 a, vec3 b, float tolerance) {
    return almost_equal(a.x, b.x, tolerance) && almost_equal(a.y, b.y, tolerance) && almost_equal(a.z, b.z, tolerance);
}
inline bool almost_equal(vec4 a, vec4 b, float tolerance) {
    return almost_equal(vec2{a.x, a.y}, {b.x, b.y}, tolerance) && almost_equal(vec2{a.z, a.w}, {b.z, b.w}, tolerance);
}

inline std::ostream& operator<<(std::ostream& out, vec2 a) { return out << '(' << a.x << ", " << a.y << ')'; }
inline std::ostream& operator<<(std::ostream& out, vec3 a) {
    return out << '(' << a.x << ", " << a.y << ", " << a.z << ')';
}
inline std::ostream& operator<<(std::ostream& out, vec4 a) {
    return out << '(' << a.x << ", " << a.y << ", " << a.z << ", " << a.w << ')';
}

}  // namespace braitenlab::maths
