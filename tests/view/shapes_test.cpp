#include "render/view/shapes.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "render/view/fine_shapes.h"

namespace braitenlab::tests::shapes_test {
namespace {

using namespace render;

using maths::vec3;

std::vector<Shape> all_shapes() {
    std::vector<Shape> shapes{wheel_shape(), wheel_shape(Mesh::coarse)};
    for (const Role role : {Role::none, Role::predator, Role::prey}) {
        shapes.push_back(hull_shape(role));
        shapes.push_back(hull_shape(role, Mesh::coarse));
        shapes.push_back(sign_shape(role));
    }
    for (const Channel c : {Channel::light, Channel::heat, Channel::smell, Channel::oxygen})
        shapes.push_back(source_shape(c));
    return shapes;
}

std::vector<Shape> fine_shapes() {
    std::vector<Shape> shapes{tyre_shape(), eyeball_shape()};
    for (const Role role : {Role::none, Role::predator, Role::prey}) shapes.push_back(fine_hull_shape(role));
    for (const Channel c : {Channel::light, Channel::heat, Channel::smell, Channel::oxygen})
        shapes.push_back(fine_source_shape(c));
    return shapes;
}

std::vector<Shape> every_shape() {
    std::vector<Shape> shapes = all_shapes();
    for (const Shape& shape : fine_shapes()) shapes.push_back(shape);
    return shapes;
}

TEST(Shapes, WindCounterClockwiseSeenAgainstTheirNormals) {
    for (const Shape& shape : every_shape())
        for (std::size_t i = 0; i < shape.indices.size(); i += 3) {
            const Corner &a = shape.corners[shape.indices[i]], &b = shape.corners[shape.indices[i + 1]],
                         &c = shape.corners[shape.indices[i + 2]];
            const vec3 winding = maths::normalise(maths::cross(b.place - a.place, c.place - a.place));
            EXPECT_GT(maths::dot(winding, a.normal + b.normal + c.normal), 0) << a.place << b.place << c.place;
        }
}

TEST(Shapes, HaveNormalsOfLengthOne) {
    for (const Shape& shape : every_shape())
        for (const Corner& corner : shape.corners) EXPECT_NEAR(maths::length(corner.normal), 1, 1e-4);
}

TEST(Shapes, AreCheapEnoughForASoftwareRenderer) {
    for (const Shape& shape : all_shapes()) EXPECT_LT(shape.indices.size() / 3, 320U);
}

TEST(Shapes, HaveCoarseMeshesOfLessThanSixtyPercentOfTheTriangles) {
    EXPECT_LT(wheel_shape(Mesh::coarse).indices.size() * 2, wheel_shape().indices.size());
    for (const Role role : {Role::none, Role::predator, Role::prey})
        EXPECT_LT(hull_shape(role, Mesh::coarse).indices.size() * 10, hull_shape(role).indices.size() * 6);
}

TEST(Shapes, HaveRoundedMeshesOfAThousandTrianglesAtMost) {
    for (const Shape& shape : fine_shapes()) EXPECT_LT(shape.indices.size() / 3, 1000U);
}

// shaders/hull.vert divides by this width, so that the gauge is full at energy 1 and empty at 0.
TEST(Shapes, HaveAnEnergyGaugeOfTheWidthThatTheShaderExpects) {
    const auto half_width = [](const Shape& shape) {
        float widest = 0;
        for (const Corner& corner : shape.corners)
            if (corner.paint == static_cast<float>(Paint::gauge)) widest = std::max(widest, std::fabs(corner.place.y));
        return widest;
    };
    for (const Role role : {Role::none, Role::predator, Role::prey}) {
        EXPECT_NEAR(half_width(hull_shape(role)), 0.32f, 0.002f);
        EXPECT_NEAR(half_width(fine_hull_shape(role)), 0.264f, 0.002f);
    }
}

// On a rounded body the normals of neighbouring triangles are shared, so no edge of it is sharp.
TEST(Shapes, HaveSmoothNormalsOnRoundedBodies) {
    for (const Role role : {Role::none, Role::predator, Role::prey}) {
        const Shape shape = fine_hull_shape(role);
        for (std::size_t i = 0; i < shape.indices.size(); i += 3) {
            const Corner& a = shape.corners[shape.indices[i]];
            if (a.paint != static_cast<float>(Paint::body)) continue;
            for (const std::size_t k : {i + 1, i + 2})
                EXPECT_GT(maths::dot(a.normal, shape.corners[shape.indices[k]].normal), 0.6f) << a.place;
        }
    }
}

TEST(Shapes, HaveATyreWithTreadBlocksAtEqualAngles) {
    const Shape tyre = tyre_shape();
    int outer = 0;  // corners of the blocks' outer faces
    for (const Corner& c : tyre.corners)
        outer += c.paint == static_cast<float>(Paint::deck) && std::hypot(c.place.x, c.place.z) > 0.99f;
    EXPECT_EQ(outer, 4 * tread_blocks);
}

TEST(Shapes, KeepRoundedBodiesBetweenTheWheels) {
    for (const Role role : {Role::none, Role::predator, Role::prey})
        for (const Corner& c : fine_hull_shape(role).corners) {
            EXPECT_LE(std::fabs(c.place.x), 0.5f);
            if (std::fabs(c.place.x) < 0.16f) {
                EXPECT_LE(std::fabs(c.place.y) * 0.7f, 0.265f) << c.place;
            }
        }
}

TEST(Shapes, KeepSignsToFewTriangles) {
    for (const Role role : {Role::none, Role::predator, Role::prey}) {
        EXPECT_LE(sign_shape(role).indices.size() / 3, 8U);
    }
}

float width_at_the_nose(const Shape& shape) {
    float widest = 0;
    for (const Corner& c : shape.corners)
        if (c.place.x > 0.46f && c.paint != static_cast<float>(Paint::mark)) widest = std::max(widest, c.place.y);
    return widest;
}

TEST(Shapes, GivePredatorsAWedgePreyARoundAndOthersASquareNose) {
    EXPECT_LT(width_at_the_nose(hull_shape(Role::predator)), 0.12f);
    EXPECT_GT(width_at_the_nose(hull_shape(Role::prey)), width_at_the_nose(hull_shape(Role::predator)));
    EXPECT_GT(width_at_the_nose(hull_shape(Role::none)), width_at_the_nose(hull_shape(Role::prey)));
    EXPECT_LT(width_at_the_nose(fine_hull_shape(Role::predator)), 0.25f);
    EXPECT_GT(width_at_the_nose(fine_hull_shape(Role::prey)), width_at_the_nose(fine_hull_shape(Role::predator)));
    EXPECT_GT(width_at_the_nose(fine_hull_shape(Role::none)), width_at_the_nose(fine_hull_shape(Role::prey)));
}

TEST(Shapes, HaveRimsAroundTheWholeBody) {
    for (const Role role : {Role::none, Role::predator, Role::prey}) {
        float widest = 0, longest = 0;
        for (const Corner& c : rim_shape(role).corners) {
            EXPECT_NEAR(maths::length(c.normal), 1, 1e-4);
            EXPECT_GT(maths::dot(c.normal, vec3{c.place.x, c.place.y, 0}), 0);
            EXPECT_GE(c.place.z, 1);
            widest = std::max(widest, std::fabs(c.place.y)), longest = std::max(longest, std::fabs(c.place.x));
        }
        EXPECT_EQ(widest, 0.5f);  // the wheels are inside
        EXPECT_EQ(longest, 0.5f);
        EXPECT_LT(rim_shape(role).indices.size() / 3, 130U);
    }
}

TEST(Shapes, KeepHullsInsideTheirBody) {
    for (const Role role : {Role::none, Role::predator, Role::prey})
        for (const Corner& c : hull_shape(role).corners) {
            if (c.paint == static_cast<float>(Paint::mark)) continue;  // the arrowhead, which the shader sizes
            EXPECT_LE(std::fabs(c.place.x), 0.5001f);
            EXPECT_LE(std::fabs(c.place.y), 0.5001f);
        }
}

}  // namespace
}  // namespace braitenlab::tests::shapes_test
