// The prediction of an open exercise: until when it can be made, and which runs judge it.
#include "app/course/lab_children.h"
#include "app/course/lab_lesson.h"
#include "core/lesson/selection.h"
#include "tests/lab/lesson_in_lab.h"

namespace braitenlab::tests::lab_prediction_test {
namespace {

TEST(LabPrediction, CanBeMadeAndChangedUntilARunBeginsAndAgainAfterAReset) {
    Lab lab = opened_lab("07-further");
    const auto predicted = [&](int option) {
        handle(lab, PredictRequest{option});
        return lesson_of(lab).attempt.answers.prediction;
    };
    handle(lab, Action::step);
    EXPECT_EQ(predicted(0), -1) << "an answer in the run is no prediction";
    handle(lab, Action::reset);
    EXPECT_EQ(predicted(0), 0);
    EXPECT_EQ(predicted(1), 1);
    handle(lab, Action::step);
    EXPECT_EQ(predicted(2), 1);
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LM, 0.4f}});
    EXPECT_EQ(predicted(2), 1) << "also with another brain: the run shows the red vehicle";
    handle(lab, SeekRequest{0});
    EXPECT_EQ(predicted(2), 2);
    handle(lab, Action::step);
    handle(lab, Action::exercise_reset);
    EXPECT_EQ(predicted(0), 0);
}

TEST(LabPrediction, OfASelectionByHandIsLockedAfterTheFirstChoice) {
    Lab lab = opened_lab("20-selection");
    ASSERT_TRUE(offers_selection(*lab.document.lesson->exercise));
    Jobs jobs(0);
    const auto let_jobs_end = [&] {
        for (int i = 0; i < 10'000 && (!lesson_of(lab).selection || lesson_of(lab).selection->children.empty()); ++i) {
            update_children(lab, jobs);
            jobs.deliver(std::chrono::nanoseconds(0));
        }
    };
    let_jobs_end();
    handle(lab, PredictRequest{0});
    EXPECT_EQ(lesson_of(lab).attempt.answers.prediction, 0);
    choose_child(lab, 0);
    ASSERT_EQ(lab.document.session.snapshot().tick, 0u);
    handle(lab, PredictRequest{1});
    EXPECT_EQ(lesson_of(lab).attempt.answers.prediction, 0);
    take_choice_back(lab);
    handle(lab, PredictRequest{1});
    EXPECT_EQ(lesson_of(lab).attempt.answers.prediction, 1);
}

TEST(LabPrediction, IsJudgedOnceARunHasShownTheOutcome) {
    Lab lab = aggressor();
    handle(lab, PredictRequest{0});
    const auto after = static_cast<int>(60 * lab.document.lesson->exercise->prediction.after);
    while (!lesson_of(lab).attempt.work.outcome_known && lab.document.session.snapshot().tick < 1000) tick(lab);
    EXPECT_NEAR(static_cast<double>(lab.document.session.snapshot().tick), after, 1);
    handle(lab, PredictRequest{1});
    EXPECT_EQ(lesson_of(lab).attempt.answers.prediction, 0);
    handle(lab, Action::exercise_reset);
    EXPECT_FALSE(lesson_of(lab).attempt.work.outcome_known);
    handle(lab, PredictRequest{1});
    EXPECT_EQ(lesson_of(lab).attempt.answers.prediction, 1);
}

TEST(LabPrediction, KnowsTheOutcomeOfTheShippedBrainAndLampOnly) {
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
        EXPECT_FALSE(lesson_of(*lab).attempt.work.outcome_known);
    }
    handle(rewired, EditRequest{SetBrain{{.kind = 0}, rewired.document.lesson->exercise->scene.kinds[0].brain}});
    handle(rewired, Action::reset);
    for (int i = 0; i < 600; ++i) tick(rewired);
    EXPECT_TRUE(lesson_of(rewired).attempt.work.outcome_known);
}

