// What the exercise card tells before and after the prediction, and where its outcome stands.
#include "exercise_on_desk.h"

namespace braitenlab::tests::exercise_outcome_test {

using namespace ui;

TEST(ExerciseOutcome, APredictionIsMadeAndChangedAtTheStartOfARunUntilTheOutcomeIsKnown) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.frame(3);
    desk.click("exercise.predict.2");
    ASSERT_EQ(desk.all.size(), 1u);
    EXPECT_EQ(std::get<PredictRequest>(desk.all[0]).option, 1);
    EXPECT_FALSE(desk.says("It can be changed until the run begins.")) << "nothing is chosen";
    desk.lesson.attempt.answers.prediction = 1;
    desk.frame(3);
    EXPECT_TRUE(desk.says("It can be changed until the run begins."));
    desk.lesson.attempt.work.has_run = true;  // and was reset
    desk.frame(3);
    desk.click("exercise.predict.1");
    ASSERT_EQ(desk.all.size(), 2u);
    EXPECT_EQ(std::get<PredictRequest>(desk.all[1]).option, 0);
    desk.lesson.attempt.work.outcome_known = true;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("exercise.predict.2")) << "a prediction cannot be changed";
    desk.lesson.attempt.answers.prediction = -1;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("exercise.predict.2")) << "and not be made";
}

TEST(ExerciseOutcome, APredictionIsLockedWhileItRuns) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.frame(3);
    desk.click("exercise.predict.1");
    EXPECT_TRUE(desk.last<PredictRequest>());
    desk.lesson.attempt.answers.prediction = 0;
    begin_run(desk);
    desk.panels.keyboard.focus = "exercise.predict.1";
    desk.all.clear();
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("exercise.predict.2")) << "the steps need its room";
    EXPECT_TRUE(desk.says("You predicted")) << "the chosen answer stays";
    EXPECT_EQ(desk.panels.keyboard.focus, "") << "the focus is on no row that is gone";
    EXPECT_TRUE(desk.says("Locked until the run has shown the outcome. Reset (R) unlocks it."));
    desk.key({'2'});
    EXPECT_FALSE(desk.last<PredictRequest>());
    desk.lesson.attempt.answers.prediction = -1;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("exercise.predict.2")) << "an answer in the run is no prediction";
    EXPECT_TRUE(desk.says("The run has begun. Reset (R), then answer."));
    desk.lesson.as_given = false;
    desk.frame(3);
    EXPECT_FALSE(desk.says("The run has begun")) << "this run does not show the outcome";
    EXPECT_TRUE(desk.anchors.find("exercise.as_given"));
}

TEST(ExerciseOutcome, TellsNothingOfTheOutcomeBeforeThePrediction) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.frame(3);
    EXPECT_FALSE(desk.says("Aggressor"));
    EXPECT_FALSE(desk.anchors.find("exercise.why"));
    EXPECT_FALSE(desk.anchors.find("equations"));
    EXPECT_TRUE(desk.says(desk.strings("character.hidden")));
    EXPECT_TRUE(desk.anchors.find("brain.picture"));
    desk.opened.prediction.hides_brain = true;
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("brain.picture"));
    const Rect answer = desk.where("exercise.predict.2");
    desk.lesson.attempt.answers.prediction = 0;
    desk.frame(3);
    EXPECT_EQ(desk.where("exercise.predict.2"), answer) << "a second click chooses the same answer";
    desk.lesson.attempt.work.has_run = true;  // a run without an answer, and a reset
    desk.frame(3);
    EXPECT_EQ(desk.where("exercise.predict.2"), answer);
    desk.lesson.at_start = false;
    desk.frame(3);
    EXPECT_TRUE(desk.says("Aggressor"));
    for (const char* id : {"exercise.why", "equations", "brain.picture"}) EXPECT_TRUE(desk.anchors.find(id)) << id;
    EXPECT_FALSE(desk.says(desk.strings("character.hidden")));
}

