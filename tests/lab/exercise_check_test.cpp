// Saving the open scene as an exercise, its check in the background, and following the file in an editor.
#include "app/course/exercise_check.h"

#include <gtest/gtest.h>

#include "app/course/lab_progress.h"
#include "app/files/disk.h"
#include "app/files/file_commands.h"
#include "app/lab_requests.h"
#include "core/lesson/author.h"
#include "core/lesson/submission.h"
#include "core/messages.h"
#include "core/scene/file_kind.h"
#include "opened_lab.h"
#include "tests/folder.h"
#include "tests/lab/other_program.h"

namespace braitenlab::tests::exercise_check_test {
namespace {

struct ExerciseCheckLab : testing::Test {
    Folder folder;
    FilesView files;
    StoredState state;
    UserFolders folders{.home = folder.path, .pictures = folder / "Pictures"};
    Lab lab = opened_lab("2a-coward");
    Jobs jobs{0};
    ExerciseDraft draft{.title = "Strike", .goal = "Touch the lamp."};
    fs::path file = folder / "strike.toml";

    ExerciseCheckLab() {
        state.folder = folder.path.string();
        draft.offers = {"LL", "LR", "RL", "RR"};
        draft.steps = {{"It touches the lamp", {goals::Touches{"", 0.6f}}}};
        for (const auto& [dial, weight] :
             {std::pair{Dial::LL, 0.0f}, {Dial::RR, 0.0f}, {Dial::LR, 1.5f}, {Dial::RL, 1.5f}})
            handle(lab, EditRequest{TurnDial{{.kind = 0}, dial, weight}});
    }
    void save(bool replace = false) {
        handle(lab, SaveExerciseRequest{"strike", std::make_shared<const ExerciseDraft>(draft), replace});
        execute_file_requests(lab, files, state, folders);
    }
    void check() {
        for (int i = 0; i < 20 && lab.check; ++i) {
            update_exercise_check(lab, jobs);
            jobs.finish();
        }
        EXPECT_FALSE(lab.check);
    }
    void write(const std::string& text) { other.rename_over(file, text); }
    OtherProgram other{lab, files};
};

TEST_F(ExerciseCheckLab, ASavedExerciseIsOpenedAndItsResultShown) {
    save();
    ASSERT_TRUE(lab.document.lesson) << (files.refused ? files.refused->text() : "");
    EXPECT_EQ(lab.document.path, file);
    EXPECT_EQ(files.done, 1);
    EXPECT_EQ(lab.notice.key, "author.checking");
    check();
    EXPECT_EQ(lab.notice.key, "author.sound");
    EXPECT_EQ(lab.notice.words, "0/10");
    EXPECT_EQ(lab.notice.more, "10/10");
    EXPECT_EQ(lab.notice.kind, NoticeKind::done);
    EXPECT_GE(lab.notice_until, lab.wall_seconds + 60) << "the author may look elsewhere";
}

TEST_F(ExerciseCheckLab, SaysThatAnExerciseIsNotReady) {
    draft.steps[0].check.goal = goals::Runs{1};
    save();
    check();
    EXPECT_EQ(lab.notice.key, "author.unsound");
    EXPECT_EQ(lab.notice.words, "10/10") << "it passes as shipped";
    EXPECT_EQ(lab.notice.kind, NoticeKind::failure);
}

TEST_F(ExerciseCheckLab, AfterAFailedCheckTheSceneComesBackWithTheBrainOfTheWindow) {
    const Scene scene = lab.document.session.edited_scene();
    draft.seconds = 1;
    save();
    check();
    ASSERT_EQ(lab.notice.key, "author.unsound");
    ASSERT_TRUE(view_of(lab).documents.has_draft);
    const std::uint64_t exercise_run = lab.document.run_id;
    handle(lab, Action::edit_again);
    EXPECT_FALSE(lab.document.lesson);
    EXPECT_EQ(lab.document.session.edited_scene(), scene) << "the exercise's brain was not edited";
    EXPECT_EQ(view_of(lab).documents.draft_run, lab.document.run_id);
    EXPECT_GT(lab.document.run_id, exercise_run);
    EXPECT_FALSE(view_of(lab).documents.has_draft);
    save();
    ASSERT_TRUE(lab.document.lesson) << "it replaces the file that it has written itself";
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 0.75f}});
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::RL, 0.75f}});
    const Submission tried = submission_of(*lab.document.lesson->exercise, lab.document.session.snapshot());
    handle(lab, Action::edit_again);
    draft.seconds = 20;
    save();
    ASSERT_TRUE(lab.document.lesson);
    EXPECT_TRUE(is_same_submission(with_solution(*lab.document.lesson->exercise), tried))
        << "what passed in the window is the solution";
}

