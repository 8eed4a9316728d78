// The run before the reset, beside the present one.
#include "app/features/last_run.h"

#include <gtest/gtest.h>

#include "app/lab_requests.h"
#include "app/playback.h"
#include "core/brain/four_neurons.h"
#include "tests/lab/opened_lab.h"

namespace braitenlab::tests::last_run_test {
namespace {

struct LastRun : testing::Test {
    Lab lab = opened_lab("2a-coward");

    std::optional<GhostView> ghost() const { return view_of(lab).features.last_run; }
    void run(int ticks) {
        for (int i = 0; i < ticks; ++i) tick(lab);
    }
    Pose place() const {
        const VehicleView* vehicle = find_vehicle(lab.document.session.snapshot(), lab.view.selection.vehicle);
        return {vehicle->x, vehicle->y, vehicle->heading};
    }
};

TEST_F(LastRun, IsShownAfterAResetInTimeWithTheNewRun) {
    run(100);
    const Pose then = place();
    run(50);
    EXPECT_FALSE(ghost()) << "the first run";
    const Pose end = place();
    handle(lab, Action::reset);
    ASSERT_TRUE(ghost());
    EXPECT_EQ(ghost()->path->size(), 151u);
    EXPECT_EQ(ghost()->pose, place()) << "the same start";
    handle(lab, EditRequest{TurnDial{{.vehicle = lab.view.selection.vehicle}, Dial::LM, 0.9f}});
    run(100);
    EXPECT_EQ(ghost()->pose, then);
    EXPECT_NE(place(), then) << "the edit has changed the new run";
    run(50);
    EXPECT_EQ(ghost()->pose, end);
    run(1);
    EXPECT_FALSE(ghost()) << "the last run has ended";
}

TEST_F(LastRun, FollowsTimeTravelAndEditsInThePast) {
    run(100);
    handle(lab, SeekRequest{40});
    handle(lab, EditRequest{TurnDial{{.vehicle = lab.view.selection.vehicle}, Dial::LM, 0.9f}});
    run(30);
    const Pose then = place();
    handle(lab, Action::reset);
    ASSERT_TRUE(ghost());
    EXPECT_EQ(ghost()->path->size(), 71u) << "without the ticks that the edit has removed";
    run(70);
    EXPECT_EQ(ghost()->pose, then);
    handle(lab, SeekRequest{20});
    EXPECT_EQ(ghost()->count, 21u);
}

TEST_F(LastRun, StaysAfterAVeryShortRunAndCanBeSwitchedOff) {
    run(100);
    handle(lab, Action::reset);
    run(5);
    handle(lab, Action::reset);
    ASSERT_TRUE(ghost());
    EXPECT_EQ(ghost()->path->size(), 101u);
    handle(lab, Action::last_run);
    EXPECT_FALSE(ghost());
    handle(lab, Action::last_run);
    EXPECT_TRUE(ghost());
}

struct ReturnToTheLastRun : LastRun {
    Target target() const { return {.vehicle = lab.view.selection.vehicle}; }
    void turn(Dial dial, float value) { handle(lab, EditRequest{TurnDial{target(), dial, value}}); }
    float dial_value(Dial dial) const {
        const Snapshot& now = lab.document.session.snapshot();
        return at(read_dials(*brain_of(now, *find_vehicle(now, lab.view.selection.vehicle))), dial);
    }
};

TEST_F(ReturnToTheLastRun, BringsBackItsTickItsTimelineAndItsBrain) {
    EXPECT_FALSE(view_of(lab).features.has_left_run);
    handle(lab, Action::return_run);
    EXPECT_EQ(lab.notice.key, "unavailable.no_last_run");
    turn(Dial::LM, 0.2f);
    run(100);
    const Pose early = place();
    turn(Dial::RM, 0.6f);
    run(200);
    const Pose late = place();
    handle(lab, SeekRequest{250});
    const std::uint64_t hash = lab.document.session.hash();
    const Pose then = place();
    handle(lab, Action::reset);
    turn(Dial::LM, 0.9f);
    run(60);
    EXPECT_TRUE(view_of(lab).features.has_left_run);
    handle(lab, Action::return_run);
    EXPECT_EQ(lab.playback.mode, Mode::paused);
    EXPECT_EQ(lab.document.session.snapshot().tick, 250u);
    EXPECT_EQ(place(), then);
    EXPECT_EQ(lab.document.session.hash(), hash);
    EXPECT_FLOAT_EQ(dial_value(Dial::LM), 0.2f) << "the brain of that run";
    EXPECT_EQ(lab.document.session.latest(), 300u) << "the ticks after it are there";
    handle(lab, SeekRequest{300});
    EXPECT_EQ(place(), late);
    handle(lab, SeekRequest{100});
    EXPECT_EQ(place(), early);
    handle(lab, Action::undo);
    EXPECT_FLOAT_EQ(dial_value(Dial::LM), 0.9f) << "undo goes to the newer run";
    EXPECT_EQ(lab.document.session.snapshot().tick, 60u);
}

TEST_F(ReturnToTheLastRun, CanBeUndoneAndRedoneUntilSomethingElseIsDone) {
    run(100);
    handle(lab, Action::reset);
    run(40);
    const int depth = view_of(lab).undo_depth;
    handle(lab, Action::return_run);
    EXPECT_EQ(lab.document.session.snapshot().tick, 100u);
    EXPECT_EQ(view_of(lab).undo_depth, depth + 1);
    handle(lab, Action::undo);
    EXPECT_EQ(lab.document.session.snapshot().tick, 40u);
    handle(lab, Action::redo);
    EXPECT_EQ(lab.document.session.snapshot().tick, 100u);
    run(1);
    EXPECT_EQ(view_of(lab).undo_depth, depth);
    handle(lab, Action::undo);
    EXPECT_EQ(lab.document.session.snapshot().tick, 101u) << "the run has gone on";
    handle(lab, Action::return_run);
    EXPECT_EQ(lab.document.session.snapshot().tick, 40u) << "the action itself exchanges the runs again";
}

TEST_F(ReturnToTheLastRun, GoesOnAsItWouldHaveAndHasTheOtherRunAsItsGhost) {
    Lab other = opened_lab("2a-coward");
    for (int i = 0; i < 200; ++i) tick(other);
    run(120);
    handle(lab, Action::reset);
    turn(Dial::LM, 0.9f);
    run(150);
    const Pose of_new = place();
    handle(lab, Action::return_run);
    run(30);
    ASSERT_TRUE(ghost());
    EXPECT_EQ(ghost()->pose, of_new);
    run(50);
    EXPECT_EQ(lab.document.session.hash(), other.document.session.hash());
}

TEST_F(ReturnToTheLastRun, BringsBackTheTicksOfAnExercise) {
    lab = solved_exercise();
    handle(lab, PredictRequest{0});
    for (int i = 0; i < 1200 && !lesson_view_of(lab).verdicts.front().done; ++i) tick(lab);
    ASSERT_TRUE(lesson_view_of(lab).verdicts.front().done);
    handle(lab, Action::reset);
    EXPECT_FALSE(lesson_view_of(lab).verdicts.front().done);
    handle(lab, Action::return_run);
    EXPECT_TRUE(lesson_view_of(lab).verdicts.front().done);
}

TEST_F(LastRun, EndsWithTheDocument) {
    run(100);
    handle(lab, Action::reset);
    replace_document(lab, opened_lab("2b-aggressor").document);
    EXPECT_FALSE(ghost());
    EXPECT_FALSE(view_of(lab).features.has_left_run);
}

}  // namespace
}  // namespace braitenlab::tests::last_run_test
