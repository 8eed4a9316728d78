// Grading of an open exercise in the background.
#include "app/lab_lesson.h"

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "app/files/data.h"
#include "app/lab_requests.h"

namespace braitenlab::tests::lab_lesson_test {
namespace {

using namespace std::chrono_literals;

constexpr int ticks_per_step = 60;  // of a trial; see lab_lesson.cpp

BrainGraph solution(const Lab& lab) { return make_graph(lab.document.lesson->exercise->solution); }

// Exercise 5 with its solution.
Lab solved_exercise() {
    auto lab = open_lab(*find_shipped("05-aggressor"), std::nullopt, {});
    EXPECT_TRUE(lab) << lab.error().text();
    handle(*lab, EditRequest{SetBrain{{.kind = 0}, solution(*lab)}});
    return std::move(*lab);
}

const LessonView& lesson_of(const Lab& lab) { return lab.document.lesson->view; }

void run_until_every_step_is_done(Lab& lab) {
    for (int i = 0; i < 60 * 20 && !lab.document.lesson->referee.passed(); ++i) tick(lab);
    ASSERT_TRUE(lab.document.lesson->referee.passed());
}

// The part of App::turn that grades.
void turn(Lab& lab, Jobs& jobs) {
    jobs.deliver(0ns);
    update_grading(lab, jobs);
}

// Returns how many turns that took.
int grade_to_the_end(Lab& lab, Jobs& jobs) {
    int turns = 0;
    for (; !lesson_of(lab).grade && turns < 100'000; ++turns) {
        turn(lab, jobs);
        if (jobs.threads() > 0) std::this_thread::sleep_for(100us);
    }
    return turns;
}

TEST(LabLesson, GradesFromAllStartsOnceEveryStepIsDone) {
    for (const int threads : {0, 2}) {
        Jobs jobs(threads);
        Lab lab = solved_exercise();
        turn(lab, jobs);
        EXPECT_FALSE(lesson_of(lab).starts_tested) << "no step is done yet";
        run_until_every_step_is_done(lab);
        grade_to_the_end(lab, jobs);
        ASSERT_TRUE(lesson_of(lab).grade);
        EXPECT_EQ(lesson_of(lab).grade->passed,
                  grade(*lab.document.lesson->exercise, with_solution(*lab.document.lesson->exercise)).passed);
        EXPECT_TRUE(lesson_of(lab).grade->good);
        EXPECT_FALSE(lesson_of(lab).starts_tested);
    }
}

TEST(LabLesson, RunsAtMostOneStepOfOneTrialPerTurnWithoutThreads) {
    Jobs jobs(0);
    Lab lab = solved_exercise();
    const Exercise& exercise = *lab.document.lesson->exercise;
    int steps = 0;
    for (int start = 1; start <= exercise.starts; ++start) {
        Trial trial(exercise, with_solution(exercise), static_cast<std::uint64_t>(start));
        int ticks = 0;
        while (!trial.run(1)) ++ticks;
        steps += ticks / ticks_per_step + 1;
    }
    run_until_every_step_is_done(lab);
    EXPECT_FALSE(lesson_of(lab).grade) << "a tick does not grade";
    const int turns_to_begin = 1;
    EXPECT_EQ(grade_to_the_end(lab, jobs), turns_to_begin + steps);
    EXPECT_GT(steps, exercise.starts);
}

TEST(LabLesson, CountsTheTestedStarts) {
    Jobs jobs(0);
    Lab lab = solved_exercise();
    run_until_every_step_is_done(lab);
    std::vector<std::size_t> seen;
    while (!lesson_of(lab).grade) {
        turn(lab, jobs);
        const auto tested = lesson_of(lab).starts_tested;
        if (tested && (seen.empty() || *tested != seen.back())) seen.push_back(*tested);
    }
    EXPECT_EQ(seen, (std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
}

TEST(LabLesson, GradesTheEditedSubmissionWhenItIsEditedMeanwhile) {
    Jobs jobs(0);
    Lab lab = solved_exercise();
    run_until_every_step_is_done(lab);
    while (lesson_of(lab).starts_tested.value_or(0) < 4) turn(lab, jobs);
    const BrainGraph weak = make_graph({.LM = 0.1f, .RM = 0.1f});
    handle(lab, EditRequest{SetBrain{{.kind = 0}, weak}});
    turn(lab, jobs);
    EXPECT_EQ(lesson_of(lab).starts_tested, 0u);
    grade_to_the_end(lab, jobs);
    ASSERT_TRUE(lesson_of(lab).grade);
    EXPECT_EQ(lesson_of(lab).grade->count, 0);
}

TEST(LabLesson, CancelsGradingWhenTheDocumentIsReplacedOrTheExerciseRestarted) {
    Jobs jobs(0);
    for (const bool replace : {true, false}) {
        Lab lab = solved_exercise();
        run_until_every_step_is_done(lab);
        turn(lab, jobs), turn(lab, jobs);
        ASSERT_TRUE(lesson_of(lab).starts_tested);
        if (replace)
            replace_document(lab, std::move(solved_exercise().document));
        else
            restart_exercise(lab);
        jobs.finish();
        update_grading(lab, jobs);
        EXPECT_FALSE(lesson_of(lab).grade);
        EXPECT_FALSE(lesson_of(lab).starts_tested);
    }
}

TEST(LabLesson, KeepsAGoodGradeThatComesAfterAReset) {
    Jobs jobs(0);
    Lab lab = solved_exercise();
    run_until_every_step_is_done(lab);
    turn(lab, jobs);
    reset(lab);
    grade_to_the_end(lab, jobs);
    ASSERT_TRUE(lesson_of(lab).grade);
    EXPECT_TRUE(lesson_of(lab).grade->good);
}

TEST(LabLesson, DropsAPoorGradeThatComesAfterAReset) {
    Jobs jobs(0);
    Lab lab = solved_exercise();
    run_until_every_step_is_done(lab);
    handle(lab, EditRequest{SetBrain{{.kind = 0}, make_graph({.LM = 0.1f, .RM = 0.1f})}});
    turn(lab, jobs);
    ASSERT_TRUE(lesson_of(lab).starts_tested);
    reset(lab);
    jobs.finish();
    update_grading(lab, jobs);
    EXPECT_FALSE(lesson_of(lab).grade);
    EXPECT_FALSE(lesson_of(lab).starts_tested);
}

}  // namespace
}  // namespace braitenlab::tests::lab_lesson_test
