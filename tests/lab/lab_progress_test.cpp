// The student's progress in the open exercise.
#include "app/course/lab_progress.h"

#include <gtest/gtest.h>

#include "app/course/lab_lesson.h"
#include "app/files/file_commands.h"
#include "app/jobs/jobs.h"
#include "app/lab_requests.h"
#include "tests/folder.h"
#include "tests/lab/opened_lab.h"

namespace braitenlab::tests::lab_progress_test {
namespace {

// A lab whose turns do what the program's turns do with an exercise.
struct Attempt {
    Lab lab = opened_lab("05-aggressor");
    Jobs jobs{0};

    Attempt() { turn(); }
    void turn() {
        update_grading(lab, jobs);
        jobs.finish();
        update_grading(lab, jobs);
        follow_progress(lab);
    }
    const Exercise& exercise() const { return *lab.document.lesson->exercise; }
    void take_solution() { handle(lab, EditRequest{SetBrain{{.kind = 0}, exercise().solution.submission.brain}}); }
    void run() {
        handle(lab, Action::reset);
        for (int i = 0; i < 60 * 20 && !referee_of(lab.document).passed(); ++i) tick(lab);
        turn();
    }
    ExerciseProgress progress() const {
        const ExerciseProgress* found = find_progress(lab.students.student(), "05-aggressor");
        return found ? *found : ExerciseProgress{};
    }
};

TEST(LabProgress, KeepsNothingBeforeTheStudentDoesSomething) {
    Attempt attempt;
    EXPECT_TRUE(attempt.lab.students.student().exercises.empty());
    EXPECT_EQ(view_of(attempt.lab).documents.student, "");
}

TEST(LabProgress, KeepsPredictionHintsAndNotes) {
    Attempt attempt;
    handle(attempt.lab, PredictRequest{1});
    handle(attempt.lab, Action::hint);
    handle(attempt.lab, NotesRequest{"two wires"});
    attempt.turn();
    EXPECT_EQ(attempt.progress().prediction, "It turns towards the lamp");
    EXPECT_FALSE(attempt.progress().predicted_right);
    EXPECT_EQ(attempt.progress().hints, 1);
    handle(attempt.lab, Action::exercise_reset);
    attempt.turn();
    EXPECT_EQ(attempt.progress().hints, 1) << "a new attempt takes nothing back";
    EXPECT_EQ(attempt.progress().prediction, "It turns towards the lamp");
    EXPECT_EQ(lesson_view_of(attempt.lab).attempt.notes, "two wires");
    handle(attempt.lab, PredictRequest{0});
    attempt.turn();
    EXPECT_TRUE(attempt.progress().predicted_right);
}

TEST(LabProgress, KeepsThePassedBrainSoThatLeavingAsksNothing) {
    Attempt attempt;
    attempt.take_solution();
    EXPECT_TRUE(has_unsaved_edits(attempt.lab));
    attempt.run();
    ASSERT_TRUE(attempt.progress().passed);
    EXPECT_EQ(attempt.progress().starts, 10);
    EXPECT_GE(attempt.progress().best, 8);
    EXPECT_FALSE(has_unsaved_edits(attempt.lab));
    handle(attempt.lab, EditRequest{TurnDial{{.kind = 0}, Dial::LL, 3}});
    attempt.turn();
    EXPECT_TRUE(has_unsaved_edits(attempt.lab)) << "something else has changed";
    EXPECT_TRUE(lesson_view_of(attempt.lab).standing.passed_before);
    EXPECT_TRUE(attempt.progress().passed);
}

TEST(LabProgress, AddsTheProgressOfAFileToTheStudentOfItsName) {
    Attempt attempt;
    StudentBook& book = attempt.lab.students;
    book.all.push_back({"Anna", {{"01-drive", {.passed = true}}}});
    EXPECT_TRUE(take_progress(attempt.lab, {"", {{"02-values", {.best = 3}}}}));
    EXPECT_EQ(book.all[0].exercises.at("02-values").best, 3);
    EXPECT_TRUE(
        take_progress(attempt.lab, {"anna", {{"01-drive", {.best = 7, .starts = 10}}, {"06-love", {.passed = true}}}}));
    EXPECT_EQ(book.current, 1u) << "it goes on with her";
    EXPECT_TRUE(book.all[1].exercises.at("01-drive").passed) << "what was passed stays passed";
    EXPECT_EQ(book.all[1].exercises.at("01-drive").best, 7);
    EXPECT_TRUE(book.all[1].exercises.at("06-love").passed);
    EXPECT_TRUE(take_progress(attempt.lab, {"Ben", {}}));
    EXPECT_EQ(book.student().name, "Ben");
    while (book.all.size() < most_students) book.all.push_back({"student " + std::to_string(book.all.size()), {}});
    EXPECT_FALSE(take_progress(attempt.lab, {"Cleo", {}}));
}

TEST(LabProgress, UndoOfStartOverBringsThePassBack) {
    Attempt attempt;
    attempt.take_solution();
    attempt.run();
    ASSERT_TRUE(lesson_view_of(attempt.lab).grade);
    handle(attempt.lab, Action::exercise_reset);
    attempt.turn();
    EXPECT_FALSE(lesson_view_of(attempt.lab).grade);
    handle(attempt.lab, Action::undo);
    attempt.turn();
    ASSERT_TRUE(lesson_view_of(attempt.lab).grade);
    EXPECT_TRUE(lesson_view_of(attempt.lab).grade->good);
}

TEST(LabProgress, KeepsNothingOfAPageOfALecture) {
    Attempt attempt;
    auto lecture = std::make_shared<Lecture>();
    lecture->pages.emplace_back();
    attempt.lab.pages.emplace().lecture = lecture;
    handle(attempt.lab, PredictRequest{1});
    handle(attempt.lab, Action::hint);
    attempt.turn();
    EXPECT_TRUE(attempt.lab.students.student().exercises.empty());
}

TEST(LabProgress, GivesTheKeptBrainBack) {
    Attempt attempt;
    attempt.take_solution();
    attempt.run();
    handle(attempt.lab, Action::exercise_reset);
    attempt.turn();
    EXPECT_TRUE(lesson_view_of(attempt.lab).standing.has_kept);
    handle(attempt.lab, KeptRequest{});
    attempt.turn();
    EXPECT_EQ(*attempt.lab.document.session.snapshot().kind_brains[0], attempt.exercise().solution.submission.brain);
    EXPECT_FALSE(lesson_view_of(attempt.lab).standing.has_kept);
    handle(attempt.lab, Action::undo);
    EXPECT_EQ(*attempt.lab.document.session.snapshot().kind_brains[0], attempt.exercise().scene.kinds[0].brain);
}

TEST(LabProgress, TellsAPassedExerciseFromOneWhoseSolutionWasShown) {
    Attempt attempt;
    handle(attempt.lab, ShowMeRequest{});
    attempt.run();
    EXPECT_TRUE(attempt.progress().passed);
    EXPECT_TRUE(attempt.progress().shown);
    handle(attempt.lab, Action::exercise_reset);
    handle(attempt.lab, KeptRequest{});
    EXPECT_TRUE(lesson_view_of(attempt.lab).attempt.work.solution_shown) << "it is the shown one";
    handle(attempt.lab, Action::exercise_reset);
    handle(attempt.lab, Action::undo);  // brings the shown solution back
    attempt.run();
    EXPECT_TRUE(lesson_view_of(attempt.lab).attempt.work.solution_shown);
    EXPECT_TRUE(attempt.progress().shown);
    handle(attempt.lab, Action::exercise_reset);
    for (const auto& [dial, value] : {std::pair{Dial::LL, 0.0f}, {Dial::LR, 1.2f}, {Dial::RL, 1.2f}, {Dial::RR, 0.0f}})
        handle(attempt.lab, EditRequest{TurnDial{{.kind = 0}, dial, value}});
    attempt.run();
    EXPECT_TRUE(attempt.progress().passed);
    EXPECT_FALSE(attempt.progress().shown) << "passed with a brain of the student's own";
    handle(attempt.lab, ShowMeRequest{});
    attempt.turn();
    EXPECT_FALSE(attempt.progress().shown) << "it was passed before";
}

TEST(LabProgress, BelongsToTheChosenStudent) {
    Attempt attempt;
    handle(attempt.lab, NotesRequest{"without a name"});
    handle(attempt.lab, PredictRequest{1});
    attempt.turn();
    handle(attempt.lab, StudentRequest{StudentEdit::add, 0, " Anna "});
    attempt.turn();
    EXPECT_EQ(view_of(attempt.lab).documents.student, "Anna");
    EXPECT_EQ(lesson_view_of(attempt.lab).attempt.notes, "");
    EXPECT_EQ(lesson_view_of(attempt.lab).attempt.answers.prediction, -1);
    EXPECT_EQ(attempt.progress(), ExerciseProgress{});
    handle(attempt.lab, StudentRequest{StudentEdit::add, 0, "Anna"});
    EXPECT_EQ(attempt.lab.students.all.size(), 2u) << "the name is taken";
    handle(attempt.lab, StudentRequest{StudentEdit::choose, 0, {}});
    attempt.turn();
    EXPECT_EQ(lesson_view_of(attempt.lab).attempt.notes, "without a name");
    handle(attempt.lab, StudentRequest{StudentEdit::choose, 7, {}});
    EXPECT_EQ(attempt.lab.students.current, 0u);
}

TEST(LabProgress, GoesWithTheStudentWhoGivesHisNameLater) {
    Attempt attempt;
    handle(attempt.lab, PredictRequest{1});
    handle(attempt.lab, NotesRequest{"mine"});
    attempt.turn();
    handle(attempt.lab, StudentRequest{StudentEdit::rename, 0, "Ben"});
    attempt.turn();
    EXPECT_EQ(view_of(attempt.lab).documents.student, "Ben");
    EXPECT_EQ(attempt.progress().notes, "mine");
    EXPECT_EQ(lesson_view_of(attempt.lab).attempt.answers.prediction, 1) << "the attempt goes on";
    EXPECT_EQ(attempt.lab.students.all[0], StudentProgress{});
}

TEST(LabProgress, IsResetAndRestored) {
    Attempt attempt;
    attempt.take_solution();
    attempt.run();
    handle(attempt.lab, NotesRequest{"mine"});
    attempt.turn();
    const ExerciseProgress before = attempt.progress();
    handle(attempt.lab, StudentRequest{StudentEdit::reset, 0, {}});
    attempt.turn();
    attempt.turn();
    EXPECT_TRUE(attempt.lab.students.student().exercises.empty());
    handle(attempt.lab, StudentRequest{StudentEdit::restore, 0, {}});
    attempt.turn();
    EXPECT_EQ(attempt.progress(), before);
    EXPECT_EQ(lesson_view_of(attempt.lab).attempt.notes, "mine");
}

TEST(LabProgress, CutsLongNotesBetweenTwoCharacters) {
    Lab lab = opened_lab("05-aggressor");
    handle(lab, NotesRequest{std::string(longest_notes - 1, 'n') + "ü"});
    EXPECT_EQ(lesson_view_of(lab).attempt.notes, std::string(longest_notes - 1, 'n'));
}

TEST(LabProgress, IsKeptForEachOwnFileOfAnExercise) {
    const Folder folder;
    const std::string text = text_of(*find_shipped("06-love"));
    Lab lab = opened_lab("06-love");
    const auto note = [&](const fs::path& file, const std::string& words) {
        if (!file.empty()) {
            put_text(file, text);
            replace_document(lab, std::move(*open_document(file, std::nullopt, {})));
        }
        follow_progress(lab);
        EXPECT_EQ(lesson_view_of(lab).attempt.notes, "") << file;
        handle(lab, NotesRequest{words});
        follow_progress(lab);
    };
    note({}, "shipped");
    note(folder / "a" / "06-love.toml", "mine");
    note(folder / "b" / "06-love.toml", "another");
    const StudentProgress& kept = lab.students.student();
    EXPECT_EQ(kept.exercises.size(), 3u);
    ASSERT_TRUE(find_progress(kept, "06-love"));
    EXPECT_EQ(find_progress(kept, "06-love")->notes, "shipped");
    ASSERT_TRUE(find_progress(kept, (folder / "a" / "06-love.toml").string()));
    EXPECT_EQ(find_progress(kept, (folder / "a" / "06-love.toml").string())->notes, "mine");
}

}  // namespace
}  // namespace braitenlab::tests::lab_progress_test
