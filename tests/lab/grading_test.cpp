#include "app/jobs/grading.h"

#include <gtest/gtest.h>

#include "core/lesson/exercise_file.h"

namespace braitenlab::tests::grading_test {
namespace {

TEST(Grading, GivesTheSameGradeAsGradingOneStartAfterTheOther) {
    auto exercise = load_exercise(std::filesystem::path(BRAITENLAB_SOURCE) / "exercises/guided/05-aggressor.toml");
    ASSERT_TRUE(exercise) << exercise.error().text();
    const auto shared = std::make_shared<const Exercise>(*exercise);
    const Submission half = with_brain(*shared, make_graph({.LR = 0.4f, .RL = 0.4f, .LM = 0.2f, .RM = 0.2f}));
    const Grade serial = grade(*shared, half);
    ASSERT_GT(serial.count, 0);
    ASSERT_LT(serial.count, shared->starts) << "the starts differ";
    for (const int threads : {0, 1, 3}) {
        Jobs jobs(threads);
        auto first = submit_grading(jobs, shared, half), second = submit_grading(jobs, shared, as_shipped(*shared));
        jobs.finish();
        EXPECT_EQ(passed_starts(**first.take()), passed_starts(serial)) << threads;
        EXPECT_EQ((*second.take())->count, 0) << threads;
    }
}

}  // namespace
}  // namespace braitenlab::tests::grading_test
