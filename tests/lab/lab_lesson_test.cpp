// An open exercise: steps, hints, reset, grading in the background, and the referee in time.
#include "app/course/lab_lesson.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include <gtest/gtest.h>

#include "app/lab_requests.h"
#include "core/lesson/submission.h"
#include "tests/folder.h"
#include "tests/lab/opened_lab.h"

namespace braitenlab::tests::lab_lesson_test {
namespace {

using namespace std::chrono_literals;

constexpr int ticks_per_step = 60;  // of a trial; see lab_lesson.cpp

BrainGraph solution(const Lab& lab) { return lab.document.lesson->exercise->solution.submission.brain; }

Lab aggressor() { return opened_lab("05-aggressor"); }

// Exercise 5 with other offers; without any it offers all controls.
Lab exercise_that_offers(std::vector<std::string> offers, int changes = 0) {
    Lab lab = aggressor();
    auto exercise = std::make_shared<Exercise>(*lab.document.lesson->exercise);
    exercise->offers = std::move(offers);
    exercise->changes = changes;
    lab.document.lesson->exercise = exercise;
    lab.document.lesson->view.exercise = exercise.get();
    return lab;
}

const LessonView& lesson_of(const Lab& lab) { return lab.document.lesson->view; }

TEST(LabLesson, ChecksStepsLive) {
    Lab lab = aggressor();
    handle(lab, PredictRequest{1});
    EXPECT_EQ(lab.document.lesson->view.prediction, 1);
    handle(lab, EditRequest{SetBrain{{.kind = 0}, lab.document.lesson->exercise->solution.submission.brain}});
    handle(lab, Action::play_pause);
    for (int i = 0; i < 60 * 20 && !lab.document.lesson->referee.passed(); ++i) tick(lab);
    for (const Verdict& verdict : lab.document.lesson->view.verdicts) EXPECT_TRUE(verdict.done);
}

TEST(LabLesson, TakesAPredictionUntilARunHasShownTheOutcome) {
    Lab lab = aggressor();
    handle(lab, Action::step);
    handle(lab, PredictRequest{0});
    EXPECT_EQ(lesson_of(lab).prediction, 0);
    const auto after = static_cast<int>(60 * lab.document.lesson->exercise->prediction.after);
    while (!lesson_of(lab).outcome_known && lab.document.session.snapshot().tick < 1000) tick(lab);
    EXPECT_NEAR(static_cast<double>(lab.document.session.snapshot().tick), after, 1);
    handle(lab, PredictRequest{1});
    EXPECT_EQ(lesson_of(lab).prediction, 0);
    handle(lab, Action::exercise_reset);
    EXPECT_FALSE(lesson_of(lab).outcome_known);
    handle(lab, PredictRequest{1});
    EXPECT_EQ(lesson_of(lab).prediction, 1);
}

TEST(LabLesson, KnowsTheOutcomeOfTheShippedBrainAndLampOnly) {
    Lab rewired = aggressor();
    handle(rewired, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 2}});
    Lab moved = aggressor();
    handle(moved, EditRequest{MoveSource{0, 1, 1}});
    Lab heavier = aggressor();
    Kind kind = heavier.document.session.snapshot().scene->kinds[0];
    kind.body.mass *= 2;
    handle(heavier, EditRequest{EditKind{0, kind}});
    Lab turned = aggressor();
    kind.sensors[0].angle += 0.1f;
    handle(turned, EditRequest{SetSensors{{.kind = 0}, kind.sensors}});
    for (Lab* lab : {&rewired, &moved, &heavier, &turned}) {
        for (int i = 0; i < 600; ++i) tick(*lab);
        EXPECT_FALSE(lesson_of(*lab).outcome_known);
    }
    handle(rewired, EditRequest{SetBrain{{.kind = 0}, rewired.document.lesson->exercise->scene.kinds[0].brain}});
    handle(rewired, Action::reset);
    for (int i = 0; i < 600; ++i) tick(rewired);
    EXPECT_TRUE(lesson_of(rewired).outcome_known);
}

