// The path of one vehicle of a run of an exercise.
#include "core/lesson/reference.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/lesson/exercise_file.h"
#include "core/lesson/submission.h"

namespace braitenlab::tests::reference_test {
namespace {

Exercise shipped(const char* name) {
    auto exercise = load_exercise(std::string(BRAITENLAB_SOURCE) + "/exercises/guided/" + name + ".toml");
    EXPECT_TRUE(exercise) << exercise.error().text();
    return *exercise;
}

float distance_to_lamp(const Pose& pose) { return std::hypot(pose.x, pose.y); }

TEST(Reference, FollowsTheFirstVehicleWithTheSolution) {
    const Exercise orbit = shipped("13-orbit");
    Reference solution(orbit, 1);
    Reference as_it_came(orbit, as_shipped(orbit), 0, 1);
    const ReferencePath path = solution.until(3000), other = as_it_came.until(3000);
    ASSERT_EQ(path.size(), 3001u);
    EXPECT_EQ(path.front().x, other.front().x) << "the same start";
    EXPECT_NEAR(distance_to_lamp(path.back()), 3.5f, 0.5f);
    EXPECT_LT(distance_to_lamp(other.back()), 3);
}

TEST(Reference, FollowsTheVehicleOfAnotherStart) {
    const Exercise circle = shipped("02-circle");
    const ReferencePath red = Reference(circle, as_shipped(circle), 1, 1).until(60);
    EXPECT_FLOAT_EQ(red.front().x, 2.7f);
    EXPECT_TRUE(Reference(circle, as_shipped(circle), 2, 1).until(60).empty()) << "there are two starts";
}

TEST(Reference, HasTheStartOfItsSeed) {
    const Exercise drive = shipped("01-drive");
    const ReferencePath one = Reference(drive, 1).until(0), other = Reference(drive, 2).until(0);
    ASSERT_EQ(one.size(), 1u);
    ASSERT_EQ(other.size(), 1u);
    EXPECT_NE(one.front().heading, other.front().heading);
}

}  // namespace
}  // namespace braitenlab::tests::reference_test
