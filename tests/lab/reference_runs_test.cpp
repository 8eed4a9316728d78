// Runs computed in the background: the one with the solution, shown beside the student's, and the one that a drawn
// prediction is compared with.
#include "app/course/reference_runs.h"

#include <gtest/gtest.h>

#include "app/course/lab_lesson.h"
#include "app/lab_requests.h"
#include "core/lesson/path_distance.h"
#include "core/lesson/reference.h"
#include "core/lesson/submission.h"
#include "tests/lab/opened_lab.h"

namespace braitenlab::tests::reference_runs_test {
namespace {

struct ReferenceRuns : testing::Test {
    Jobs jobs{0};
    Lab lab = opened_lab("13-orbit");

    LessonView lesson() const { return lesson_view_of(lab); }
    const Exercise& exercise() const { return *lab.document.lesson->exercise; }
    void let_jobs_end() { update_reference_runs(lab, jobs), jobs.finish(), update_reference_runs(lab, jobs); }
    void run(int ticks) {
        for (int i = 0; i < ticks; ++i) tick(lab);
    }
    // The prediction is made, the lab has run and the run with the solution is compared.
    void begin_comparison() {
        handle(lab, PredictRequest{0});
        run(30);
        handle(lab, CompareRequest{true});
        let_jobs_end();
    }
    // The ghost is where the solution is at this tick of a run with this seed.
    void expect_in_step() {
        const Snapshot& now = lab.document.session.snapshot();
        const auto ghost = view_of(lab).features.ghost;
        ASSERT_TRUE(ghost);
        const Pose solution = Reference(exercise(), now.seed).until(now.tick).at(now.tick);
        EXPECT_FLOAT_EQ(ghost->pose.x, solution.x);
        EXPECT_FLOAT_EQ(ghost->pose.y, solution.y);
        EXPECT_FLOAT_EQ(ghost->pose.heading, solution.heading);
        EXPECT_EQ(ghost->count, now.tick + 1);
    }
};

TEST_F(ReferenceRuns, TheSolutionIsComparedAfterThePredictionAndARunOnly) {
    handle(lab, CompareRequest{true});
    EXPECT_FALSE(lesson().attempt.work.compares) << "before the prediction";
    handle(lab, PredictRequest{0});
    handle(lab, CompareRequest{true});
    EXPECT_FALSE(lesson().attempt.work.compares) << "before a run";
    run(1);
    handle(lab, CompareRequest{true});
    EXPECT_TRUE(lesson().attempt.work.compares);
    handle(lab, CompareRequest{false});
    EXPECT_FALSE(lesson().attempt.work.compares);
    handle(lab, CompareRequest{true});
    handle(lab, Action::exercise_reset);
    EXPECT_FALSE(lesson().attempt.work.compares) << "Start over";
}

TEST_F(ReferenceRuns, TheSolutionMovesInStepWithTheTime) {
    begin_comparison();
    expect_in_step();
    run(200);
    expect_in_step();
    handle(lab, SeekRequest{40});
    expect_in_step();
    handle(lab, Action::reset);
    expect_in_step();
    handle(lab, Action::another_start);
    EXPECT_FALSE(view_of(lab).features.ghost) << "the run from another start is not known yet";
    let_jobs_end();
    expect_in_step();
    EXPECT_EQ(lab.document.session.seed(), exercise().seed + 1);
}

TEST_F(ReferenceRuns, TheSolutionIsContinuedWhenTheRunIsLongerThanAGradedOne) {
    begin_comparison();
    const int graded = static_cast<int>(exercise().seconds) * 60;
    for (int done = 0; done < graded + 1800; done += 300) run(300), let_jobs_end();
    expect_in_step();
}

TEST_F(ReferenceRuns, NothingIsComparedWithARunThatWasChangedByHand) {
    begin_comparison();
    ASSERT_TRUE(view_of(lab).features.ghost);
    handle(lab, EditRequest{MoveSource{0, 3, 3}});
    EXPECT_TRUE(lesson().by_hand);
    EXPECT_FALSE(view_of(lab).features.ghost);
    handle(lab, Action::reset);
    expect_in_step();
}

TEST_F(ReferenceRuns, TheBrainOfTheStudentDoesNotChangeTheSolution) {
    begin_comparison();
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LM, 1}});
    run(60);
    expect_in_step();
}

TEST_F(ReferenceRuns, ADrawnPathIsComparedWithTheShippedRunOnceItsOutcomeIsKnown) {
    Reference shipped(exercise(), as_shipped(exercise()), 0, exercise().seed);
    const auto ticks = static_cast<std::size_t>(60 * exercise().prediction.after);
    const std::vector<maths::vec2> right = positions(shipped.until(ticks), ticks + 1, 6);
    handle(lab, PredictPathRequest{right});
    EXPECT_EQ(lesson().attempt.answers.drawn_path, right);
    EXPECT_FALSE(disclosure_of(lab).outcome) << "the path can still be changed";
    run(static_cast<int>(ticks) - 10);
    EXPECT_TRUE(disclosure_of(lab).outcome);
    let_jobs_end();
    EXPECT_TRUE(lesson().attempt.work.real_path.empty()) << "the outcome is not known";
    run(20);
    let_jobs_end();
    ASSERT_FALSE(lesson().attempt.work.real_path.empty());
    EXPECT_EQ(lesson().attempt.work.real_path, right);
    EXPECT_LT(lesson().attempt.work.path_difference, 0.01f);
    handle(lab, SeekRequest{10});
    EXPECT_EQ(lesson().attempt.answers.drawn_path, right) << "it survives going back in time";
    handle(lab, Action::exercise_reset);
    EXPECT_EQ(lesson().attempt.answers.drawn_path, right) << "Start over keeps the prediction";
    EXPECT_TRUE(lesson().attempt.work.real_path.empty()) << "but not what the run has shown";
    EXPECT_TRUE(disclosure_of(lab).open_prediction);
}

TEST_F(ReferenceRuns, APathIsDrawnAtTheStartOfARunOfAnExerciseThatAsksForOne) {
    const std::vector<maths::vec2> path{{0, 0}, {1, 1}};
    run(1);
    handle(lab, PredictPathRequest{path});
    EXPECT_TRUE(lesson().attempt.answers.drawn_path.empty());
    handle(lab, Action::reset);
    handle(lab, PredictPathRequest{path});
    EXPECT_EQ(lesson().attempt.answers.drawn_path, path);
    Lab other = opened_lab("05-aggressor");
    handle(other, PredictPathRequest{path});
    EXPECT_TRUE(lesson_view_of(other).attempt.answers.drawn_path.empty());
}

}  // namespace
}  // namespace braitenlab::tests::reference_runs_test
