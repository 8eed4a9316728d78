// The grade on the exercise card, and the button for the next exercise.
#include <utility>

#include "exercise_on_desk.h"

namespace braitenlab::tests::exercise_grade_test {

using namespace ui;

TEST(ExerciseGrade, CountsTheTestedStartsUntilTheGradeIsComplete) {
    Desk desk;
    pass(desk);
    desk.lesson.grade.reset();
    desk.lesson.standing.starts_tested = 4;
    desk.frame(3);
    EXPECT_TRUE(desk.says("Testing the starts: 4 of 10"));
    EXPECT_FALSE(desk.anchors.find("exercise.grade"));
    pass(desk);
    desk.lesson.standing.starts_tested.reset();
    desk.frame(3);
    EXPECT_FALSE(desk.says("Testing"));
    EXPECT_TRUE(desk.anchors.find("exercise.grade"));
}

TEST(ExerciseGrade, ANoteIsShownWhenARunDoesNotCount) {
    Desk desk;
    desk.open_exercise();
    const auto said = [&] {
        desk.frame(3);
        std::string all;
        for (const Written& w : desk.written) all += w.words + " ";
        return all.find("moved or steered") != std::string::npos;
    };
    EXPECT_FALSE(said());
    desk.lesson.by_hand = true;
    EXPECT_TRUE(said());
    for (Verdict& verdict : desk.lesson.verdicts) verdict.done = true;
    EXPECT_FALSE(said()) << "no start is left to test";
}

TEST(ExerciseGrade, AStartsPictureReplaysIt) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    begin_run(desk);
    desk.lesson.grade = graded({true, false, true}, false);
    desk.lesson.grade->starts[1].verdicts = {Verdict{true, {}}, Verdict{false, {{1.25f, 0.6f, "m", true, true}}}};
    desk.frame(5);
    desk.click("exercise.start.2");
    const auto* seed = desk.last<SeedRequest>();
    ASSERT_TRUE(seed);
    EXPECT_EQ(seed->seed, 2u);
    desk.point("exercise.reset");
    desk.frame(2);
    desk.point("exercise.start.2");
    desk.frame(60);
    EXPECT_TRUE(desk.says("Start 2 fails: Touch the lamp"));
    EXPECT_TRUE(desk.says("best\u00a01.25\u00a0m,\u00a0goal\u00a0≤\u00a00.60"));
}

TEST(ExerciseGrade, TellsNoneSomeAndAllOfTheStartsApart) {
    Desk desk(1280, 1000, 1, true);
    pass(desk);
    desk.frame(3);
    EXPECT_TRUE(desk.says(desk.strings("exercise.passed_all")));
    desk.lesson.grade = graded({true, true, false}, true);
    desk.frame(3);
    EXPECT_TRUE(desk.says(desk.strings("exercise.passed_next")));
    desk.lesson.grade = graded({true, false, false}, false);
    desk.frame(3);
    EXPECT_TRUE(desk.says("It works from some places only"));
    desk.lesson.grade = graded({false, false, false}, false);
    desk.frame(3);
    EXPECT_FALSE(desk.says("It works from some places only"));
    EXPECT_TRUE(desk.says("works from none of them"));
}

TEST(ExerciseGrade, SaysWhichRunTheTicksAreOf) {
    Desk desk(1280, 1000, 1, true);
    pass(desk);
    desk.frame(3);
    EXPECT_FALSE(desk.says("The ticks are of the present run"));
    desk.lesson.verdicts[0].done = false;  // after a reset
    desk.frame(3);
    EXPECT_TRUE(desk.says("The ticks are of the present run"));
    desk.lesson.standing.changed_since_done = true;
    desk.frame(3);
    EXPECT_TRUE(desk.says("The brain has changed since these ticks"));
}

TEST(ExerciseGrade, SaysThatThePassedSolutionWasShown) {
    Desk desk(1280, 1000, 1, true);
    pass(desk);
    desk.frame(3);
    EXPECT_TRUE(desk.says("Well done"));
    desk.lesson.attempt.work.solution_shown = true;
    desk.frame(3);
    EXPECT_FALSE(desk.says("Well done"));
    EXPECT_TRUE(desk.says("do it yourself"));
}

