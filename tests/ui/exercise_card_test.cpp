// The card of the open exercise: heading, buttons, hints, and what stays in sight.
#include <algorithm>
#include <utility>

#include "exercise_on_desk.h"
#include "ui/panels/course/pages.h"

namespace braitenlab::tests::exercise_card_test {

using namespace ui;

namespace {

// The text of the last frame, or the first line of it; null: it has not been written.
const Written* written(const Desk& desk, std::string_view words) {
    for (const Written& each : desk.written)
        if (each.words.size() > 6 && words.starts_with(each.words)) return &each;
    return nullptr;
}

}  // namespace

TEST(ExerciseCard, ItsHeadingTellsExercisesOfOneNumberApart) {
    Desk desk;
    desk.open_exercise();
    desk.frame(3);
    const std::string number = std::to_string(desk.opened.number);
    EXPECT_TRUE(desk.says("EXERCISE " + number + "\n"));
    const CatalogueEntry open{.name = desk.opened.id, .number = desk.opened.number};
    CatalogueEntry earlier = open;
    earlier.name = "0";
    const std::vector<CatalogueEntry> both{earlier, open};
    desk.view.documents.catalogue = &both;
    desk.frame(3);
    EXPECT_TRUE(desk.says("EXERCISE " + number + "b\n"));
}

TEST(ExerciseCard, HasNoNumberForAnExerciseOutsideTheCourse) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.opened.number = 0;
    desk.frame(3);
    const auto writes = [&](std::string_view words) {
        return std::any_of(desk.written.begin(), desk.written.end(),
                           [&](const Written& written) { return written.words == words; });
    };
    EXPECT_TRUE(writes("EXERCISE"));
    EXPECT_FALSE(writes("EXERCISE 0"));
}

TEST(ExerciseCard, APageOfTheManualThatItNamesHasAButton) {
    Desk desk;
    desk.open_exercise();
    desk.opened.why = "docs/robots.md shows how to build one.";
    desk.lesson.attempt.work.outcome_known = true;
    desk.frame(3);
    desk.panels.exercise.why_open = true;
    desk.frame(3);
    desk.click("exercise.page");
    ASSERT_TRUE(desk.last<PageRequest>());
    EXPECT_EQ(desk.last<PageRequest>()->page, "docs/robots.md");
}

TEST(ExerciseCard, ATextNamesPagesOfTheManualAlone) {
    using Pages = std::vector<std::string>;
    EXPECT_EQ(pages_in("docs/robots.md, docs/teaching.md and docs/robots.md"),
              (Pages{"docs/robots.md", "docs/teaching.md"}));
    for (const char* text :
         {"", "docs/", "docs/.md", "docs/../secret.md", "docs/a/b.md", "docs/robots.txt", "robots.md"})
        EXPECT_EQ(pages_in(text), Pages{}) << text;
}

TEST(ExerciseCard, TheReasonIsFoldedInTheNextExercise) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.lesson.attempt.answers.prediction = 0;
    desk.frame(2);
    desk.panels.exercise.why_open = true;
    desk.frame(2);
    EXPECT_TRUE(desk.panels.exercise.why_open);
    desk.opened.id = "06-love";
    desk.frame(2);
    EXPECT_FALSE(desk.panels.exercise.why_open);
}

TEST(ExerciseCard, ItsButtonsRequestAHintAndAReset) {
    Desk desk;
    desk.open_exercise();
    desk.frame(3);
    desk.click("exercise.hint");
    desk.click("exercise.reset");
    EXPECT_EQ(desk.actions(), (std::vector{Action::hint, Action::exercise_reset}));
    desk.all.clear();
    desk.lesson.attempt.answers.hint_ready = false;
    desk.click("exercise.hint");
    EXPECT_TRUE(desk.all.empty());
}

TEST(ExerciseCard, ShowsTheSolutionAfterTheLastHint) {
    Desk desk(1280, 1000, 1, true);
    desk.open_exercise();
    desk.lesson.attempt.work.has_run = true;
    desk.lesson.attempt.answers.hints_shown = 2;
    desk.frame(3);
    EXPECT_TRUE(desk.anchors.find("exercise.hint"));
    EXPECT_FALSE(desk.anchors.find("exercise.show_me"));
    desk.lesson.attempt.answers.hints_shown = 3;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("exercise.hint"));
    desk.click("exercise.show_me");
    EXPECT_TRUE(desk.last<ShowMeRequest>());
}

TEST(ExerciseCard, ItsButtonsStayVisibleWhenTheCardIsLong) {
    Desk desk(1024, 768, 1, true);
    desk.open_exercise();
    desk.lesson.attempt.work.has_run = true;
    desk.lesson.attempt.answers.hints_shown = 3;
    desk.panels.exercise.why_open = true;
    desk.lesson.grade = graded({true, false, true}, false);
    desk.frame(5);
    EXPECT_TRUE(inside(desk.where("exercise.show_me"), desk.where("card.exercise")));
    EXPECT_TRUE(inside(desk.where("exercise.reset"), desk.where("card.exercise")));
    EXPECT_TRUE(desk.anchors.find("exercise.grade"));
}

