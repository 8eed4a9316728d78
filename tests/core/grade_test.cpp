#include "core/lesson/grade.h"

#include <gtest/gtest.h>

#include "core/lesson/exercise_file.h"

namespace braitenlab::tests::grade_test {
namespace {

Exercise aggressor() {
    auto exercise = load_exercise(std::filesystem::path(BRAITENLAB_SOURCE) / "exercises/guided/05-aggressor.toml");
    if (!exercise) throw std::runtime_error(exercise.error().text());
    return *exercise;
}

TEST(Grade, IsRepeatableAndCountsThePassedStarts) {
    const Exercise exercise = aggressor();
    const Submission half = with_brain(exercise, make_graph({.LR = 0.4f, .RL = 0.4f, .LM = 0.2f, .RM = 0.2f}));
    const Grade one = grade(exercise, half), two = grade(exercise, half);
    EXPECT_EQ(passed_starts(one), passed_starts(two));
    EXPECT_TRUE(one.count > 0 && one.count < exercise.starts) << "the starts differ";
    EXPECT_EQ(one.starts.size(), 10u);
    EXPECT_EQ(one.good, one.count >= exercise.needed);
}

TEST(Grade, TheFailedStepIsTheOneThatCannotBeDoneAnyMore) {
    StartResult start;
    start.verdicts = {Verdict{true, {}}, Verdict{false, {}}, Verdict{false, {}, true}};
    EXPECT_EQ(failed_step(start), 2u);
    start.verdicts[2].lost = false;
    EXPECT_EQ(failed_step(start), 1u);
    start.verdicts = {Verdict{true, {}}};
    EXPECT_EQ(failed_step(start), 1u);
}

TEST(Grade, ABrainThatDoesNotCompilePassesNoStart) {
    const Exercise exercise = aggressor();
    EXPECT_EQ(grade(exercise, with_brain(exercise, BrainGraph{})).count, 0);
}

TEST(Grade, OneStartPassesAloneAsItDoesAmongAll) {
    const Exercise exercise = aggressor();
    const Submission half = with_brain(exercise, make_graph({.LR = 0.4f, .RL = 0.4f, .LM = 0.2f, .RM = 0.2f}));
    const Grade all = grade(exercise, half);
    for (const std::uint64_t seed : {10u, 3u, 1u}) EXPECT_EQ(passes(exercise, half, seed), all.starts[seed - 1].passed);
}

TEST(Grade, ATrialInStepsPassesAtTheSameTickAsInOneRun) {
    const Exercise exercise = aggressor();
    for (const Submission& submission : {with_solution(exercise), as_shipped(exercise)}) {
        Trial whole(exercise, submission, 1), stepped(exercise, submission, 1);
        const int limit = static_cast<int>(exercise.seconds) * 60;
        int ticks = 0;
        std::optional<StartResult> result;
        for (; !result && ticks <= limit; ++ticks) result = stepped.run(1);
        ASSERT_TRUE(result);
        const auto at_once = whole.run(ticks), again = stepped.run(1);
        ASSERT_TRUE(at_once && again);
        EXPECT_EQ(result->passed, at_once->passed);
        EXPECT_EQ(result->path, at_once->path);
        EXPECT_EQ(result->passed, again->passed) << "a decision stays";
        Trial shorter(exercise, submission, 1);
        EXPECT_FALSE(shorter.run(ticks - 1)) << "not decided one tick earlier";
    }
}

TEST(Grade, RunsTheSensorsAndTheBodyOfTheSubmission) {
    const Exercise exercise = aggressor();
    Submission submission = with_solution(exercise);
    ASSERT_TRUE(passes(exercise, submission, 1));
    Submission blind = submission;
    for (Sensor& sensor : blind.sensors) sensor.range = 0.1f;
    EXPECT_FALSE(passes(exercise, blind, 1));
    Submission slow = submission;
    slow.body.top_speed = 0.1f;
    EXPECT_FALSE(passes(exercise, slow, 1));
}

TEST(Grade, ASubmissionIsWhatTheFirstVehicleHasNow) {
    const Exercise exercise = aggressor();
    Snapshot now;
    auto scene = std::make_shared<Scene>(exercise.scene);
    scene->kinds[0].sensors[0].range = 3;
    scene->kinds[0].body.mass = 12;
    now.scene = scene;
    now.kind_brains = {std::make_shared<BrainGraph>(exercise.scene.kinds[0].brain)};
    now.brains = {now.kind_brains[0], std::make_shared<BrainGraph>(exercise.solution.submission.brain)};
    VehicleView other, subject;
    other.brain = 0;
    subject.start = 0;
    subject.brain = 1;
    now.vehicles = {other, subject};
    const Submission submission = submission_of(exercise, now);
    EXPECT_EQ(submission.brain, exercise.solution.submission.brain);
    EXPECT_EQ(submission.sensors[0].range, 3);
    EXPECT_EQ(submission.body.mass, 12);
    now.vehicles.pop_back();
    EXPECT_EQ(submission_of(exercise, now).brain, exercise.scene.kinds[0].brain);
}

TEST(Grade, TheMedianIsTheMiddleValueOrTheMeanOfTheTwoMiddleValues) {
    EXPECT_EQ(median({}), 0);
    EXPECT_EQ(median({3}), 3);
    EXPECT_EQ(median({9, 1, 4}), 4);
    EXPECT_EQ(median({8, 1, 2, 4}), 3);
}

TEST(Grade, MeasuredValuesAreThoseOfTheComparedStep) {
    StartResult start;
    start.verdicts = {Verdict{true, {{6, 6, "s"}}}, Verdict{false, {{7.5f, 12, "s"}}}};
    EXPECT_EQ(measured_values({2, 2}, {start, StartResult{}}), (std::vector<float>{7.5f, 0}));
}

}  // namespace
}  // namespace braitenlab::tests::grade_test
