// The card of the open exercise: heading, buttons, hints, and what stays in sight.
#include <algorithm>
#include <map>
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

TEST(ExerciseCard, NoButtonOfItsFootComesWhereAnotherOneWas) {
    const char* const ids[]{"exercise.hint", "exercise.show_me", "exercise.next",       "exercise.reset",
                            "exercise.note", "exercise.hand_in", "exercise.lab_record", "exercise.others"};
    for (const auto& [width, height] : {std::pair{800.0f, 600.0f}, {1024.0f, 768.0f}, {1280.0f, 800.0f}})
        for (const std::string& language : shipped_codes()) {
            Desk desk(width, height, 1, true);
            desk.strings = speaking(language);
            std::map<std::string, Rect> places;
            const auto look = [&](const char* when) {
                desk.frame(6);
                for (const char* id : ids) {
                    const Rect* at = desk.anchors.find(id);
                    if (!at) continue;
                    const auto [known, is_new] = places.emplace(id, *at);
                    const float right = known->second.x + known->second.w;
                    EXPECT_NEAR(at->y, known->second.y, 0.5f) << id << " " << language << " " << width << " " << when;
                    EXPECT_NEAR(at->x + at->w, right, 0.5f) << id << " " << language << " " << width << " " << when;
                    const auto is_in_last_row = [](std::string_view each) {  // a hint, the solution, the next exercise
                        return each == "exercise.hint" || each == "exercise.show_me" || each == "exercise.next";
                    };
                    for (const auto& [other, was] : places)
                        EXPECT_TRUE(other == id || (is_in_last_row(id) && is_in_last_row(other)) || !at->overlaps(was))
                            << id << " where " << other << " was, " << language << " " << width << " " << when;
                }
            };
            desk.open_exercise();
            look("opened");
            predict_and_run(desk, 0);
            look("running");
            unfold_foot(desk);
            look("unfolded");
            desk.panels.exercise.hand_in.asks = true;
            look("a name is asked for");
            desk.panels.exercise.hand_in.asks = false;
            desk.lesson.attempt.work.written = "/home/ana/05-ana.toml";
            desk.lesson.attempt.answers.hints_shown = 3;
            look("the hints are used up");
            pass(desk);
            look("passed");
            desk.lesson.grade.reset();
            desk.lesson.standing.passed_before = true;
            desk.lesson.attempt.answers.hints_shown = 0;
            look("passed before");
        }
}

TEST(ExerciseCard, FoldsItsOtherButtonsForAFingerUntilItIsPassed) {
    Desk desk(1024, 768, 1, true);
    desk.view.program.touch = true, desk.view.program.finger = 44;
    desk.open_exercise();
    predict_and_run(desk, 0);
    desk.frame(6);
    EXPECT_FALSE(desk.anchors.find("exercise.note") || desk.anchors.find("exercise.reset"));
    const Rect card = desk.where("card.exercise"), others = desk.where("exercise.others");
    EXPECT_LT(others.x + others.w, card.x + card.w);
    desk.click("exercise.others");
    desk.frame(6);
    EXPECT_TRUE(desk.anchors.find("exercise.note") && desk.anchors.find("exercise.reset"));
    desk.click("exercise.others");
    pass(desk);
    desk.frame(6);
    EXPECT_TRUE(desk.anchors.find("exercise.hand_in")) << "it is handed in next";
}

TEST(ExerciseCard, StartOverAsksBeforeItTakesChangesBack) {
    for (const float width : {800.0f, 1280.0f}) {
        Desk desk(width, width == 800 ? 600.0f : 800.0f, 1, true);
        desk.open_exercise();
        predict_and_run(desk, 0);
        desk.view.undo_depth = 1;
        desk.frame(3);
        unfold_foot(desk);
        desk.frame(3);
        desk.click("exercise.reset");
        EXPECT_TRUE(desk.actions().empty());
        desk.frame(2);
        desk.click("exercise.reset_no");
        desk.frame(2);
        EXPECT_FALSE(desk.anchors.find("exercise.reset_yes"));
        desk.click("exercise.reset");
        desk.frame(2);
        desk.click("exercise.reset_yes");
        EXPECT_EQ(desk.actions(), std::vector{Action::exercise_reset});
    }
}

TEST(ExerciseCard, EveryStepIsInSightInALowWindowBeforeDuringAndAfterARun) {
    for (const float scale : {1.0f, 2.0f})
        for (const std::string& language : shipped_codes()) {
            Desk desk(800 * scale, 600 * scale, scale, true);
            desk.strings = speaking(language);
            const auto expect_steps = [&](const char* when) {
                desk.frame(8);
                const Rect card = desk.where("card.exercise"), foot = desk.where("exercise.note");
                for (std::size_t i = 1; i <= desk.opened.steps.size(); ++i) {
                    const Rect* at = desk.anchors.find("exercise.step." + std::to_string(i));
                    ASSERT_TRUE(at) << i << " " << language << " " << when;
                    EXPECT_TRUE(inside(*at, card) && at->y + at->h <= foot.y) << i << " " << language << " " << when;
                    EXPECT_GE(at->h, 19 * scale) << i << " " << language << " " << when;
                }
            };
            desk.open_exercise();
            desk.frame(2);
            unfold_foot(desk);
            predict_and_run(desk, 0);
            expect_steps("running");
            desk.lesson.attempt.answers.hints_shown = 3;
            desk.lesson.attempt.work.outcome_known = true;
            expect_steps("with hints and outcome");
            desk.lesson.verdicts[1].done = true;
            desk.panels.exercise.hand_in.asks = true;
            expect_steps("one is done, a name is asked for");
            desk.panels.exercise.hand_in.asks = false;
            pass(desk);
            expect_steps("passed");
        }
}

TEST(ExerciseCard, AClickShowsAnotherStepInFullInALowWindow) {
    Desk desk(800, 600, 1, true);
    desk.open_exercise();
    predict_and_run(desk, 0);
    desk.frame(4);
    const float line = desk.where("exercise.step.3").h;
    EXPECT_GT(desk.where("exercise.step.1").h, 1.5f * line);
    desk.click("exercise.step.3");
    EXPECT_GT(desk.where("exercise.step.3").h, 1.5f * line);
    EXPECT_LT(desk.where("exercise.step.1").h, 1.5f * line);
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
            unfold_foot(desk);
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
                desk.frame(2);
                unfold_foot(desk);
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