TEST(LabLesson, JudgesAPredictionAboutTwoVehiclesOnlyByARunWithBothAsGiven) {
    for (const int changed : {-1, 0, 1}) {
        Lab lab = opened_lab("07-further");
        handle(lab, PredictRequest{1});
        if (changed >= 0) handle(lab, EditRequest{TurnDial{{.kind = changed}, Dial::LM, 0.4f}});
        for (int i = 0; i < 13 * 60; ++i) tick(lab);
        EXPECT_EQ(lesson_of(lab).outcome_known, changed < 0) << "changed kind: " << changed;
        handle(lab, Action::exercise_reset);
        for (int i = 0; i < 13 * 60; ++i) tick(lab);
        EXPECT_TRUE(lesson_of(lab).outcome_known) << "a run of the scene as given, after changed kind " << changed;
    }
}

TEST(LabLesson, KnowsThatTheSceneIsNotAsGivenAfterAChangeOfBrainSensorsOrBody) {
    const auto changed_by = [](const Request& request) {
        Lab lab = aggressor();
        EXPECT_TRUE(lesson_of(lab).as_given);
        handle(lab, request);
        const bool changed = !lesson_of(lab).as_given;
        handle(lab, Action::undo);
        EXPECT_TRUE(lesson_of(lab).as_given);
        return changed;
    };
    const Lab lab = aggressor();
    const Snapshot& now = lab.document.session.snapshot();
    Kind heavy = now.scene->kinds[0];
    heavy.body.mass *= 2;
    std::vector<Sensor> turned = now.scene->kinds[0].sensors;
    turned[0].angle += 0.1f;
    EXPECT_TRUE(changed_by(EditRequest{TurnDial{{.kind = 0}, Dial::LL, 0.3f}}));
    EXPECT_TRUE(changed_by(EditRequest{TurnDial{{.vehicle = now.vehicles[0].id}, Dial::LL, 0.3f}}))
        << "the brain of one vehicle, not of its kind";
    EXPECT_TRUE(changed_by(EditRequest{SetSensors{{.kind = 0}, turned}}));
    EXPECT_TRUE(changed_by(EditRequest{EditKind{0, heavy}}));
}

TEST(LabLesson, DoesNotKnowTheOutcomeOfARunWithoutTheKindOfTheExercise) {
    Lab lab = aggressor();
    handle(lab, EditRequest{RemoveVehicle{}});
    handle(lab, EditRequest{RemoveKind{0}});
    ASSERT_TRUE(lab.document.session.snapshot().kind_brains.empty());
    EXPECT_TRUE(lesson_of(lab).by_hand);
    for (int i = 0; i < 600; ++i) tick(lab);
    EXPECT_FALSE(lesson_of(lab).outcome_known);
}

TEST(LabLesson, OffersAHintAfterARunOrHalfAMinute) {
    Lab lab = aggressor();
    handle(lab, Action::hint);
    EXPECT_EQ(lab.document.lesson->view.hints_shown, 1);
    handle(lab, Action::hint);
    EXPECT_EQ(lab.document.lesson->view.hints_shown, 1);
    advance(lab, 31);
    handle(lab, Action::hint);
    EXPECT_EQ(lab.document.lesson->view.hints_shown, 2);
    handle(lab, Action::reset);
    handle(lab, Action::play_pause);
    tick(lab);
    handle(lab, Action::hint);
    EXPECT_EQ(lab.document.lesson->view.hints_shown, 3);
}

TEST(LabLesson, ResetRestoresTheStartAndTheShippedBrain) {
    Lab lab = aggressor();
    const auto start = lab.document.session.hash();
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 2}});
    handle(lab, Action::play_pause);
    for (int i = 0; i < 100; ++i) tick(lab);
    handle(lab, Action::exercise_reset);
    EXPECT_EQ(lab.document.session.hash(), start);
    EXPECT_EQ(lab.playback.mode, Mode::paused);
    handle(lab, Action::undo);
    EXPECT_EQ(read_dials(*lab.document.session.snapshot().kind_brains[0]).LR, 2);
}

