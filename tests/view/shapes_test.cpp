#include "render/view/shapes.h"

#include <gtest/gtest.h>

namespace braitenlab::tests::shapes_test {
namespace {

using namespace render;

using maths::vec3;

std::vector<Shape> all_shapes() {
    std::vector<Shape> shapes{wheel_shape(), eye_shape()};
    for (const Role role : {Role::none, Role::predator, Role::prey}) {
        shapes.push_back(hull_shape(role));
        shapes.push_back(sign_shape(role));
    }
    for (const Channel c : {Channel::light, Channel::heat, Channel::smell, Channel::oxygen})
        shapes.push_back(source_shape(c));
    return shapes;
}

TEST(Shapes, WindCounterClockwiseSeenAgainstTheirNormals) {
    for (const Shape& shape : all_shapes())
        for (std::size_t i = 0; i < shape.indices.size(); i += 3) {
            const Corner &a = shape.corners[shape.indices[i]], &b = shape.corners[shape.indices[i + 1]],
                         &c = shape.corners[shape.indices[i + 2]];
            const vec3 winding = maths::normalise(maths::cross(b.place - a.place, c.place - a.place));
            EXPECT_GT(maths::dot(winding, a.normal + b.normal + c.normal), 0) << a.place << b.place << c.place;
        }
}

TEST(Shapes, HaveNormalsOfLengthOne) {
    for (const Shape& shape : all_shapes())
        for (const Corner& corner : shape.corners) EXPECT_NEAR(maths::length(corner.normal), 1, 1e-4);
}

TEST(Shapes, AreCheapEnoughForASoftwareRenderer) {
    for (const Shape& shape : all_shapes()) EXPECT_LT(shape.indices.size() / 3, 320U);
}

TEST(Shapes, KeepSignsToFewTriangles) {
    for (const Role role : {Role::none, Role::predator, Role::prey}) {
        EXPECT_LE(sign_shape(role).indices.size() / 3, 8U);
    }
}

float width_at_the_nose(Role role) {
    float widest = 0;
    for (const Corner& c : hull_shape(role).corners)
        if (c.place.x > 0.46f && c.paint != static_cast<float>(Paint::mark)) widest = std::max(widest, c.place.y);
    return widest;
}

TEST(Shapes, GivePredatorsAWedgePreyARoundAndOthersASquareNose) {
    EXPECT_LT(width_at_the_nose(Role::predator), 0.12f);
    EXPECT_GT(width_at_the_nose(Role::prey), width_at_the_nose(Role::predator));
    EXPECT_GT(width_at_the_nose(Role::none), width_at_the_nose(Role::prey));
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
