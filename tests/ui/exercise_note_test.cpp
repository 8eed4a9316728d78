// The student's notes on the exercise card, and the keys of its prediction.
#include "desk.h"

namespace braitenlab::tests::exercise_note_test {

using namespace ui;

namespace {

struct Note : testing::Test {
    Desk desk{1280, 1000, 1, true};
    StudentBook students;

    Note() {
        desk.open_exercise();
        desk.view.documents.students = &students;
        desk.frame(3);
    }
    // What the lab does with a request.
    void take_notes() {
        if (const auto* notes = desk.last<NotesRequest>()) desk.lesson.attempt.notes = notes->text;
        desk.frame(2);
    }
    void press(KeyPress key) {
        desk.key(key);
        desk.frame(2);
    }
};

}  // namespace

TEST_F(Note, IsTypedBelowItsRowAndIsNoShortcut) {
    EXPECT_FALSE(desk.anchors.find("exercise.note.text"));
    desk.click("exercise.note");
    desk.frame(3);
    ASSERT_TRUE(desk.panels.exercise.note.active) << "the row gives the focus to the field";
    for (const char letter : {'R', 'W', ' ', '1'}) desk.key({letter});
    desk.type("row 1");
    desk.frame(3);
    take_notes();
    EXPECT_EQ(desk.lesson.attempt.notes, "row 1");
    EXPECT_TRUE(desk.actions().empty());
    press({key::escape});
    desk.lesson.attempt.answers.prediction = 0;
    press({' '});
    EXPECT_FALSE(desk.panels.exercise.note.active);
    EXPECT_EQ(desk.lesson.attempt.notes, "row 1") << "Escape ends typing and keeps the text";
    EXPECT_EQ(desk.actions(), std::vector{Action::play_pause});
}

TEST_F(Note, BreaksALineThatIsTooWide) {
    desk.click("exercise.note");
    desk.frame(3);
    desk.type("The right wheel runs faster when the lamp is on the right, so it turns left and away from it");
    desk.frame(3);
    take_notes();
    EXPECT_NE(desk.lesson.attempt.notes.find('\n'), std::string::npos);
    std::string joined = desk.lesson.attempt.notes;
    std::replace(joined.begin(), joined.end(), '\n', ' ');
    EXPECT_EQ(joined, "The right wheel runs faster when the lamp is on the right, so it turns left and away from it");
}

TEST_F(Note, ShowsTheNotesOfTheStudent) {
    desk.lesson.attempt.notes = "of Anna";
    desk.panels.exercise.note_open = true;
    desk.frame(2);
    EXPECT_EQ(desk.panels.exercise.note.text, "of Anna");
    desk.lesson.attempt.notes = "of Ben";
    desk.frame(2);
    EXPECT_EQ(desk.panels.exercise.note.text, "of Ben");
    EXPECT_FALSE(desk.last<NotesRequest>());
}

TEST_F(Note, TakesOverWhatAnotherWindowHasWrittenWhileItIsActive) {
    const auto typed = [this](const char* words) {
        desk.type(words);
        desk.frame(2);
        take_notes();
        desk.all.clear();
    };
    desk.click("exercise.note");
    desk.frame(3);
    typed("mine");
    desk.lesson.attempt.notes = "mine\nof the other";
    desk.frame(2);
    ASSERT_TRUE(desk.panels.exercise.note.active);
    EXPECT_EQ(desk.panels.exercise.note.text, "mine\nof the other");
    EXPECT_FALSE(desk.last<NotesRequest>()) << "the earlier text does not come back";
    typed("!");
    EXPECT_EQ(desk.lesson.attempt.notes, "mine!\nof the other") << "the cursor has stayed";
    desk.lesson.attempt.notes = "ü";
    desk.frame(2);
    desk.key({'Z', true});
    desk.frame(2);
    take_notes();
    EXPECT_EQ(desk.lesson.attempt.notes, "ü") << "undo does not go back to the earlier text";
    typed("a");
    EXPECT_EQ(desk.lesson.attempt.notes, "üa");
}

TEST_F(Note, DigitsAndSpaceChooseAnAnswer) {
    press({'2'});
    ASSERT_TRUE(desk.last<PredictRequest>()) << "wherever the focus is";
    EXPECT_EQ(desk.last<PredictRequest>()->option, 1);
    desk.lesson.attempt.answers.prediction = 1;
    desk.panels.keyboard.focus.clear();
    press({'1'});
    EXPECT_EQ(desk.last<PredictRequest>()->option, 0) << "it can be corrected until the first run";
    desk.lesson.attempt.work.has_run = true, desk.lesson.at_start = false;
    desk.panels.keyboard.focus.clear();
    press({'2'});
    EXPECT_EQ(desk.panels.keyboard.focus, "slider.LR") << "after it has begun, a digit takes a slider";
    desk.lesson.attempt.work.has_run = false, desk.lesson.at_start = true;
    desk.lesson.attempt.answers.prediction = -1;
    desk.panels.keyboard.focus = "exercise.predict.1";
    desk.panels.keyboard.shown = true;
    press({'3'});
    ASSERT_TRUE(desk.last<PredictRequest>());
    EXPECT_EQ(desk.last<PredictRequest>()->option, 2);
    EXPECT_EQ(desk.panels.keyboard.focus, "exercise.predict.3");
    press({key::up});
    EXPECT_EQ(desk.panels.keyboard.focus, "exercise.predict.2") << "arrows move between the answers";
    EXPECT_EQ(desk.last<PredictRequest>()->option, 2) << "and choose none";
    for (int i = 0; i < 3; ++i) press({key::down});
    EXPECT_EQ(desk.panels.keyboard.focus, "exercise.predict.3") << "the last one";
    desk.lesson.attempt.answers.prediction = 2;
    press({' '});
    EXPECT_EQ(desk.actions(), std::vector{Action::play_pause}) << "it is chosen already";
    desk.panels.keyboard.focus = "exercise.predict.1";
    desk.panels.keyboard.shown = true;
    press({' '});
    EXPECT_EQ(desk.last<PredictRequest>()->option, 0);
    EXPECT_EQ(desk.actions().size(), 1u);
    desk.panels.keyboard.shown = false;
    desk.lesson.attempt.answers.prediction = 2;
    press({' '});
    EXPECT_EQ(desk.actions().size(), 2u) << "Space plays where no focus is visible";
    desk.lesson.attempt.work.outcome_known = true;
    desk.panels.keyboard.focus = "exercise.hint";
    const auto before = desk.all.size();
    press({'1'});
    for (std::size_t i = before; i < desk.all.size(); ++i)
        EXPECT_FALSE(std::holds_alternative<PredictRequest>(desk.all[i])) << "too late";
}

TEST_F(Note, DigitsChooseSlidersOnceARunWithAnAnswerHasBegun) {
    const auto resets = [&](int answer) {
        desk.lesson.attempt.answers.prediction = answer;
        desk.lesson.attempt.work.has_run = true;
        desk.panels.keyboard.focus.clear();
        desk.frame(2);
        ASSERT_TRUE(desk.view.may.open_prediction) << "at the start it can be changed again";
    };
    resets(0);
    press({'2'});
    EXPECT_FALSE(desk.last<PredictRequest>());
    EXPECT_EQ(desk.panels.keyboard.focus, "slider.LR");
    desk.panels.keyboard.focus = "exercise.predict.1";
    desk.panels.keyboard.shown = true;
    press({'3'});
    ASSERT_TRUE(desk.last<PredictRequest>()) << "with the focus on an answer";
    desk.all.clear();
    resets(-1);
    press({'2'});
    EXPECT_TRUE(desk.last<PredictRequest>()) << "the question is still unanswered";
}

TEST_F(Note, AHintSaysHowLongItTakes) {
    desk.lesson.attempt.answers.hint_ready = false;
    desk.lesson.hint_in = 12;
    desk.frame(2);
    bool said = false;
    for (const Written& written : desk.written) said |= written.words == "Next hint in 12 s, or with the next run";
    EXPECT_TRUE(said);
}

TEST_F(Note, APassedExerciseRunsItsStartsAtOnceAndComesBack) {
    EXPECT_FALSE(desk.anchors.find("exercise.together"));
    desk.lesson.attempt.work.has_run = true;
    Grade grade;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) grade.starts.push_back({seed, true, {}, {}});
    grade.count = 10, grade.good = true;
    desk.lesson.grade = grade;
    desk.frame(3);
    desk.click("exercise.together");
    ASSERT_TRUE(desk.last<TogetherRequest>());
    EXPECT_TRUE(desk.last<TogetherRequest>()->on);
    desk.lesson.together = true;
    desk.frame(2);
    desk.click("exercise.together");
    EXPECT_FALSE(desk.last<TogetherRequest>()->on);
}