TEST(LabLesson, StartOverKeepsThePredictionAndTheHintsAndCanBeUndone) {
    Lab lab = aggressor();
    handle(lab, PredictRequest{1});
    handle(lab, Action::hint);
    handle(lab, Action::exercise_reset);
    EXPECT_TRUE(lab.notice.empty()) << "there is nothing to take back";
    EXPECT_FALSE(lesson_of(lab).hint_ready) << "it is no way to the next hint";
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 2}});
    for (int i = 0; i < 100; ++i) tick(lab);
    handle(lab, Action::exercise_reset);
    EXPECT_EQ(lab.notice.key, "notice.started_over");
    EXPECT_EQ(lesson_of(lab).prediction, 1);
    EXPECT_EQ(lesson_of(lab).hints_shown, 1);
    EXPECT_FALSE(lesson_of(lab).has_run);
    handle(lab, Action::undo);
    EXPECT_EQ(read_dials(*lab.document.session.snapshot().kind_brains[0]).LR, 2);
    EXPECT_EQ(lesson_of(lab).prediction, 1);
}

TEST(LabLesson, UndoOfStartOverBringsTheSceneAndTheRunBack) {
    Lab lab = aggressor();
    handle(lab, EditRequest{MoveSource{0, 1.5f, -2}});
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 2}});
    for (int i = 0; i < 10; ++i) tick(lab);
    const std::uint64_t hash = lab.document.session.hash();
    ASSERT_TRUE(lesson_of(lab).by_hand);
    handle(lab, Action::exercise_reset);
    ASSERT_NE(lab.document.session.snapshot().sources[0].x, 1.5f);
    EXPECT_FALSE(lesson_of(lab).by_hand);
    handle(lab, Action::undo);
    EXPECT_EQ(lab.document.session.hash(), hash) << "also of a short run";
    EXPECT_EQ(lab.document.session.snapshot().sources[0].x, 1.5f);
    EXPECT_TRUE(lesson_of(lab).by_hand);
    EXPECT_TRUE(lesson_of(lab).has_run);
    handle(lab, Action::redo);
    EXPECT_EQ(lab.document.session.snapshot().tick, 0u);
    EXPECT_NE(lab.document.session.snapshot().sources[0].x, 1.5f);
    EXPECT_FALSE(lesson_of(lab).has_run);
}

TEST(LabLesson, StartOverOfTwoKindsIsOneStepOfUndo) {
    Lab lab = opened_lab("18-prey");
    ASSERT_GE(lab.document.session.snapshot().scene->kinds.size(), 2u);
    for (const int kind : {0, 1}) handle(lab, EditRequest{TurnDial{{.kind = kind}, Dial::LM, 0.77f}});
    const int depth = lab.document.session.undo_depth();
    handle(lab, Action::exercise_reset);
    EXPECT_EQ(lab.document.session.undo_depth(), depth + 1);
    handle(lab, Action::undo);
    for (const std::size_t kind : {0u, 1u})
        EXPECT_EQ(read_dials(*lab.document.session.snapshot().kind_brains[kind]).LM, 0.77f) << kind;
}

TEST(LabLesson, AnotherStudentBeginsWithoutThePredictionOfTheFirst) {
    Lab lab = aggressor();
    handle(lab, PredictRequest{1});
    handle(lab, Action::hint);
    handle(lab, StudentRequest{StudentEdit::add, 0, "Ana"});
    EXPECT_EQ(lesson_of(lab).prediction, -1);
    EXPECT_EQ(lesson_of(lab).hints_shown, 0);
}

TEST(LabLesson, AResetFindsTheSubjectAgainAfterAVehicleWasAddedOrRemoved) {
    const std::vector<std::pair<const char*, std::vector<Command>>> helps{
        {"added with a start before it", {AddVehicle{.kind = 0, .at = Pose{3, 3}, .before = 0}}},
        {"added to the population", {AddVehicle{.kind = 0}}},
        {"removed", {RemoveVehicle{0}}},
        {"removed, another added", {RemoveVehicle{0}, AddVehicle{.kind = 0, .at = Pose{3, 3}}}}};
    for (const auto& [how, commands] : helps) {
        Lab lab = solved_exercise();
        for (int i = 0; i < 30; ++i) tick(lab);
        for (const Command& command : commands) handle(lab, EditRequest{command});
        tick(lab);
        EXPECT_TRUE(lab.document.lesson->referee.by_hand()) << how;
        reset(lab);
        const Snapshot& now = lab.document.session.snapshot();
        ASSERT_EQ(now.vehicles.size(), 1u) << how;
        EXPECT_EQ(lab.document.lesson->referee.state().subjects, std::vector<VehicleId>{now.vehicles[0].id}) << how;
        EXPECT_EQ(lab.view.selection.vehicle, now.vehicles[0].id) << how;
        EXPECT_FALSE(lab.document.lesson->referee.by_hand()) << how;
        for (int i = 0; i < 60 * 20 && !lab.document.lesson->referee.passed(); ++i) tick(lab);
        EXPECT_TRUE(lab.document.lesson->referee.passed()) << how;
    }
}