TEST(ExerciseCard, StartOverHasItsWordsInEveryLanguage) {
    for (const std::string& language : shipped_codes())
        for (const bool passed_before : {false, true}) {
            Desk desk(1024, 768, 1, true);
            desk.strings = speaking(language);
            desk.open_exercise();
            desk.lesson.standing.passed_before = passed_before;
            desk.frame(4);
            const Rect at = desk.where("exercise.reset");
            EXPECT_TRUE(std::any_of(desk.written.begin(), desk.written.end(), [&](const Written& each) {
                return each.words == desk.strings("exercise.reset") && inside(each.rect, at);
            })) << language;
        }
}

TEST(ExerciseCard, HasMoreOfTheColumnThanTheInsetInTheWiringEditorOfANarrowWindow) {
    Desk desk(1024, 768, 1, true);
    desk.open_exercise();
    desk.view.mode = Mode::wiring;
    desk.frame(4);
    EXPECT_GT(desk.where("card.exercise").h, 2.4f * desk.layout.scene.h);
}

TEST(ExerciseCard, ItsFootDoesNotScroll) {
    for (const auto& [width, height] : {std::pair{1024.0f, 768.0f}, {1280.0f, 800.0f}})
        for (const std::string& language : shipped_codes())
            for (const bool passed : {false, true}) {
                Desk desk(width, height, 1, true);
                desk.strings = speaking(language);
                pass(desk);
                if (!passed) desk.lesson.grade.reset();
                for (int i = 0; i < 8; ++i) desk.opened.hints.push_back(desk.opened.hints.front());
                desk.lesson.attempt.answers.hints_shown = 11;
                desk.lesson.attempt.notes = "Two wires.";
                desk.panels.exercise.why_open = desk.panels.exercise.hand_in.asks = true;
                desk.frame(6);
                const Rect card = desk.where("card.exercise");
                for (const Shown& shown : desk.shown)
                    for (const char* id : {"exercise.show_me", "exercise.next", "exercise.reset", "exercise.note",
                                           "exercise.hand_in", "exercise.lab_record", "exercise.student"})
                        EXPECT_TRUE(shown.id != id || inside(shown.rect, card))
                            << id << ", " << language << ", " << width;
                for (const char* id :
                     {"exercise.reset", "exercise.note", "exercise.hand_in", "exercise.lab_record", "exercise.student"})
                    EXPECT_TRUE(desk.anchors.find(id)) << id << ", " << language << ", " << width;
            }
}

TEST(ExerciseCard, TheNoteFieldIsInSightOnceItIsUnfolded) {
    Desk desk(1024, 768, 1, true);
    desk.open_exercise();
    for (int i = 0; i < 12; ++i) desk.opened.hints.push_back(desk.opened.hints.front());
    desk.lesson.attempt.answers.hints_shown = 15;
    desk.panels.exercise.why_open = true;
    desk.frame(5);
    desk.click("exercise.note");
    desk.frame(4);
    EXPECT_TRUE(desk.panels.exercise.note.active);
    EXPECT_GT(desk.where("exercise.note.text").h, 80);
}

TEST(ExerciseCard, TitleAndGoalStayInSightAndTheNewestHintIsBelowThemInTheWiringEditor) {
    for (const std::string& language : shipped_codes()) {
        Desk desk(1024, 768, 1, true);
        desk.strings = speaking(language);
        desk.open_exercise();
        desk.opened.offers = {"wiring"};
        desk.lesson.attempt.answers.prediction = 1;
        desk.lesson.attempt.work.has_run = desk.lesson.attempt.work.outcome_known = true;
        desk.frame(6);
        for (const Mode mode : {Mode::paused, Mode::wiring}) {
            desk.view.mode = mode;
            desk.lesson.attempt.answers.hints_shown = 0;
            desk.frame(6);
            for (int hint = 1; hint <= 3; ++hint) {
                desk.lesson.attempt.answers.hints_shown = hint;
                desk.frame(6);
                const Written* goal = written(desk, desk.opened.goal);
                const Written* newest = written(desk, desk.opened.hints[static_cast<std::size_t>(hint - 1)].text);
                ASSERT_TRUE(written(desk, "Aggressor") && goal && newest) << language << hint;
                EXPECT_TRUE(inside(goal->rect, goal->clip)) << language;
                EXPECT_TRUE(inside(newest->rect, newest->clip)) << language << ": hint " << hint << " is cut";
                EXPECT_GE(newest->rect.y, goal->rect.y + goal->rect.h) << language;
                if (mode == Mode::wiring) {
                    EXPECT_LT(newest->rect.y, goal->rect.y + 130) << language;
                }
            }
        }
    }
}

}  // namespace braitenlab::tests::exercise_card_test