TEST_F(ExerciseCheckLab, EditsOfTheFileByAnotherProgramAreReplacedOnlyAfterAQuestion) {
    save();
    handle(lab, Action::edit_again);
    const std::string edited = *read_text(file) + "\n[[hint]]\ntext = \"Watch the wheels.\"\n";
    other.rename_over(file, edited);
    save();
    ASSERT_TRUE(files.refused);
    EXPECT_EQ(files.refused->what, error_of(message_of("changed_outside")).what);
    EXPECT_FALSE(lab.document.lesson);
    EXPECT_EQ(*read_text(file), edited);
    save(true);
    EXPECT_TRUE(lab.document.lesson);
    EXPECT_EQ(read_text(file)->find("Watch the wheels."), std::string::npos);
}

TEST_F(ExerciseCheckLab, WithoutASavedExerciseThereIsNothingToEditAgain) {
    handle(lab, Action::edit_again);
    EXPECT_EQ(lab.document.name, "2a-coward");
    save();
    handle(lab, OpenRequest{(folder / "strike.toml").string()});
    execute_file_requests(lab, files, state, folders);
    ASSERT_TRUE(lab.document.lesson);
    EXPECT_FALSE(view_of(lab).documents.has_draft) << "it was opened anew";
}

TEST_F(ExerciseCheckLab, NamesAControlThatTheSolutionNeedsAndThatIsNotOffered) {
    draft.offers = {"LL", "LR", "RR"};
    save();
    check();
    EXPECT_EQ(lab.notice.key, "author.not_offered");
    EXPECT_EQ(lab.notice.words, "RL");
}

TEST_F(ExerciseCheckLab, ReplacesAFileOnlyIfTheAuthorAgrees) {
    put_text(file, "mine");
    save();
    ASSERT_TRUE(files.refused);
    EXPECT_NE(files.refused->what.find("there is a file of this name"), std::string::npos);
    EXPECT_EQ(text_of(file), "mine");
    save(true);
    EXPECT_TRUE(lab.document.lesson);
}

TEST_F(ExerciseCheckLab, KeepsTheSceneIfTheBrainIsTheShippedOne) {
    lab = opened_lab("2a-coward");
    save();
    ASSERT_TRUE(files.refused);
    EXPECT_FALSE(fs::exists(file));
    EXPECT_FALSE(lab.document.lesson);
}

TEST_F(ExerciseCheckLab, AnEditOfTheFileIsReadCheckedAndBeginsAtTheStart) {
    save();
    check();
    handle(lab, Action::play_pause);
    for (int i = 0; i < 30; ++i) tick(lab);
    write(with(text_of(file), "Touch the lamp.", "Strike it."));
    EXPECT_EQ(lab.document.lesson->exercise->goal, "Strike it.");
    EXPECT_EQ(lab.document.session.snapshot().tick, 0u);
    EXPECT_EQ(lab.playback.mode, Mode::paused);
    check();
    EXPECT_EQ(lab.notice.key, "author.sound");
}

TEST_F(ExerciseCheckLab, AMistakeKeepsTheExerciseAndIsShownUntilItIsMended) {
    save();
    check();
    const std::string good = text_of(file);
    write(with(good, "metres = 0.6", "meters = 0.6"));
    EXPECT_EQ(lab.document.lesson->exercise->steps.size(), 1u);
    ASSERT_TRUE(lab.notice.error);
    EXPECT_NE(lab.notice.error->text().find("strike.toml:"), std::string::npos);
    lab.wall_seconds += 100;
    lab.notice = {};
    follow_file(lab, files);
    EXPECT_TRUE(lab.notice.error) << "it stays while the file is wrong";
    write(good);
    EXPECT_FALSE(lab.notice.error);
    lab.wall_seconds += 100;
    follow_file(lab, files);
    EXPECT_FALSE(lab.notice.error);
}

TEST_F(ExerciseCheckLab, ADroppedExerciseIsOpened) {
    save();
    lab = opened_lab("3a-love");
    handle(lab, OpenRequest{file.string(), true});
    execute_file_requests(lab, files, state, folders);
    ASSERT_TRUE(lab.document.lesson);
    EXPECT_EQ(lab.document.lesson->exercise->title, "Strike");
}

TEST_F(ExerciseCheckLab, NamesAPredictionThatTheRunContradicts) {
    draft.prediction = {
        .question = "What happens?", .options = {"It flies", "It turns"}, .answer = 0, .outcome = "So."};
    draft.prediction.after = 1;
    draft.prediction.shows = {{.option = {}, .check = {goals::Drives{4}}}};
    save();
    ASSERT_TRUE(lab.document.lesson) << (files.refused ? files.refused->text() : "");
    check();
    EXPECT_EQ(lab.notice.key, "author.contradicted");
    EXPECT_EQ(lab.notice.kind, NoticeKind::failure);
}

TEST_F(ExerciseCheckLab, APredictionThatNothingTestsIsNotCalledSound) {
    draft.prediction = {
        .question = "What happens?", .options = {"It flies", "It turns"}, .answer = 0, .outcome = "So."};
    save();
    check();
    EXPECT_EQ(lab.notice.key, "author.sound_untested");
    EXPECT_EQ(lab.notice.kind, NoticeKind::notice);
    ASSERT_EQ(lab.findings.size(), 1u);
    EXPECT_NE(lab.findings[0].said.words.find("of the run with the shipped brain"), std::string::npos)
        << lab.findings[0].said.words;
}