TEST(LabLesson, ARunResetKeepsTheSensorsAndTheBodyOfTheStudentAndStartOverRestoresThem) {
    Lab lab = aggressor();
    const auto start = lab.document.session.hash();
    Kind edited = lab.document.session.snapshot().scene->kinds[0];
    edited.sensors[0].angle += 0.1f, edited.body.mass *= 2;
    handle(lab, EditRequest{SetSensors{{.kind = 0}, edited.sensors}});
    handle(lab, EditRequest{EditKind{0, edited}});
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 2}});
    const auto kind = [&]() -> const Kind& { return lab.document.session.snapshot().scene->kinds[0]; };
    for (int i = 0; i < 10; ++i) tick(lab);
    handle(lab, Action::reset);
    EXPECT_EQ(kind().sensors, edited.sensors);
    EXPECT_EQ(kind().body, edited.body);
    EXPECT_FALSE(lesson_of(lab).by_hand);
    handle(lab, Action::exercise_reset);
    EXPECT_EQ(lab.document.session.hash(), start);
    handle(lab, Action::undo);
    EXPECT_EQ(kind().sensors, edited.sensors) << "one step of undo";
    EXPECT_EQ(kind().body, edited.body);
    EXPECT_EQ(read_dials(*lab.document.session.snapshot().kind_brains[0]).LR, 2);
}

bool any_done(const Lab& lab) {
    const auto& verdicts = lab.document.lesson->view.verdicts;
    return std::any_of(verdicts.begin(), verdicts.end(), [](const Verdict& v) { return v.done; });
}

TEST(LabLesson, DoesNotPassIfTheLampIsMovedToTheVehicle) {
    for (const int before : {0, 30}) {
        Lab lab = aggressor();
        for (int i = 0; i < before; ++i) tick(lab);
        for (int i = 0; i < 300; ++i) {
            const VehicleView& coward = lab.document.session.snapshot().vehicles[0];
            handle(lab, EditRequest{MoveSource{0, coward.x + 0.4f * std::cos(coward.heading),
                                               coward.y + 0.4f * std::sin(coward.heading)}});
            tick(lab);
        }
        EXPECT_FALSE(any_done(lab)) << before;
        EXPECT_TRUE(lab.document.lesson->view.by_hand);
        handle(lab, Action::reset);
        EXPECT_FALSE(lab.document.lesson->view.by_hand);
    }
}

TEST(LabLesson, CountsAgainOnceAMoveBeforeTheStartIsUndone) {
    Lab lab = aggressor();
    handle(lab, EditRequest{MoveSource{0, 1, 1}});
    EXPECT_TRUE(lab.document.lesson->view.by_hand);
    handle(lab, Action::undo);
    EXPECT_FALSE(lab.document.lesson->view.by_hand);
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 2}});
    tick(lab);
    EXPECT_FALSE(lab.document.lesson->view.by_hand) << "the exercise requires a change of the brain";
}

TEST(LabLesson, CountsBeforeADisturbanceAfterGoingBack) {
    Lab lab = aggressor();
    for (int i = 0; i < 100; ++i) tick(lab);
    handle(lab, EditRequest{MoveVehicle{lab.view.selection.vehicle, 0, 0, 0}});
    for (int i = 0; i < 100; ++i) tick(lab);
    handle(lab, SeekRequest{104});
    EXPECT_TRUE(lab.document.lesson->view.by_hand);
    handle(lab, SeekRequest{50});
    EXPECT_FALSE(lab.document.lesson->view.by_hand);
    handle(lab, SeekRequest{199});
    EXPECT_TRUE(lab.document.lesson->view.by_hand);
}

TEST(LabLesson, ResetRestoresTheShippedBrainOfASingleVehicle) {
    Lab lab = aggressor();
    handle(lab, EditRequest{TurnDial{{.vehicle = lab.view.selection.vehicle}, Dial::LR, 2}});
    handle(lab, Action::exercise_reset);
    const Snapshot& now = lab.document.session.snapshot();
    EXPECT_EQ(*now.brains[static_cast<std::size_t>(now.vehicles[0].brain)],
              lab.document.lesson->exercise->scene.kinds[0].brain);
    handle(lab, Action::undo);
    const Snapshot& then = lab.document.session.snapshot();
    EXPECT_EQ(read_dials(*then.brains[static_cast<std::size_t>(then.vehicles[0].brain)]).LR, 2);
}