TEST(ExerciseGrade, EveryStepAndTheNextButtonAreVisibleOnceItIsPassed) {
    for (const std::string& language : shipped_codes()) {
        Desk desk(1024, 768, 1, true);
        desk.strings = speaking(language);
        pass(desk);
        desk.panels.exercise.why_open = true;
        desk.lesson.attempt.answers.hints_shown = 3;
        desk.frame(5);
        const Rect card = desk.where("card.exercise"), buttons = desk.where("exercise.next");
        EXPECT_TRUE(inside(buttons, card)) << language;
        for (const char* step : {"exercise.step.1", "exercise.step.2", "exercise.step.3"}) {
            const Rect r = desk.where(step);
            EXPECT_GE(r.h, 22) << language << ": " << step << " is cut";
            EXPECT_LT(r.y + r.h, buttons.y + 1) << language;
        }
    }
}

TEST(ExerciseGrade, TheStepsOfAPassedExerciseHaveNoValuesAndCanBeFolded) {
    Desk desk(1280, 1000, 1, true);
    pass(desk);
    desk.lesson.verdicts[0].measures = {{0.5f, 0.6f, "m", true}};
    desk.frame(3);
    EXPECT_TRUE(desk.says("Steps: 3 of 3 done"));
    EXPECT_FALSE(desk.says("0.50\u00a0m")) << "the result has their room";
    desk.click("exercise.steps");
    desk.frame(2);
    EXPECT_TRUE(desk.says("Steps: 3 of 3 done"));
    EXPECT_FALSE(desk.anchors.find("exercise.step.1"));
    desk.click("exercise.steps");
    desk.lesson.verdicts[0].done = false;  // after a reset
    desk.frame(2);
    EXPECT_TRUE(desk.anchors.find("exercise.step.1"));
    EXPECT_TRUE(desk.says("0.50\u00a0m"));
}

TEST(ExerciseGrade, KeepsItsMarkAndTheNextButtonOnceItWasPassed) {
    for (const std::string& language : shipped_codes()) {
        Desk desk(1024, 768, 1, true);
        desk.strings = speaking(language);
        pass(desk);
        desk.lesson.grade.reset();  // the brain is another one now
        desk.frame(3);
        EXPECT_FALSE(desk.anchors.find("exercise.next"));
        EXPECT_FALSE(desk.anchors.find("exercise.passed_mark"));
        desk.lesson.standing.passed_before = true;
        unfold_foot(desk);
        desk.frame(3);
        EXPECT_TRUE(inside(desk.where("exercise.passed_mark"), desk.where("card.exercise"))) << language;
        EXPECT_TRUE(inside(desk.where("exercise.next"), desk.where("card.exercise"))) << language;
        EXPECT_TRUE(inside(desk.where("exercise.hint"), desk.where("card.exercise"))) << language;
        EXPECT_TRUE(inside(desk.where("exercise.reset"), desk.where("card.exercise"))) << language;
    }
}

TEST(ExerciseGrade, TheLightBulbAtTheNextButtonIsBelowTheScrolledPartOfTheCard) {
    Desk desk(1024, 768, 1, true);
    pass(desk);
    desk.frame(5);
    ASSERT_EQ(desk.panels.prompts.highlight.anchor, "exercise.next");
    constexpr float above_buttons = 8, rounding = 0.5f;
    EXPECT_GE(desk.pointed_out.bulb.y, desk.where("exercise.next").y - above_buttons - rounding);
}