TEST(ExerciseOutcome, TheReasonIsToldOnceItIsKnown) {
    Desk desk(1280, 800, 1, true);
    desk.open_exercise();
    desk.opened.why = "Because.";
    desk.frame(3);
    desk.lesson.attempt.answers.prediction = 0;
    desk.lesson.attempt.work.has_run = true;
    desk.frame(3);
    desk.lesson.at_start = false;
    desk.panels.exercise.why_open = true;
    desk.frame(3);
    EXPECT_FALSE(desk.says("Because."));
    EXPECT_TRUE(desk.anchors.find("exercise.why"));
    desk.lesson.attempt.work.outcome_known = true;
    desk.frame(3);
    EXPECT_TRUE(desk.says("Because."));
}

TEST(ExerciseOutcome, TheOutcomeIsShownAsSoonAsItIsKnownAndInTheVisiblePartOfTheCard) {
    for (const bool passed : {false, true}) {
        Desk desk(1024, 768, 1, true);
        desk.open_exercise();
        desk.panels.exercise.why_open = true;
        desk.lesson.attempt.answers.hints_shown = 3;
        if (passed) pass(desk);
        desk.lesson.attempt.answers.prediction = 0;
        desk.frame(4);
        EXPECT_FALSE(desk.says("What happened"));
        desk.lesson.attempt.work.outcome_known = true;
        desk.frame(4);
        bool visible = false;
        for (const Written& w : desk.written)
            visible |= w.words.starts_with("What happened: It turned away") && inside(w.rect, w.clip);
        EXPECT_TRUE(visible) << passed;
    }
}

TEST(ExerciseOutcome, SaysThatTheOutcomeIsOlderThanTheChangesOfTheBrain) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    predict_and_run(desk, 0);
    desk.lesson.attempt.work.outcome_known = true;
    desk.frame(3);
    EXPECT_TRUE(desk.says("What happened: It turned away."));
    desk.lesson.as_given = false;
    desk.frame(3);
    EXPECT_TRUE(desk.says("Without your changes: It turned away."));
}

TEST(ExerciseOutcome, ShowsTheStepsAboveThePredictionFromTheRunOnAlsoWhenTheBrainIsChanged) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.frame(3);
    EXPECT_LT(desk.where("exercise.predict").y, desk.where("exercise.step.1").y) << "first the question";
    predict_and_run(desk, 0);
    desk.frame(3);
    EXPECT_GT(desk.where("exercise.predict").y, desk.where("exercise.step.1").y);
    desk.lesson.attempt.work.outcome_known = true;
    desk.frame(3);
    EXPECT_GT(desk.where("exercise.predict").y, desk.where("exercise.step.1").y);
    desk.lesson.as_given = false;
    desk.frame(3);
    EXPECT_GT(desk.where("exercise.predict").y, desk.where("exercise.step.1").y);
}

TEST(ExerciseOutcome, HintsStayWhereTheyAreWhenItArrives) {
    Desk desk(1280, 1400, 1, true);
    desk.open_exercise();
    predict_and_run(desk, 0);
    desk.lesson.attempt.answers.hints_shown = 2;
    desk.frame(6);
    const auto top_of = [&](std::string_view words) {
        for (const Written& each : desk.written)
            if (each.words == words) return each.rect.y;
        return -1.0f;
    };
    const float first = top_of("A nudge."), second = top_of("The principle.");
    ASSERT_GT(first, desk.where("exercise.step.3").y);
    ASSERT_GT(second, first);
    desk.lesson.attempt.work.outcome_known = true;
    desk.frame(6);
    EXPECT_GT(desk.where("exercise.came_true").y, second);
    EXPECT_FLOAT_EQ(top_of("A nudge."), first);
    EXPECT_FLOAT_EQ(top_of("The principle."), second);
}

TEST(ExerciseOutcome, ASecretBrainIsNotShown) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.lesson.attempt.answers.prediction = 0;
    desk.opened.hides = {desk.now.scene->kinds[static_cast<std::size_t>(desk.now.vehicles[0].kind)].name};
    desk.frame(3);
    for (const char* id : {"slider.LL", "equations", "brain.picture"}) EXPECT_FALSE(desk.anchors.find(id)) << id;
    desk.view.mode = Mode::wiring;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("wire.LL"));
    EXPECT_TRUE(desk.says("brain is hidden"));
}

}  // namespace braitenlab::tests::exercise_outcome_test