TEST(LabLesson, ARunResetKeepsTheBrainOfTheStudent) {
    Lab lab = aggressor();
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 2}});
    for (int i = 0; i < 100; ++i) tick(lab);
    handle(lab, Action::reset);
    EXPECT_EQ(lab.document.session.snapshot().tick, 0u);
    EXPECT_EQ(read_dials(*lab.document.session.snapshot().kind_brains[0]).LR, 2);
}

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
        EXPECT_EQ(passed_starts(*lesson_of(lab).grade),
                  passed_starts(grade(*lab.document.lesson->exercise, with_solution(*lab.document.lesson->exercise))));
        EXPECT_TRUE(lesson_of(lab).grade->good);
        EXPECT_FALSE(lesson_of(lab).starts_tested);
    }
}

TEST(LabLesson, GradesTheStartsAsShippedToCompareMedians) {
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
    EXPECT_FALSE(lesson_of(lab).grade) << "a tick does not start grading";
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
    std::vector<Sensor> blind = aggressor().document.session.snapshot().scene->kinds[0].sensors;
    for (Sensor& sensor : blind) sensor.range = 0.1f;
    const BrainGraph weak = make_graph({.LM = 0.1f, .RM = 0.1f});
    for (const Command& edit : {Command(SetBrain{{.kind = 0}, weak}), Command(SetSensors{{.kind = 0}, blind})}) {
        Jobs jobs(0);
        Lab lab = exercise_that_offers({});
        handle(lab, EditRequest{SetBrain{{.kind = 0}, solution(lab)}});
        run_until_every_step_is_done(lab);
        while (lesson_of(lab).starts_tested.value_or(0) < 4) turn(lab, jobs);
        handle(lab, EditRequest{edit});
        turn(lab, jobs);
        EXPECT_EQ(lesson_of(lab).starts_tested, 0u) << edit.index();
        grade_to_the_end(lab, jobs);
        ASSERT_TRUE(lesson_of(lab).grade);
        EXPECT_EQ(lesson_of(lab).grade->count, 0) << edit.index();
    }
}

TEST(LabLesson, TellsStepsOfAnotherBrainApart) {
    Jobs jobs(0);
    Lab lab = solved_exercise();
    run_until_every_step_is_done(lab);
    turn(lab, jobs);
    EXPECT_FALSE(lesson_of(lab).changed_since_done);
    grade_to_the_end(lab, jobs);
    EXPECT_FALSE(lesson_of(lab).changed_since_done);
    handle(lab, Action::undo);
    turn(lab, jobs);
    EXPECT_TRUE(lesson_of(lab).changed_since_done) << "the brain is that of the file again";
    grade_to_the_end(lab, jobs);
    EXPECT_EQ(lesson_of(lab).grade->count, 0);
    EXPECT_TRUE(lesson_of(lab).changed_since_done);
    handle(lab, Action::redo);
    turn(lab, jobs);
    EXPECT_FALSE(lesson_of(lab).changed_since_done);
    handle(lab, Action::undo);
    handle(lab, Action::reset);
    turn(lab, jobs);
    EXPECT_FALSE(lesson_of(lab).changed_since_done) << "no step is done";
}