TEST(ExerciseGrade, ItsNextButtonOpensTheNextExerciseOrTheListOfFiles) {
    Desk desk;
    const std::vector<CatalogueEntry> more{{"05-aggressor", "5.toml", "Aggressor", "", 5},
                                           {"08-overrun", "8.toml", "Overrun", "", 8},
                                           {"06-love", "6.toml", "Love", "", 6},
                                           {"2a-coward", "2a.toml", "Coward", "It turns away."}};
    pass(desk);
    desk.view.documents.catalogue = &more;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("exercise.hint")) << "a passed exercise needs no hint";
    desk.click("exercise.next");
    ASSERT_EQ(desk.all.size(), 1u);
    EXPECT_EQ(std::get<OpenRequest>(desk.all[0]).path, "6.toml");
    EXPECT_TRUE(std::get<OpenRequest>(desk.all[0]).next_exercise);
    EXPECT_TRUE(desk.says("Passed. Next exercise")) << "in the bar";
    desk.opened.number = 0;
    desk.click("exercise.next");
    EXPECT_EQ(desk.all.size(), 1u) << "an exercise of one's own is in no order: the list opens";
    EXPECT_EQ(desk.panels.sheet, Sheet::files);
    desk.opened.number = 5;
    desk.panels.sheet = Sheet::none;
    const std::vector<CatalogueEntry> last{more[0], more[3]};
    desk.view.documents.catalogue = &last;
    desk.frame(3);
    EXPECT_TRUE(desk.says("Passed. More to try")) << "the bar has the word of the button";
    desk.click("exercise.next");
    EXPECT_EQ(desk.panels.sheet, Sheet::files);
}

TEST(ExerciseGrade, EnterOpensTheNextExerciseWhileAllStartsRunAtOnce) {
    Desk desk;
    const std::vector<CatalogueEntry> more{{"06-love", "6.toml", "Love", "", 6}};
    desk.view.documents.catalogue = &more;
    pass(desk);
    desk.lesson.together = true;
    desk.panels.keyboard.focus = "slider.LL";
    desk.panels.keyboard.shown = false;
    desk.frame(3);
    desk.key({key::enter});
    desk.frame(2);
    EXPECT_EQ(desk.panels.sliders.typed, "") << "the bar says that Enter is the next exercise";
    ASSERT_TRUE(desk.last<OpenRequest>());
    EXPECT_EQ(desk.last<OpenRequest>()->path, "6.toml");
}

TEST(ExerciseGrade, EnterOpensTheNextExerciseOnceItIsPassed) {
    Desk desk;
    const std::vector<CatalogueEntry> more{{"06-love", "6.toml", "Love", "", 6}};
    desk.view.documents.catalogue = &more;
    pass(desk);
    desk.panels.keyboard.focus = "slider.LL";
    desk.panels.keyboard.shown = false;
    desk.frame(3);
    const auto grade = std::exchange(desk.lesson.grade, std::nullopt);
    desk.key({key::enter});
    desk.frame(2);
    EXPECT_FALSE(desk.last<OpenRequest>()) << "not passed";
    EXPECT_EQ(desk.panels.sliders.typed, "slider.LL");
    desk.key({key::escape});
    desk.frame(2);
    desk.lesson.grade = grade;
    desk.panels.keyboard.focus = "exercise.reset";
    desk.panels.keyboard.shown = true;
    desk.frame(2);
    desk.key({key::enter});
    desk.frame(2);
    EXPECT_FALSE(desk.last<OpenRequest>()) << "the focused button has Enter";
    EXPECT_EQ(desk.actions(), std::vector{Action::exercise_reset});
    desk.panels.keyboard.focus = "slider.LL";
    desk.panels.keyboard.shown = false;
    desk.key({key::enter});
    desk.frame(2);
    ASSERT_TRUE(desk.last<OpenRequest>()) << "a focus without a ring";
    EXPECT_TRUE(desk.last<OpenRequest>()->next_exercise);
    EXPECT_TRUE(desk.panels.sliders.typed.empty());
}

TEST(ExerciseGrade, EnterIsWhatTheBarSaysAlsoWhileASliderHasTheFocus) {
    Desk desk(1280, 800, 1, true);
    const std::vector<CatalogueEntry> more{{"06-love", "6.toml", "Love", "", 6}};
    desk.view.documents.catalogue = &more;
    pass(desk);
    desk.key({'1'});
    desk.frame(3);
    ASSERT_TRUE(desk.panels.keyboard.shown && desk.panels.keyboard.focus == "slider.LL");
    EXPECT_TRUE(desk.says("Passed. Next exercise"));
    EXPECT_FALSE(desk.says("types a number"));
    desk.key({key::enter});
    desk.frame(2);
    ASSERT_TRUE(desk.last<OpenRequest>());
    EXPECT_TRUE(desk.panels.sliders.typed.empty());
}

}  // namespace braitenlab::tests::exercise_grade_test
