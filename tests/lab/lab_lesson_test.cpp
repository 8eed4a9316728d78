// An open exercise: steps, hints, and what Reset, Start over and Undo take back.
#include "app/course/lab_lesson.h"

#include <algorithm>
#include <cmath>

#include "app/lab_reset.h"
#include "tests/folder.h"
#include "tests/lab/lesson_in_lab.h"

namespace braitenlab::tests::lab_lesson_test {
namespace {

TEST(LabLesson, ChecksStepsLive) {
    Lab lab = aggressor();
    handle(lab, PredictRequest{1});
    EXPECT_EQ(lesson_view_of(lab).attempt.answers.prediction, 1);
    handle(lab, EditRequest{SetBrain{{.kind = 0}, lab.document.lesson->exercise->solution.submission.brain}});
    handle(lab, Action::play_pause);
    for (int i = 0; i < 60 * 20 && !referee_of(lab.document).passed(); ++i) tick(lab);
    for (const Verdict& verdict : lesson_view_of(lab).verdicts) EXPECT_TRUE(verdict.done);
}

TEST(LabLesson, OffersAHintAfterARunOrHalfAMinute) {
    Lab lab = aggressor();
    handle(lab, Action::hint);
    EXPECT_EQ(lesson_view_of(lab).attempt.answers.hints_shown, 1);
    handle(lab, Action::hint);
    EXPECT_EQ(lesson_view_of(lab).attempt.answers.hints_shown, 1);
    advance(lab, 31);
    handle(lab, Action::hint);
    EXPECT_EQ(lesson_view_of(lab).attempt.answers.hints_shown, 2);
    handle(lab, Action::reset);
    handle(lab, Action::play_pause);
    tick(lab);
    handle(lab, Action::hint);
    EXPECT_EQ(lesson_view_of(lab).attempt.answers.hints_shown, 3);
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
    EXPECT_FALSE(lesson_of(lab).attempt.answers.hint_ready) << "it is no way to the next hint";
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 2}});
    for (int i = 0; i < 100; ++i) tick(lab);
    handle(lab, Action::exercise_reset);
    EXPECT_EQ(lab.notice.key, "notice.started_over");
    EXPECT_EQ(lesson_of(lab).attempt.answers.prediction, 1);
    EXPECT_EQ(lesson_of(lab).attempt.answers.hints_shown, 1);
    EXPECT_FALSE(lesson_of(lab).attempt.work.has_run);
    handle(lab, Action::undo);
    EXPECT_EQ(read_dials(*lab.document.session.snapshot().kind_brains[0]).LR, 2);
    EXPECT_EQ(lesson_of(lab).attempt.answers.prediction, 1);
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
    EXPECT_TRUE(lesson_of(lab).attempt.work.has_run);
    handle(lab, Action::redo);
    EXPECT_EQ(lab.document.session.snapshot().tick, 0u);
    EXPECT_NE(lab.document.session.snapshot().sources[0].x, 1.5f);
    EXPECT_FALSE(lesson_of(lab).attempt.work.has_run);
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
    EXPECT_EQ(lesson_of(lab).attempt.answers.prediction, -1);
    EXPECT_EQ(lesson_of(lab).attempt.answers.hints_shown, 0);
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
        EXPECT_TRUE(referee_of(lab.document).by_hand()) << how;
        reset(lab);
        const Snapshot& now = lab.document.session.snapshot();
        ASSERT_EQ(now.vehicles.size(), 1u) << how;
        EXPECT_EQ(referee_of(lab.document).state().subjects, std::vector<VehicleId>{now.vehicles[0].id}) << how;
        EXPECT_EQ(lab.view.selection.vehicle, now.vehicles[0].id) << how;
        EXPECT_FALSE(referee_of(lab.document).by_hand()) << how;
        for (int i = 0; i < 60 * 20 && !referee_of(lab.document).passed(); ++i) tick(lab);
        EXPECT_TRUE(referee_of(lab.document).passed()) << how;
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
    const auto& verdicts = lesson_view_of(lab).verdicts;
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
        EXPECT_TRUE(lesson_view_of(lab).by_hand);
        handle(lab, Action::reset);
        EXPECT_FALSE(lesson_view_of(lab).by_hand);
    }
}

TEST(LabLesson, CountsAgainOnceAMoveBeforeTheStartIsUndone) {
    Lab lab = aggressor();
    handle(lab, EditRequest{MoveSource{0, 1, 1}});
    EXPECT_TRUE(lesson_view_of(lab).by_hand);
    handle(lab, Action::undo);
    EXPECT_FALSE(lesson_view_of(lab).by_hand);
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 2}});
    tick(lab);
    EXPECT_FALSE(lesson_view_of(lab).by_hand) << "the exercise requires a change of the brain";
}

TEST(LabLesson, CountsBeforeADisturbanceAfterGoingBack) {
    Lab lab = aggressor();
    for (int i = 0; i < 100; ++i) tick(lab);
    handle(lab, EditRequest{MoveVehicle{lab.view.selection.vehicle, 0, 0, 0}});
    for (int i = 0; i < 100; ++i) tick(lab);
    handle(lab, SeekRequest{104});
    EXPECT_TRUE(lesson_view_of(lab).by_hand);
    handle(lab, SeekRequest{50});
    EXPECT_FALSE(lesson_view_of(lab).by_hand);
    handle(lab, SeekRequest{199});
    EXPECT_TRUE(lesson_view_of(lab).by_hand);
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
    EXPECT_FALSE(lesson_of(lab).attempt.answers.hint_ready);
    tick(lab);
    EXPECT_TRUE(lesson_of(lab).attempt.answers.hint_ready) << "after a run";
    advance(lab, 100);
    replace_document(lab, std::move(opened().document));
    advance(lab, 1);
    EXPECT_FALSE(lesson_of(lab).attempt.answers.hint_ready) << "time before it was opened does not count";
    EXPECT_EQ(lesson_of(lab).hint_in, 29);
    advance(lab, 30);
    EXPECT_TRUE(lesson_of(lab).attempt.answers.hint_ready);
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
    EXPECT_TRUE(lesson_of(lab).attempt.work.free_play);
    handle(lab, FreePlayRequest{false});
    EXPECT_FALSE(lesson_of(lab).attempt.work.free_play);
}

}  // namespace
}  // namespace braitenlab::tests::lab_lesson_test