TEST_F(ExerciseCheckLab, TheAuthorsOwnTrialIsNoAttemptOfAStudent) {
    lab.students.student().exercises[file.string()] = {.passed = true, .best = 10, .starts = 10};
    save();
    lab.document.lesson->attempt.notes = "My trial.";
    follow_progress(lab);
    EXPECT_FALSE(lab.document.lesson->standing.passed_before) << "it is another exercise now";
    EXPECT_FALSE(lab.students.student().exercises.contains(file.string()));
    handle(lab, OpenRequest{file.string()});
    execute_file_requests(lab, files, state, folders);
    lab.document.lesson->attempt.notes = "As a student.";
    follow_progress(lab);
    lab.document.lesson->attempt.notes = "Later.";
    follow_progress(lab);
    EXPECT_TRUE(lab.students.student().exercises.contains(file.string()));
}

TEST_F(ExerciseCheckLab, ListsWhatTheCheckInTheTerminalPrints) {
    save();
    check();
    EXPECT_EQ(lab.notice.key, "author.sound");
    EXPECT_TRUE(lab.findings.empty());
    const std::string good = text_of(file);
    // The lamp is outside the walls: no start passes, the vehicle still drives.
    const std::size_t lamp = good.find("[scene.source.");
    ASSERT_NE(lamp, good.npos);
    write(good.substr(0, lamp) + with(good.substr(lamp), "x = 3", "x = 30"));
    ASSERT_FALSE(lab.notice.error) << lab.notice.error->text();
    check();
    EXPECT_EQ(lab.notice.key, "author.unsound");
    int failed_starts = 0, lamps = 0;
    for (const Finding& each : lab.findings) {
        failed_starts += each.said.key == "findings.start_fails" && !each.measures.empty();
        lamps += each.said.error && each.said.error->what.find("outside the arena") != std::string::npos;
        if (each.said.error) {
            EXPECT_GT(each.said.error->line, 0);
        }
    }
    EXPECT_EQ(failed_starts, 10);
    EXPECT_EQ(lamps, 1);
    handle(lab, HideFindingsRequest{});
    EXPECT_TRUE(lab.findings.empty());
}

TEST_F(ExerciseCheckLab, ListsEveryErrorOfABrokenFileUntilItIsMended) {
    save();
    check();
    const std::string good = text_of(file);
    write(with(with(good, "metres = 0.6", "meters = 0.6"), "format = 1", "format = 1\nstarts = 1000"));
    ASSERT_EQ(lab.findings.size(), 2u);
    for (const Finding& each : lab.findings) {
        ASSERT_TRUE(each.said.error);
        EXPECT_EQ(each.said.error->file, file.string());
        EXPECT_GT(each.said.error->line, 0);
    }
    write(good);
    EXPECT_TRUE(lab.findings.empty());
}

TEST_F(ExerciseCheckLab, ADroppedExerciseShowsWhatIsDoubtfulAndNothingElse) {
    save();
    check();
    const std::string good = text_of(file);
    const auto drop = [&](const std::string& text) {
        put_text(file, text);
        lab = opened_lab("3a-love");
        handle(lab, OpenRequest{file.string(), true});
        execute_file_requests(lab, files, state, folders);
        check();
    };
    drop(good);
    EXPECT_EQ(lab.notice.key, "") << "a student opens it, too";
    EXPECT_TRUE(lab.findings.empty());
    drop(good + "\n[[wrong]]\nname = \"no wires\"\nLM = 0.1\nRM = 0.1\n");
    EXPECT_EQ(lab.notice.key, "");
    ASSERT_EQ(lab.findings.size(), 1u);
    EXPECT_NE(lab.findings[0].said.words.find("no 'text'"), std::string::npos) << lab.findings[0].said.words;
    drop(with(good, "goal = \"touches\"", "goal = \"tuches\""));
    EXPECT_FALSE(lab.document.lesson) << "the scene before stays";
    ASSERT_EQ(lab.findings.size(), 1u);
}

TEST_F(ExerciseCheckLab, NothingIsFoundInAnExerciseThatShips) {
    lab = opened_lab("3a-love");
    handle(lab, OpenRequest{find_shipped("05-aggressor")->string(), true});
    execute_file_requests(lab, files, state, folders);
    ASSERT_TRUE(lab.document.lesson);
    EXPECT_FALSE(lab.check);
    list_errors_for_author(lab, *find_shipped("05-aggressor"), "[[step]]\n");
    EXPECT_TRUE(lab.findings.empty());
}

TEST_F(ExerciseCheckLab, AnotherFileEndsTheCheckWithoutANotice) {
    save();
    ASSERT_TRUE(lab.check);
    update_exercise_check(lab, jobs);
    handle(lab, OpenRequest{find_shipped("05-aggressor")->string()});
    execute_file_requests(lab, files, state, folders);
    ASSERT_EQ(lab.document.lesson->exercise->id, "05-aggressor");
    lab.notice = {};
    check();
    EXPECT_EQ(lab.notice.key, "") << "the result is that of the exercise before";
}

}  // namespace
}  // namespace braitenlab::tests::exercise_check_test
