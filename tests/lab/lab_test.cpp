// An open exercise: steps, hints, grading and reset.
#include <gtest/gtest.h>

#include "app/lab_lesson.h"
#include "app/lab_requests.h"
#include "tests/lab/opened_lab.h"

namespace braitenlab::tests::lab_test {
namespace {

TEST(LabLesson, ChecksStepsLive) {
    Lab lab = opened_lab("05-aggressor");
    handle(lab, PredictRequest{1});
    EXPECT_EQ(lab.document.lesson->view.prediction, 1);
    handle(lab, EditRequest{SetBrain{{.kind = 0}, make_graph(lab.document.lesson->exercise->solution)}});
    handle(lab, Action::play_pause);
    for (int i = 0; i < 60 * 20 && !lab.document.lesson->referee.passed(); ++i) tick(lab);
    for (const Verdict& verdict : lab.document.lesson->view.verdicts) EXPECT_TRUE(verdict.done);
}

TEST(LabLesson, TakesAPredictionBeforeTheFirstRunOnly) {
    Lab lab = opened_lab("05-aggressor");
    handle(lab, Action::step);
    handle(lab, PredictRequest{0});
    EXPECT_EQ(lab.document.lesson->view.prediction, -1);
}

TEST(LabLesson, OffersAHintAfterARunOrHalfAMinute) {
    Lab lab = opened_lab("05-aggressor");
    handle(lab, Action::hint);
    EXPECT_EQ(lab.document.lesson->view.hints_shown, 1);
    handle(lab, Action::hint);
    EXPECT_EQ(lab.document.lesson->view.hints_shown, 1);
    advance(lab, 31);
    handle(lab, Action::hint);
    EXPECT_EQ(lab.document.lesson->view.hints_shown, 2);
    handle(lab, Action::reset);
    handle(lab, Action::play_pause);
    tick(lab);
    handle(lab, Action::hint);
    EXPECT_EQ(lab.document.lesson->view.hints_shown, 3);
}

TEST(LabLesson, ResetRestoresTheStartAndTheShippedBrain) {
    Lab lab = opened_lab("05-aggressor");
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

bool any_done(const Lab& lab) {
    const auto& verdicts = lab.document.lesson->view.verdicts;
    return std::any_of(verdicts.begin(), verdicts.end(), [](const Verdict& v) { return v.done; });
}

TEST(LabLesson, DoesNotPassIfTheLampIsMovedToTheVehicle) {
    for (const int before : {0, 30}) {
        Lab lab = opened_lab("05-aggressor");
        for (int i = 0; i < before; ++i) tick(lab);
        for (int i = 0; i < 300; ++i) {
            const VehicleView& coward = lab.document.session.snapshot().vehicles[0];
            handle(lab, EditRequest{MoveSource{0, coward.x + 0.4f * std::cos(coward.heading),
                                               coward.y + 0.4f * std::sin(coward.heading)}});
            tick(lab);
        }
        EXPECT_FALSE(any_done(lab)) << before;
        EXPECT_TRUE(lab.document.lesson->view.by_hand);
        handle(lab, Action::reset);
        EXPECT_FALSE(lab.document.lesson->view.by_hand);
    }
}

TEST(LabLesson, CountsAgainOnceAMoveBeforeTheStartIsUndone) {
    Lab lab = opened_lab("05-aggressor");
    handle(lab, EditRequest{MoveSource{0, 1, 1}});
    EXPECT_TRUE(lab.document.lesson->view.by_hand);
    handle(lab, Action::undo);
    EXPECT_FALSE(lab.document.lesson->view.by_hand);
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 2}});
    tick(lab);
    EXPECT_FALSE(lab.document.lesson->view.by_hand) << "the exercise requires a change of the brain";
}

TEST(LabLesson, CountsBeforeADisturbanceAfterGoingBack) {
    Lab lab = opened_lab("05-aggressor");
    for (int i = 0; i < 100; ++i) tick(lab);
    handle(lab, EditRequest{MoveVehicle{lab.view.selection.vehicle, 0, 0, 0}});
    for (int i = 0; i < 100; ++i) tick(lab);
    handle(lab, SeekRequest{104});
    EXPECT_TRUE(lab.document.lesson->view.by_hand);
    handle(lab, SeekRequest{50});
    EXPECT_FALSE(lab.document.lesson->view.by_hand);
    handle(lab, SeekRequest{199});
    EXPECT_TRUE(lab.document.lesson->view.by_hand);
}

TEST(LabLesson, ResetRestoresTheShippedBrainOfASingleVehicle) {
    Lab lab = opened_lab("05-aggressor");
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
    Lab lab = opened_lab("05-aggressor");
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 2}});
    for (int i = 0; i < 100; ++i) tick(lab);
    handle(lab, Action::reset);
    EXPECT_EQ(lab.document.session.snapshot().tick, 0u);
    EXPECT_EQ(read_dials(*lab.document.session.snapshot().kind_brains[0]).LR, 2);
}

}  // namespace
}  // namespace braitenlab::tests::lab_test
