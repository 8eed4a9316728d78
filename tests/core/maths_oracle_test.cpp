// core/maths compared with GLM, an independent library, for each operation on random input.
#define GLM_FORCE_RADIANS
#include <cmath>
#include <sstream>

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "core/maths/angle.h"
#include "core/maths/geometry.h"
#include "core/maths/mat4.h"
#include "core/maths/random.h"

namespace braitenlab::maths {
namespace {

constexpr int rounds = 2000;

struct Oracle : testing::Test {
    Random chance{42, 7};
    float number(float size = 10) { return chance.uniform(-size, size); }
    vec2 two() { return {number(), number()}; }
    vec3 three() { return {number(), number(), number()}; }
    vec4 four() { return {number(), number(), number(), number()}; }
    mat4 matrix() {
        mat4 m;
        for (int c = 0; c < 4; ++c) m[c] = four();
        return m;
    }
};

glm::vec2 to_glm(vec2 v) { return {v.x, v.y}; }
glm::vec3 to_glm(vec3 v) { return {v.x, v.y, v.z}; }
glm::vec4 to_glm(vec4 v) { return {v.x, v.y, v.z, v.w}; }
glm::mat4 to_glm(const mat4& m) { return {to_glm(m[0]), to_glm(m[1]), to_glm(m[2]), to_glm(m[3])}; }

void expect_near(float a, float b, float scale = 1) { EXPECT_NEAR(a, b, 2e-6f * (scale + std::fabs(b))); }
template <class Ours, class Theirs>
void expect_same(const Ours& a, const Theirs& b, float scale = 1) {
    for (int i = 0; i < Theirs::length(); ++i) expect_near(a[i], b[i], scale);
}
void expect_same(const mat4& a, const glm::mat4& b, float scale = 1) {
    for (int c = 0; c < 4; ++c) expect_same(a[c], b[c], scale);
}

// Operations that vectors and matrices share.
template <class V>
void check_sums(V a, V b, float s) {
    const auto ga = to_glm(a), gb = to_glm(b);
    expect_same(a + b, ga + gb);
    expect_same(a - b, ga - gb);
    expect_same(-a, -ga);
    expect_same(a * s, ga * s);
    expect_same(s * a, s * ga);
    expect_same(a / s, ga / s);
    V sum = a, difference = a, product = a, quotient = a;
    expect_same(sum += b, ga + gb);
    expect_same(difference -= b, ga - gb);
    expect_same(product *= s, ga * s);
    expect_same(quotient /= s, ga / s);
    EXPECT_TRUE(a == a);
    EXPECT_FALSE(a == b);
    EXPECT_TRUE(almost_equal(a, a, 0));
    EXPECT_FALSE(almost_equal(a, b, 1e-6f));
}

template <class V>
void check_arithmetic(V a, V b, float s) {
    check_sums(a, b, s);
    const auto ga = to_glm(a), gb = to_glm(b);
    expect_near(dot(a, b), glm::dot(ga, gb), 100);
    expect_near(length(a), glm::length(ga));
    expect_near(distance(a, b), glm::distance(ga, gb));
    expect_same(normalise(a), glm::normalize(ga));
}

TEST_F(Oracle, AgreesOnVectors) {
    for (int i = 0; i < rounds; ++i) {
        const float s = chance.uniform(0.1f, 10);
        check_arithmetic(two(), two(), s);
        check_arithmetic(three(), three(), s);
        check_arithmetic(four(), four(), s);
        const vec3 a = three(), b = three();
        expect_same(cross(a, b), glm::cross(to_glm(a), to_glm(b)), 100);
    }
}

TEST_F(Oracle, AgreesOnSumsProductsDeterminantsAndInverses) {
    for (int i = 0; i < rounds; ++i) {
        const mat4 a = matrix(), b = matrix();
        const vec4 v = four();
        check_sums(a, b, chance.uniform(0.1f, 10));
        mat4 product = a;
        expect_same(product *= b, to_glm(a) * to_glm(b), 300);
        expect_same(a * b, to_glm(a) * to_glm(b), 300);
        expect_same(a * v, to_glm(a) * to_glm(v), 300);
        const float size = glm::determinant(to_glm(a));
        expect_near(determinant(a), size, 20000);
        if (std::fabs(size) > 500) expect_same(inverse(a), glm::inverse(to_glm(a)), 10);
    }
}

TEST_F(Oracle, AgreesOnModelViewAndProjection) {
    const glm::mat4 one(1.0f);
    for (int i = 0; i < rounds; ++i) {
        const vec3 v = three(), eye = three(), target = three(), axis = normalise(three());
        const float angle = number(6);
        expect_same(translation(v), glm::translate(one, to_glm(v)));
        expect_same(scaling(v), glm::scale(one, to_glm(v)));
        expect_same(rotation(angle, axis), glm::rotate(one, angle, to_glm(axis)));
        if (length(cross(normalise(target - eye), {0, 1, 0})) > 0.05f)
            expect_same(look_at(eye, target, {0, 1, 0}), glm::lookAt(to_glm(eye), to_glm(target), glm::vec3(0, 1, 0)),
                        20);
        const float near = chance.uniform(0.01f, 1);
        expect_same(orthographic(-3, 4, -2, 5, near, 50), glm::ortho(-3.0f, 4.0f, -2.0f, 5.0f, near, 50.0f));
    }
}

TEST_F(Oracle, FindsIfAPointIsInsideOrOutside) {
    for (int i = 0; i < rounds; ++i) {
        const vec2 a = two(), b = two(), c = two();
        if (std::fabs(cross(b - a, c - a)) < 1) continue;
        const float u = chance.uniform(0.01f, 0.98f), v = chance.uniform(0.005f, 0.99f - u);
        const vec2 inside = a * u + b * v + c * (1 - u - v), outside = a * -0.05f + b * 0.5f + c * 0.55f;
        EXPECT_TRUE(in_triangle(inside, a, b, c));
        EXPECT_TRUE(in_triangle(inside, c, b, a));
        EXPECT_FALSE(in_triangle(outside, a, b, c));
        const vec3 w = barycentric(inside, a, b, c);
        EXPECT_NEAR(w.x, u, 1e-3f);
        EXPECT_NEAR(w.y, v, 1e-3f);
    }
}

TEST_F(Oracle, FindsDistanceAndAngleOfAPolarPoint) {
    for (int i = 0; i < rounds; ++i) {
        const float angle = chance.uniform(0.1f, 3.0f), distance = chance.uniform(1, 5);
        const Polar back = to_polar(from_polar(distance, angle));
        EXPECT_NEAR(back.distance, distance, 1e-5f);
        EXPECT_NEAR(back.angle, angle, 1e-5f);
    }
}

TEST(Vec, VectorsHaveTheSizeOfTheirFloatsAndCanBePrinted) {
    EXPECT_EQ(sizeof(vec2), 2 * sizeof(float));
    EXPECT_EQ(sizeof(vec3), 3 * sizeof(float));
    EXPECT_EQ(sizeof(vec4), 4 * sizeof(float));
    EXPECT_EQ(sizeof(mat4), 16 * sizeof(float));
    std::ostringstream out;
    out << vec2{1, 2} << vec3{1, 2, 3} << vec4{1, 2, 3, 4.5f};
    EXPECT_EQ(out.str(), "(1, 2)(1, 2, 3)(1, 2, 3, 4.5)");
    out.str("");
    out << mat4{};
    EXPECT_EQ(out.str(), "((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1))");
    vec3 v{1, 2, 3};
    v[1] = 5;
    EXPECT_EQ(v, (vec3{1, 5, 3}));
}

}  // namespace
}  // namespace braitenlab::maths
