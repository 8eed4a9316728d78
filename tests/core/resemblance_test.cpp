#include "core/lesson/resemblance.h"

#include <filesystem>

#include <gtest/gtest.h>

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

}  // namespace braitenlab::tests::resemblance_test
