#include "core/lesson/resemblance.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "core/lesson/exercise_file.h"
#include "core/lesson/submission.h"

namespace braitenlab::tests::resemblance_test {
namespace {

Exercise loaded(const std::string& name) {
    const auto path = std::filesystem::path(BRAITENLAB_SOURCE) / "exercises" / "guided" / (name + ".toml");
    const auto exercise = load_exercise(path);
    EXPECT_TRUE(exercise) << exercise.error().text();
    return *exercise;
}

// The submission with all weights a little smaller.
Submission weaker(Submission submission, float share) {
    for (Wire& wire : submission.brain.wires) wire.weight *= 1 - share;
    return submission;
}

}  // namespace

TEST(Resemblance, IsZeroForTheSameBehaviourAndLargeForOpposites) {
    const Exercise exercise = loaded("05-aggressor");
    const Grade solution = grade(exercise, with_solution(exercise)), shipped = grade(exercise, as_shipped(exercise));
    EXPECT_EQ(behaviour_distance(solution, solution), 0);
    EXPECT_GT(behaviour_distance(solution, shipped), 0.4f);
    EXPECT_EQ(behaviour_distance(solution, shipped), behaviour_distance(shipped, solution));
}

TEST(Resemblance, NamesTheWrongAnswerThatASlightlyWeakerBrainBehavesLike) {
    for (const char* name : {"05-aggressor", "06-love"}) {
        const Exercise exercise = loaded(name);
        std::vector<Grade> wrong;
        for (const Answer& answer : exercise.wrong) wrong.push_back(grade(exercise, answer.submission));
        for (std::size_t i = 0; i < wrong.size(); ++i) {
            const Grade near = grade(exercise, weaker(exercise.wrong[i].submission, 0.05f));
            ASSERT_FALSE(near.good) << name << ": " << exercise.wrong[i].name;
            EXPECT_EQ(most_alike(near, wrong), i) << name << ": " << exercise.wrong[i].name;
        }
        EXPECT_FALSE(most_alike(grade(exercise, with_solution(exercise)), wrong)) << name;
    }
}

// A grade of one start with one step.
Grade graded(bool done, float value, std::vector<maths::vec2> path) {
    return {{{.seed = 1, .passed = done, .verdicts = {{done, {{.value = value}}}}, .path = std::move(path)}}, 0, false};
}

TEST(Resemblance, StepsWeighHalfAndPathsAndValuesAQuarterEach) {
    const std::vector<maths::vec2> right{{0, 0}, {1, 0}, {2, 0}}, up{{0, 0}, {0, 1}, {0, 2}}, far{{0, 90}, {0, 91}};
    const Grade first = graded(false, 1, right);
    EXPECT_FLOAT_EQ(behaviour_distance(first, graded(true, 1, right)), 0.5f);
    EXPECT_FLOAT_EQ(behaviour_distance(first, graded(false, 1, far)), 0.25f);
    EXPECT_FLOAT_EQ(behaviour_distance(first, graded(false, 0.5f, right)), 0.125f);
    EXPECT_FLOAT_EQ(behaviour_distance(first, graded(true, -1, far)), 1);
    EXPECT_NEAR(behaviour_distance(first, graded(false, 1, {{0, 0}, {2, 0}, {1, 0}, {2, 0}})), 0, 1e-6)
        << "speed has no effect";
    EXPECT_NEAR(behaviour_distance(first, graded(false, 1, up)), 0.25f, 0.001f);
}

TEST(Resemblance, ADistanceOfPathsIsInProportionToTheirSize) {
    std::vector<maths::vec2> far, beside;
    for (int i = 0; i <= 20; ++i)
        far.push_back({static_cast<float>(i), 0}), beside.push_back({static_cast<float>(i), 1});
    EXPECT_NEAR(behaviour_distance(graded(false, 1, far), graded(false, 1, beside)), 0.25f * 2 / 20, 0.001f);
}

}  // namespace braitenlab::tests::resemblance_test