TEST_F(Note, TheKeptBrainIsOfferedUntilItIsPassed) {
    desk.lesson.key = "own.toml";
    students.student().exercises["own.toml"] = {.passed = true, .best = 9, .starts = 10};
    desk.lesson.standing.has_kept = true;
    desk.frame(3);
    desk.click("exercise.kept");
    EXPECT_TRUE(desk.last<KeptRequest>());
    desk.lesson.standing.has_kept = false;
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("exercise.kept"));
}

TEST_F(Note, DigitsChooseNoAnswerWhileTheStartsRunAtOnce) {
    desk.panels.keyboard.focus = "exercise.predict.1";
    desk.panels.keyboard.shown = true;
    desk.lesson.together = true;
    press({'3'});
    EXPECT_FALSE(desk.last<PredictRequest>());
}

TEST_F(Note, TabLeavesTheField) {
    desk.click("exercise.note");
    desk.frame(3);
    ASSERT_TRUE(desk.panels.exercise.note.active);
    press({key::tab});
    desk.frame(2);
    EXPECT_FALSE(desk.panels.exercise.note.active);
    EXPECT_NE(desk.panels.keyboard.focus, "exercise.note.text");
    EXPECT_EQ(desk.panels.exercise.note.text, "");
}

}  // namespace braitenlab::tests::exercise_note_test