TEST(LabPrediction, IsNotJudgedByARunWhoseChangeWasUndoneOnTheWay) {
    Lab lab = aggressor();
    handle(lab, PredictRequest{0});
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 2}});
    for (int i = 0; i < 300; ++i) tick(lab);
    handle(lab, Action::undo);
    for (int i = 0; i < 300; ++i) tick(lab);
    EXPECT_FALSE(lesson_of(lab).attempt.work.outcome_known);
    EXPECT_FALSE(lesson_of(lab).as_given) << "the card asks for a run of the scene as given";
    handle(lab, Action::reset);
    EXPECT_TRUE(lesson_of(lab).as_given);
    for (int i = 0; i < 600; ++i) tick(lab);
    EXPECT_TRUE(lesson_of(lab).attempt.work.outcome_known);
}

TEST(LabPrediction, IsNotJudgedAfterAJumpOverAChangeThatWasUndone) {
    Lab lab = aggressor();
    handle(lab, PredictRequest{0});
    for (int i = 0; i < 30; ++i) tick(lab);
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 2}});
    for (int i = 0; i < 300; ++i) tick(lab);
    handle(lab, Action::undo);
    for (int i = 0; i < 270; ++i) tick(lab);
    handle(lab, SeekRequest{20});
    EXPECT_TRUE(lesson_of(lab).as_given) << "before the change";
    handle(lab, SeekRequest{600});
    EXPECT_FALSE(lesson_of(lab).as_given);
    EXPECT_FALSE(lesson_of(lab).attempt.work.outcome_known);
}

TEST(LabPrediction, JudgesAPredictionAboutTwoVehiclesOnlyByARunWithBothAsGiven) {
    for (const int changed : {-1, 0, 1}) {
        Lab lab = opened_lab("07-further");
        handle(lab, PredictRequest{1});
        if (changed >= 0) handle(lab, EditRequest{TurnDial{{.kind = changed}, Dial::LM, 0.4f}});
        for (int i = 0; i < 13 * 60; ++i) tick(lab);
        EXPECT_EQ(lesson_of(lab).attempt.work.outcome_known, changed < 0) << "changed kind: " << changed;
        handle(lab, Action::exercise_reset);
        for (int i = 0; i < 13 * 60; ++i) tick(lab);
        EXPECT_TRUE(lesson_of(lab).attempt.work.outcome_known)
            << "a run of the scene as given, after changed kind " << changed;
    }
}

TEST(LabPrediction, AboutABreedingIsJudgedByARunWithWhatWasBred) {
    Lab lab = opened_lab("22-breeding");
    handle(lab, PredictRequest{0});
    const auto run = [&] {
        for (int i = 0; i < 16 * 60; ++i) tick(lab);
        return lesson_of(lab).attempt.work.outcome_known;
    };
    EXPECT_FALSE(run()) << "nothing is bred yet";
    const Submission& champion = lab.document.lesson->exercise->wrong.front().submission;
    handle(lab, Action::reset);
    handle(lab, EditRequest{SetSensors{{.kind = 0}, champion.sensors}});
    handle(lab, EditRequest{SetBrain{{.kind = 0}, champion.brain}});
    EXPECT_FALSE(lesson_of(lab).attempt.work.outcome_known);
    EXPECT_TRUE(run());
}

TEST(LabPrediction, KnowsThatTheSceneIsNotAsGivenAfterAChangeOfBrainSensorsOrBody) {
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

TEST(LabPrediction, DoesNotKnowTheOutcomeOfARunWithoutTheKindOfTheExercise) {
    Lab lab = aggressor();
    handle(lab, EditRequest{RemoveVehicle{}});
    handle(lab, EditRequest{RemoveKind{0}});
    ASSERT_TRUE(lab.document.session.snapshot().kind_brains.empty());
    EXPECT_TRUE(lesson_of(lab).by_hand);
    for (int i = 0; i < 600; ++i) tick(lab);
    EXPECT_FALSE(lesson_of(lab).attempt.work.outcome_known);
}

}  // namespace
}  // namespace braitenlab::tests::lab_prediction_test
