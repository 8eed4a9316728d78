#include <cmath>

#include <gtest/gtest.h>

#include "ui/scene_input/polygon_tool.h"

namespace braitenlab::tests::stage_outline_test {

using namespace ui;
namespace {

using maths::vec2;
using Corners = std::vector<vec2>;

TEST(PolygonTool, AcceptsCornersInBothDirections) {
    for (const Corners& drawn : {Corners{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, Corners{{0, 2}, {2, 2}, {2, 0}, {0, 0}}}) {
        Corners corners;
        for (const vec2 next : drawn) {
            EXPECT_EQ(fault_of_next(corners, next), OutlineFault::none);
            corners.push_back(next);
        }
        EXPECT_EQ(fault_of(corners), OutlineFault::none);
    }
}

TEST(PolygonTool, RefusesACornerThatMakesTheOutlineCrossedConcaveOrTooNarrow) {
    const Corners square{{0, 0}, {2, 0}, {2, 2}};
    EXPECT_EQ(fault_of_next(square, {1, -1}), OutlineFault::crosses);
    EXPECT_EQ(fault_of_next(square, {1.5f, 0.7f}), OutlineFault::dents);
    EXPECT_EQ(fault_of_next(square, {2, 1.95f}), OutlineFault::too_near);
    EXPECT_EQ(fault_of_next(square, {0, 2}), OutlineFault::none);
}

TEST(PolygonTool, RefusesAStarWhoseCornersTurnInOneDirection) {
    Corners star;
    for (int i = 0; i < 5; ++i) {
        const float angle = 2.5132741f * static_cast<float>(i);  // 144 degrees
        star.push_back({std::cos(angle), std::sin(angle)});
    }
    EXPECT_EQ(fault_of(star), OutlineFault::crosses);
}

TEST(PolygonTool, HasThreeToEightCorners) {
    Corners round;
    EXPECT_EQ(fault_of({{0, 0}, {1, 0}}), OutlineFault::too_few);
    for (int i = 0; i < 8; ++i)
        round.push_back(
            {3 * std::cos(0.7853982f * static_cast<float>(i)), 3 * std::sin(0.7853982f * static_cast<float>(i))});
    EXPECT_EQ(fault_of(round), OutlineFault::none);
    EXPECT_EQ(fault_of_next(round, {3, -0.5f}), OutlineFault::too_many);
}

TEST(PolygonTool, RefusesANarrowOutline) {
    EXPECT_EQ(fault_of({{0, 0}, {3, 0}, {1.5f, 0.05f}}), OutlineFault::too_narrow);
    EXPECT_EQ(fault_of({{0, 0}, {1, 1}, {2, 2}}), OutlineFault::too_narrow) << "all in a line";
    EXPECT_EQ(fault_of({{0, 0}, {3, 0}, {1.5f, 0.2f}}), OutlineFault::none);
}

TEST(PolygonTool, MakesACounterClockwiseObstacleAroundItsCentroid) {
    const Obstacle made = obstacle_from({{1, 4}, {4, 1}, {1, 1}});  // clockwise
    EXPECT_NEAR(made.x, 2, 1e-5f);
    EXPECT_NEAR(made.y, 2, 1e-5f);
    EXPECT_NEAR(made.length, 3, 1e-5f);
    ASSERT_EQ(made.corners.size(), 3u);
    float twice_the_area = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const PolygonCorner &a = made.corners[i], &b = made.corners[(i + 1) % 3];
        twice_the_area += a.x * b.y - a.y * b.x;
    }
    EXPECT_NEAR(twice_the_area, 9, 1e-4f);
}

TEST(PolygonTool, GivesAZoneAnOutlineAndKeepsItsHeading) {
    const Obstacle outline = obstacle_from({{0, 0}, {3, 0}, {0, 3}});
    const Zone zone = with_outline({.heading = 1.5707963f, .round = true, .slope = 0.2f}, outline);
    EXPECT_NEAR(zone.x, 1, 1e-5f);
    EXPECT_NEAR(zone.heading, 1.5707963f, 1e-5f) << "a slope falls along it";
    EXPECT_EQ(zone.slope, 0.2f);
    EXPECT_FALSE(zone.round);
    ASSERT_EQ(zone.corners.size(), 3u);
    EXPECT_NEAR(zone.corners[1].x, -1, 1e-4f) << "2 m to the east and 1 m to the south, seen to the north";
    EXPECT_NEAR(zone.corners[1].y, -2, 1e-4f);
}

TEST(PolygonTool, MakesAZoneOfTwoMetresFromOnePoint) {
    const Zone zone = zone_between({1, 2}, {1, 2});
    EXPECT_EQ(zone.x, 1);
    EXPECT_EQ(zone.length, 2);
    EXPECT_EQ(zone_between({0, 0}, {4, -1}).length, 4);
}

TEST(PolygonTool, MakesABoxFromAnyTwoOppositeCorners) {
    const Obstacle a = box_between({1, 2}, {4, -2}), b = box_between({4, -2}, {1, 2});
    EXPECT_EQ(a, b);
    EXPECT_FLOAT_EQ(a.x, 2.5f);
    EXPECT_FLOAT_EQ(a.length, 3);
    EXPECT_FLOAT_EQ(a.width, 4);
    EXPECT_FLOAT_EQ(box_between({0, 0}, {0, 0}).length, 0.2f) << "at least the smallest size that can be picked";
}

}  // namespace
}  // namespace braitenlab::tests::stage_outline_test
