// The grading of an open exercise in the background.
#include "app/course/lab_lesson.h"
#include "app/lab_reset.h"
#include "core/lesson/grade.h"
#include "tests/lab/lesson_in_lab.h"

namespace braitenlab::tests::lab_grading_test {
namespace {

constexpr int ticks_per_step = 60;  // of a trial; see lab_lesson.cpp

TEST(LabGrading, GradesFromAllStartsOnceEveryStepIsDone) {
    for (const int threads : {0, 2}) {
        Jobs jobs(threads);
        Lab lab = solved_exercise();
        turn(lab, jobs);
        EXPECT_FALSE(lesson_of(lab).standing.starts_tested) << "no step is done yet";
        run_until_every_step_is_done(lab);
        grade_to_the_end(lab, jobs);
        ASSERT_TRUE(lesson_of(lab).grade);
        EXPECT_EQ(passed_starts(*lesson_of(lab).grade),
                  passed_starts(grade(*lab.document.lesson->exercise, with_solution(*lab.document.lesson->exercise))));
        EXPECT_TRUE(lesson_of(lab).grade->good);
        EXPECT_FALSE(lesson_of(lab).standing.starts_tested);
    }
}

TEST(LabGrading, GradesTheStartsAsShippedToCompareMedians) {
    Jobs jobs(0);
    Lab lab = opened_lab("18-prey");
    const Exercise& exercise = *lab.document.lesson->exercise;
    const Submission& solved = exercise.solution.submission;
    handle(lab, EditRequest{SetSensors{{.kind = subject_kind(exercise.scene)}, solved.sensors}});
    run_until_every_step_is_done(lab);
    grade_to_the_end(lab, jobs);
    ASSERT_TRUE(lesson_of(lab).grade);
    EXPECT_FALSE(lesson_of(lab).shipped_grade) << "begins with the first grade";
    for (int turns = 0; !lesson_of(lab).shipped_grade && turns < 100'000; ++turns) turn(lab, jobs);
    ASSERT_TRUE(lesson_of(lab).shipped_grade);
    const float as_given = median(measured_values(exercise.median, lesson_of(lab).shipped_grade->starts));
    const float own = median(measured_values(exercise.median, lesson_of(lab).grade->starts));
    EXPECT_GT(as_given, 5);
    EXPECT_GE(own, exercise.median.factor * as_given * 0.95f);
}

TEST(LabGrading, RunsAtMostOneStepOfOneTrialPerTurnWithoutThreads) {
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
    EXPECT_FALSE(lesson_of(lab).grade) << "a tick does not start grading";
    const int turns_to_begin = 1;
    EXPECT_EQ(grade_to_the_end(lab, jobs), turns_to_begin + steps);
    EXPECT_GT(steps, exercise.starts);
}

TEST(LabGrading, CountsTheTestedStarts) {
    Jobs jobs(0);
    Lab lab = solved_exercise();
    run_until_every_step_is_done(lab);
    std::vector<std::size_t> seen;
    while (!lesson_of(lab).grade) {
        turn(lab, jobs);
        const auto tested = lesson_of(lab).standing.starts_tested;
        if (tested && (seen.empty() || *tested != seen.back())) seen.push_back(*tested);
    }
    EXPECT_EQ(seen, (std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
}

TEST(LabGrading, GradesTheEditedSubmissionWhenItIsEditedMeanwhile) {
    std::vector<Sensor> blind = aggressor().document.session.snapshot().scene->kinds[0].sensors;
    for (Sensor& sensor : blind) sensor.range = 0.1f;
    const BrainGraph weak = make_graph({.LM = 0.1f, .RM = 0.1f});
    for (const Command& edit : {Command(SetBrain{{.kind = 0}, weak}), Command(SetSensors{{.kind = 0}, blind})}) {
        Jobs jobs(0);
        Lab lab = exercise_that_offers({});
        handle(lab, EditRequest{SetBrain{{.kind = 0}, solution(lab)}});
        run_until_every_step_is_done(lab);
        while (lesson_of(lab).standing.starts_tested.value_or(0) < 4) turn(lab, jobs);
        handle(lab, EditRequest{edit});
        turn(lab, jobs);
        EXPECT_EQ(lesson_of(lab).standing.starts_tested, 0u) << edit.index();
        grade_to_the_end(lab, jobs);
        ASSERT_TRUE(lesson_of(lab).grade);
        EXPECT_EQ(lesson_of(lab).grade->count, 0) << edit.index();
    }
}

TEST(LabGrading, TellsStepsOfAnotherBrainApart) {
    Jobs jobs(0);
    Lab lab = solved_exercise();
    run_until_every_step_is_done(lab);
    turn(lab, jobs);
    EXPECT_FALSE(lesson_of(lab).standing.changed_since_done);
    grade_to_the_end(lab, jobs);
    EXPECT_FALSE(lesson_of(lab).standing.changed_since_done);
    handle(lab, Action::undo);
    turn(lab, jobs);
    EXPECT_TRUE(lesson_of(lab).standing.changed_since_done) << "the brain is that of the file again";
    grade_to_the_end(lab, jobs);
    EXPECT_EQ(lesson_of(lab).grade->count, 0);
    EXPECT_TRUE(lesson_of(lab).standing.changed_since_done);
    handle(lab, Action::redo);
    turn(lab, jobs);
    EXPECT_FALSE(lesson_of(lab).standing.changed_since_done);
    handle(lab, Action::undo);
    handle(lab, Action::reset);
    turn(lab, jobs);
    EXPECT_FALSE(lesson_of(lab).standing.changed_since_done) << "no step is done";
}

TEST(LabGrading, TakesAnotherArrangementOfTheDiagramForNoChange) {
    Jobs jobs(0);
    Lab lab = solved_exercise();
    run_until_every_step_is_done(lab);
    grade_to_the_end(lab, jobs);
    const NodeId node = lab.document.session.snapshot().brains.front()->nodes.front().id;
    for (const maths::vec2 place : {maths::vec2{40, 60}, maths::vec2{90, 60}}) {
        handle(lab, EditRequest{PlaceNodes{{.kind = 0}, {{node, place}}}});
        turn(lab, jobs);
        EXPECT_FALSE(lesson_of(lab).standing.changed_since_done);
        EXPECT_TRUE(lesson_of(lab).grade) << "it is not graded again";
    }
    handle(lab, Action::undo);
    turn(lab, jobs);
    EXPECT_FALSE(lesson_of(lab).standing.changed_since_done);
}

TEST(LabGrading, TellsThatTheBrainWasChangedDuringTheRun) {
    Jobs jobs(0);
    Lab lab = exercise_that_offers({});
    handle(lab, EditRequest{SetBrain{{.kind = 0}, solution(lab)}});
    run_until_every_step_is_done(lab);
    // Graded with a brain that does nothing, as after an edit in the last tick before the steps were done.
    handle(lab, EditRequest{SetBrain{{.kind = 0}, make_graph({.LM = 0.1f, .RM = 0.1f})}});
    turn(lab, jobs);
    grade_to_the_end(lab, jobs);
    turn(lab, jobs);
    EXPECT_TRUE(lesson_of(lab).standing.changed_since_done) << "the start of this run fails with it";
}

TEST(LabGrading, CancelsGradingWhenTheDocumentIsReplacedOrTheExerciseRestarted) {
    Jobs jobs(0);
    for (const bool replace : {true, false}) {
        Lab lab = solved_exercise();
        run_until_every_step_is_done(lab);
        turn(lab, jobs), turn(lab, jobs);
        ASSERT_TRUE(lesson_of(lab).standing.starts_tested);
        if (replace)
            replace_document(lab, std::move(solved_exercise().document));
        else
            restart_exercise(lab);
        jobs.finish();
        update_grading(lab, jobs);
        EXPECT_FALSE(lesson_of(lab).grade);
        EXPECT_FALSE(lesson_of(lab).standing.starts_tested);
    }
}

TEST(LabGrading, KeepsAGoodGradeThatComesAfterAReset) {
    Jobs jobs(0);
    Lab lab = solved_exercise();
    run_until_every_step_is_done(lab);
    turn(lab, jobs);
    reset(lab);
    grade_to_the_end(lab, jobs);
    ASSERT_TRUE(lesson_of(lab).grade);
    EXPECT_TRUE(lesson_of(lab).grade->good);
}

TEST(LabGrading, ShowsAGradeOnlyForTheSubmissionThatGotIt) {
    Jobs jobs(0);
    Lab lab = solved_exercise();
    run_until_every_step_is_done(lab);
    grade_to_the_end(lab, jobs);
    ASSERT_TRUE(lesson_of(lab).grade);
    handle(lab, Action::reset);
    turn(lab, jobs);
    EXPECT_TRUE(lesson_of(lab).grade) << "a reset keeps the brain";
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LL, 0.3f}});
    turn(lab, jobs);
    EXPECT_FALSE(lesson_of(lab).grade) << "another brain";
    handle(lab, Action::undo);
    turn(lab, jobs);
    ASSERT_TRUE(lesson_of(lab).grade) << "the same brain again";
    EXPECT_TRUE(lesson_of(lab).grade->good);
    restart_exercise(lab);
    turn(lab, jobs);
    handle(lab, EditRequest{SetBrain{{.kind = 0}, solution(lab)}});
    turn(lab, jobs);
    EXPECT_FALSE(lesson_of(lab).grade) << "Discard all forgets the grade";
}

TEST(LabGrading, DoesNotGradeWhileOtherControlsThanTheOfferedOnesHaveChanged) {
    Jobs jobs(0);
    Lab lab = exercise_that_offers({"LL=RR", "LM"});
    handle(lab, EditRequest{SetBrain{{.kind = 0}, solution(lab)}});
    run_until_every_step_is_done(lab);
    for (int i = 0; i < 20; ++i) turn(lab, jobs);
    EXPECT_TRUE(lesson_of(lab).standing.outside_offers);
    EXPECT_FALSE(lesson_of(lab).grade);
    EXPECT_FALSE(lesson_of(lab).standing.starts_tested);
    handle(lab, Action::undo);
    turn(lab, jobs);
    turn(lab, jobs);
    EXPECT_FALSE(lesson_of(lab).standing.outside_offers);
}

TEST(LabGrading, CountsTheChangedControlsWhereTheyAreLimited) {
    Jobs jobs(0);
    for (const int changes : {3, 4}) {  // the solution changes LL, LR, RL and RR
        Lab lab = exercise_that_offers({"LL", "LR", "RL", "RR", "LM", "RM"}, changes);
        handle(lab, EditRequest{SetBrain{{.kind = 0}, solution(lab)}});
        run_until_every_step_is_done(lab);
        for (int i = 0; i < 3; ++i) turn(lab, jobs);
        EXPECT_EQ(lesson_of(lab).standing.too_many_changes, changes < 4) << changes;
        EXPECT_FALSE(lesson_of(lab).standing.outside_offers);
    }
}

TEST(LabGrading, DropsAPoorGradeThatComesAfterAReset) {
    Jobs jobs(0);
    Lab lab = solved_exercise();
    run_until_every_step_is_done(lab);
    handle(lab, EditRequest{SetBrain{{.kind = 0}, make_graph({.LM = 0.1f, .RM = 0.1f})}});
    turn(lab, jobs);
    ASSERT_TRUE(lesson_of(lab).standing.starts_tested);
    reset(lab);
    jobs.finish();
    update_grading(lab, jobs);
    EXPECT_FALSE(lesson_of(lab).grade);
    EXPECT_FALSE(lesson_of(lab).standing.starts_tested);
}

TEST(LabGrading, GradingRunsTheSensorsThatTheStudentTurned) {
    Jobs jobs(0);
    Lab lab = exercise_that_offers({});
    std::vector<Sensor> sensors = lab.document.session.snapshot().scene->kinds[0].sensors;
    ASSERT_EQ(sensors.size(), 2u);
    for (Sensor& sensor : sensors) sensor.y = -sensor.y, sensor.angle = -sensor.angle;
    handle(lab, EditRequest{SetSensors{{.kind = 0}, sensors}});  // the shipped brain with crossed eyes is the solution
    run_until_every_step_is_done(lab);
    grade_to_the_end(lab, jobs);
    ASSERT_TRUE(lesson_of(lab).grade);
    EXPECT_EQ(lesson_of(lab).grade->count, 10);
}

}  // namespace
}  // namespace braitenlab::tests::lab_grading_test
