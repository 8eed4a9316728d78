#include "core/lesson/disclosure.h"

#include <gtest/gtest.h>

namespace braitenlab::tests::disclosure_test {
namespace {

Exercise with_prediction(bool hides_brain = false) {
    Exercise exercise;
    exercise.scene.kinds = {Kind{.name = "student"}, Kind{.name = "secret"}};
    exercise.prediction = {"What will it do?", {"turn", "flee"}, 0, "It turned.", 3, {}, hides_brain};
    exercise.offers = {"LL"};
    return exercise;
}

TEST(Disclosure, OfASceneShowsEverythingButWhatOnlyAnExerciseHas) {
    EXPECT_EQ(disclosure_of(nullptr, {}), Disclosure{});
    EXPECT_FALSE(Disclosure{}.open_prediction);
    EXPECT_FALSE(Disclosure{}.solution_run);
}

TEST(Disclosure, NothingTellsTheOutcomeBeforeThePrediction) {
    const Exercise exercise = with_prediction(true);
    const Disclosure may = disclosure_of(&exercise, {});
    EXPECT_TRUE(may.open_prediction);
    for (const bool Disclosure::*part :
         {&Disclosure::outcome, &Disclosure::future, &Disclosure::solution_run, &Disclosure::brains,
          &Disclosure::characters, &Disclosure::why, &Disclosure::other_brains, &Disclosure::robots})
        EXPECT_FALSE(may.*part);
    EXPECT_FALSE(disclosure_of(&exercise, {.has_run = true}).solution_run) << "a run without an answer";
    const Exercise shows_brain = with_prediction(false);
    EXPECT_TRUE(disclosure_of(&shows_brain, {}).brains);
    EXPECT_FALSE(disclosure_of(&shows_brain, {}).why);
}

TEST(Disclosure, APredictedRunAKnownOutcomeOrAPassedExerciseTellsTheOutcome) {
    const Exercise exercise = with_prediction(true);
    for (const Known& known :
         {Known{.predicted = true, .has_run = true}, Known{.outcome = true}, Known{.passed = true}}) {
        EXPECT_TRUE(disclosure_of(&exercise, known).outcome);
        EXPECT_TRUE(disclosure_of(&exercise, known).brains);
    }
}

TEST(Disclosure, AnAnswerThatCanStillBeChangedBeforeTheFirstRunTellsNothing) {
    const Exercise exercise = with_prediction(true);
    const Disclosure may = disclosure_of(&exercise, {.predicted = true});
    EXPECT_TRUE(may.open_prediction);
    for (const bool Disclosure::*part : {&Disclosure::outcome, &Disclosure::future, &Disclosure::brains,
                                         &Disclosure::characters, &Disclosure::why, &Disclosure::robots})
        EXPECT_FALSE(may.*part);
    const Known at_start_again{.predicted = true, .has_run = true};
    EXPECT_TRUE(disclosure_of(&exercise, at_start_again).outcome) << "a reset hides nothing again";
}

TEST(Disclosure, APredictionIsOpenAtTheStartOfARunUntilTheOutcomeIsKnown) {
    const Exercise exercise = with_prediction();
    EXPECT_TRUE(disclosure_of(&exercise, {.predicted = true}).open_prediction) << "it can be changed";
    EXPECT_FALSE(disclosure_of(&exercise, {.at_start = false}).open_prediction);
    EXPECT_FALSE(disclosure_of(&exercise, {.outcome = true}).open_prediction);
}

TEST(Disclosure, TheComingSecondsAreShownOnceARunHasBegunUnlessThePredictionCanStillBeChanged) {
    const Exercise exercise = with_prediction();
    Known known{.has_run = true, .at_start = false};
    const auto future = [&] { return disclosure_of(&exercise, known).future; };
    EXPECT_FALSE(future()) << "nothing is predicted";
    known.predicted = true;
    EXPECT_TRUE(future());
    known.at_start = true;
    EXPECT_FALSE(future()) << "after a reset";
    known.as_given = false;
    EXPECT_TRUE(future()) << "of a changed brain";
    known.as_given = true, known.outcome = true;
    EXPECT_TRUE(future());
    known.outcome = false, known.has_run = false, known.as_given = false;
    EXPECT_FALSE(future()) << "before the first run";
}

TEST(Disclosure, TheRunWithTheSolutionIsShownAfterARunAndNotBesideTheGradedStarts) {
    const Exercise exercise = with_prediction();
    EXPECT_FALSE(disclosure_of(&exercise, {.predicted = true}).solution_run);
    EXPECT_TRUE(disclosure_of(&exercise, {.predicted = true, .has_run = true}).solution_run);
    EXPECT_FALSE(disclosure_of(&exercise, {.predicted = true, .has_run = true, .together = true}).solution_run);
}

TEST(Disclosure, OtherBrainsAreShownOnlyWhereTheExerciseOffersAllControls) {
    Exercise exercise = with_prediction();
    const Known known{.outcome = true, .has_run = true};
    EXPECT_FALSE(disclosure_of(&exercise, known).other_brains);
    EXPECT_TRUE(disclosure_of(&exercise, known).robots);
    Known free = known;
    free.free_play = true;
    EXPECT_TRUE(disclosure_of(&exercise, free).other_brains);
    exercise.offers.clear();
    EXPECT_TRUE(disclosure_of(&exercise, known).other_brains);
}

TEST(Disclosure, AQuestionOfAPageHidesTheFutureAndItsAnswerTellsTheOutcome) {
    EXPECT_FALSE(disclosure_of(nullptr, {.page_asks = true}).future);
    EXPECT_TRUE(disclosure_of(nullptr, {.page_asks = true}).outcome);
    EXPECT_TRUE(disclosure_of(nullptr, {.page_asks = true, .page_answers = true}).future);
    const Exercise exercise = with_prediction(true);
    const Disclosure answered = disclosure_of(&exercise, {.page_asks = true, .page_answers = true});
    EXPECT_TRUE(answered.outcome);
    EXPECT_TRUE(answered.brains);
}

TEST(Disclosure, ALectureHidesBrainsAndCharacters) {
    const Disclosure no_brain = disclosure_of(nullptr, {.brain_revealed = false});
    EXPECT_FALSE(no_brain.brains);
    EXPECT_FALSE(no_brain.characters) << "its name tells the brain";
    EXPECT_FALSE(no_brain.why);
    EXPECT_FALSE(no_brain.other_brains);
    const Disclosure no_name = disclosure_of(nullptr, {.character_revealed = false});
    EXPECT_TRUE(no_name.brains);
    EXPECT_FALSE(no_name.characters);
}

TEST(Disclosure, AKindIsSecretByItsSceneOrItsExercise) {
    Exercise exercise = with_prediction();
    Scene scene = exercise.scene;
    EXPECT_FALSE(is_secret(&exercise, scene, 1));
    exercise.hides = {"secret"};
    EXPECT_TRUE(is_secret(&exercise, scene, 1));
    EXPECT_FALSE(is_secret(&exercise, scene, 0));
    EXPECT_FALSE(is_secret(nullptr, scene, 1));
    scene.kinds[0].hidden = true;
    EXPECT_TRUE(is_secret(nullptr, scene, 0));
}

}  // namespace
}  // namespace braitenlab::tests::disclosure_test
