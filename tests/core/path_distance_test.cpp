// How much two paths on the floor differ.
#include "core/lesson/path_distance.h"

#include <cmath>

#include <gtest/gtest.h>

namespace braitenlab::tests::path_distance_test {
namespace {

using maths::vec2;

std::vector<vec2> circle(float radius, int rounds) {
    std::vector<vec2> points;
    for (int i = 0; i <= 60 * rounds; ++i)
        points.push_back(
            {radius * std::cos(static_cast<float>(i) * 0.10472f), radius * std::sin(static_cast<float>(i) * 0.10472f)});
    return points;
}

const std::vector<vec2> straight{{0, 0}, {4, 0}};

TEST(PathDistance, IsTheDistanceOfParallelLines) {
    EXPECT_NEAR(path_distance(straight, std::vector<vec2>{{0, 0.6f}, {4, 0.6f}}), 0.6f, 0.001f);
    EXPECT_NEAR(path_distance(circle(2, 1), circle(1.5f, 1)), 0.5f, 0.01f);
}

TEST(PathDistance, DoesNotDependOnTheNumberOfPointsAndTheirTimes) {
    const std::vector<vec2> slow_first{{0, 0}, {0.01f, 0}, {0.02f, 0}, {0.03f, 0}, {4, 0}};
    EXPECT_NEAR(path_distance(straight, slow_first), 0, 0.01f);
    EXPECT_NEAR(path_distance(circle(2, 1), circle(2, 3)), 0, 0.02f) << "more rounds of the same circle";
}

TEST(PathDistance, CountsWhatOnePathHasInAdditionHoweverTheyAreOrdered) {
    const std::vector<vec2> half{{0, 0}, {2, 0}};
    // The second half is 1 m away on average: the mean of 0.5 and 0.
    EXPECT_NEAR(path_distance(straight, half), 0.25f, 0.01f);
    EXPECT_FLOAT_EQ(path_distance(half, straight), path_distance(straight, half));
}

TEST(PathDistance, TakesAPathOfOnePointAndNoPath) {
    const std::vector<vec2> place{{0, 3}};
    EXPECT_FLOAT_EQ(path_distance(place, place), 0);
    EXPECT_NEAR(path_distance(place, std::vector<vec2>{{0, 4}, {0, 4}}), 1, 1e-5);
    EXPECT_FLOAT_EQ(path_distance({}, straight), 0);
}

TEST(PathDistance, KnowsAPathThatIsDrivenTheOtherWayRound) {
    const std::vector<vec2> ring = circle(2, 1), back(ring.rbegin(), ring.rend());
    EXPECT_NEAR(path_distance(ring, back), 0, 0.02f) << "the shape is the same";
    EXPECT_TRUE(runs_against(ring, back));
    EXPECT_FALSE(runs_against(ring, circle(1.5f, 2)));
    EXPECT_FALSE(runs_against(straight, std::vector<vec2>{{0, 0}, {0, 4}})) << "across";
    EXPECT_FALSE(runs_against(straight, {}));
    EXPECT_FALSE(runs_against(straight, std::vector<vec2>{{1, 1}}));
}

TEST(PathDistance, PositionsEndAtTheLastPose) {
    const ReferencePath path{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}};
    EXPECT_EQ(positions(path, 4, 2), (std::vector<vec2>{{0, 0}, {2, 0}, {3, 0}}));
    EXPECT_EQ(positions(path, 9, 2), (std::vector<vec2>{{0, 0}, {2, 0}, {4, 0}}));
    EXPECT_TRUE(positions(path, 0, 2).empty());
    EXPECT_FLOAT_EQ(path_length(straight), 4);
}

}  // namespace
}  // namespace braitenlab::tests::path_distance_test
