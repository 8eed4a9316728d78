// The run before the reset, beside the present one.
#include "app/insight/last_run.h"

#include <gtest/gtest.h>

#include "app/lab_requests.h"
#include "app/playback.h"
#include "tests/lab/opened_lab.h"

namespace braitenlab::tests::last_run_test {
namespace {

struct LastRun : testing::Test {
    Lab lab = opened_lab("2a-coward");

    std::optional<GhostView> ghost() const { return view_of(lab).last_run; }
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

TEST_F(LastRun, EndsWithTheDocument) {
    run(100);
    handle(lab, Action::reset);
    replace_document(lab, opened_lab("2b-aggressor").document);
    EXPECT_FALSE(ghost());
}

}  // namespace
}  // namespace braitenlab::tests::last_run_test