TEST(LabLesson, TellsThatTheBrainWasChangedDuringTheRun) {
    Jobs jobs(0);
    Lab lab = exercise_that_offers({});
    handle(lab, EditRequest{SetBrain{{.kind = 0}, solution(lab)}});
    run_until_every_step_is_done(lab);
    // Graded with a brain that does nothing, as after an edit in the last tick before the steps were done.
    handle(lab, EditRequest{SetBrain{{.kind = 0}, make_graph({.LM = 0.1f, .RM = 0.1f})}});
    turn(lab, jobs);
    grade_to_the_end(lab, jobs);
    turn(lab, jobs);
    EXPECT_TRUE(lesson_of(lab).changed_since_done) << "the start of this run fails with it";
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

TEST(LabLesson, ShowsAGradeOnlyForTheSubmissionThatGotIt) {
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

TEST(LabLesson, DoesNotGradeWhileOtherControlsThanTheOfferedOnesHaveChanged) {
    Jobs jobs(0);
    Lab lab = exercise_that_offers({"LL=RR", "LM"});
    handle(lab, EditRequest{SetBrain{{.kind = 0}, solution(lab)}});
    run_until_every_step_is_done(lab);
    for (int i = 0; i < 20; ++i) turn(lab, jobs);
    EXPECT_TRUE(lesson_of(lab).outside_offers);
    EXPECT_FALSE(lesson_of(lab).grade);
    EXPECT_FALSE(lesson_of(lab).starts_tested);
    handle(lab, Action::undo);
    turn(lab, jobs);
    turn(lab, jobs);
    EXPECT_FALSE(lesson_of(lab).outside_offers);
}

TEST(LabLesson, CountsTheChangedControlsWhereTheyAreLimited) {
    Jobs jobs(0);
    for (const int changes : {3, 4}) {  // the solution changes LL, LR, RL and RR
        Lab lab = exercise_that_offers({"LL", "LR", "RL", "RR", "LM", "RM"}, changes);
        handle(lab, EditRequest{SetBrain{{.kind = 0}, solution(lab)}});
        run_until_every_step_is_done(lab);
        for (int i = 0; i < 3; ++i) turn(lab, jobs);
        EXPECT_EQ(lesson_of(lab).too_many_changes, changes < 4) << changes;
        EXPECT_FALSE(lesson_of(lab).outside_offers);
    }
}

TEST(LabLesson, WithoutHintsTheSolutionIsOfferedAfterARunOrHalfAMinute) {
    const Folder folder;
    std::string text = text_of(*find_shipped("05-aggressor"));
    for (std::size_t at; (at = text.find("[[hint]]")) != text.npos;) {
        const std::size_t next = text.find("\n[", at);
        text.erase(at, next == text.npos ? next : next + 1 - at);
    }
    put_text(folder.path / "own" / "own.toml", text);
    put_text(folder.path / "scenes" / "2b-aggressor.toml", text_of(*find_shipped("2b-aggressor")));
    const auto opened = [&] {
        auto lab = open_lab(folder.path / "own" / "own.toml", std::nullopt, {});
        EXPECT_TRUE(lab) << lab.error().text();
        EXPECT_TRUE(lab->document.lesson->exercise->hints.empty());
        return std::move(*lab);
    };
    Lab lab = opened();
    EXPECT_FALSE(lesson_of(lab).hint_ready);
    tick(lab);
    EXPECT_TRUE(lesson_of(lab).hint_ready) << "after a run";
    advance(lab, 100);
    replace_document(lab, std::move(opened().document));
    advance(lab, 1);
    EXPECT_FALSE(lesson_of(lab).hint_ready) << "time before it was opened does not count";
    EXPECT_EQ(lesson_of(lab).hint_in, 29);
    advance(lab, 30);
    EXPECT_TRUE(lesson_of(lab).hint_ready);
}

TEST(LabLesson, ShowsTheSolutionAsOneStepOfUndo) {
    Lab lab = aggressor();
    const Submission shipped = as_shipped(*lab.document.lesson->exercise);
    handle(lab, Action::step);
    handle(lab, ShowMeRequest{});
    const Snapshot& now = lab.document.session.snapshot();
    EXPECT_EQ(submission_of(*lab.document.lesson->exercise, now), with_solution(*lab.document.lesson->exercise));
    EXPECT_EQ(now.tick, 0u);
    EXPECT_FALSE(lesson_of(lab).by_hand);
    handle(lab, Action::undo);
    EXPECT_EQ(submission_of(*lab.document.lesson->exercise, lab.document.session.snapshot()), shipped);
}

TEST(LabLesson, ShowsAllControlsInFreePlay) {
    Lab lab = exercise_that_offers({"LL"});
    handle(lab, FreePlayRequest{true});
    EXPECT_TRUE(lesson_of(lab).free_play);
    handle(lab, FreePlayRequest{false});
    EXPECT_FALSE(lesson_of(lab).free_play);
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

TEST(LabLesson, GradingRunsTheSensorsThatTheStudentTurned) {
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
}  // namespace braitenlab::tests::lab_lesson_test
