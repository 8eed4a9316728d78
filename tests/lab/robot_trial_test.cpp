// The trial with real robots in the lab: computed in the background, begun anew after an edit, replayed beside the run.
#include "app/features/robot_trial.h"

#include <gtest/gtest.h>

#include "app/lab_requests.h"
#include "app/playback.h"
#include "tests/lab/opened_lab.h"

namespace braitenlab::tests::robot_trial_test {
namespace {

struct LabRobots : testing::Test {
    Jobs jobs{0};
    Lab lab = opened_lab("2b-aggressor");

    void turn() { update_robots(lab.robots, lab, jobs), jobs.finish(), update_robots(lab.robots, lab, jobs); }
    void try_at(float reality) {
        if (!lab.view.reality) handle(lab, Action::reality);
        handle(lab, RobotsRequest{.reality = reality, .tries = true});
        turn();
    }
    std::optional<RobotsView> shown() const { return view_of(lab).features.robots; }
};

TEST_F(LabRobots, RunOnlyWhenTheyAreAskedFor) {
    turn();
    EXPECT_FALSE(shown());
    handle(lab, Action::reality);
    turn();
    ASSERT_TRUE(shown());
    EXPECT_TRUE(shown()->is_typical);
    EXPECT_FLOAT_EQ(shown()->figures.mismatch, insight::typical_robot.mismatch);
    EXPECT_FALSE(shown()->report);
    try_at(1);
    ASSERT_TRUE(shown()->report);
    EXPECT_EQ(shown()->report->robots.size(), 40u);
    handle(lab, Action::reality);
    turn();
    EXPECT_FALSE(shown());
    EXPECT_FALSE(is_computing(lab.robots));
}

TEST_F(LabRobots, AreAllAlikeWithoutReality) {
    try_at(0);
    EXPECT_EQ(shown()->report->working, 40);
    EXPECT_EQ(shown()->report->robots[3].outcome.closest, shown()->report->ideal.outcome.closest);
    try_at(2);
    EXPECT_NE(shown()->report->robots[3].outcome.closest, shown()->report->robots[4].outcome.closest);
    EXPECT_FLOAT_EQ(shown()->figures.mismatch, 2 * insight::typical_robot.mismatch);
}

TEST_F(LabRobots, AreTriedAgainAfterAnEditOfTheBrain) {
    try_at(0);
    EXPECT_EQ(shown()->report->ideal.outcome.behaviour, insight::Behaviour::touches);
    for (const Dial dial : {Dial::LR, Dial::RL}) handle(lab, EditRequest{TurnDial{{no_vehicle, 0}, dial, 0}, 7});
    turn();
    EXPECT_NE(shown()->report->ideal.outcome.behaviour, insight::Behaviour::touches);
}

TEST_F(LabRobots, ReplayTheWeakestBesideTheRunWhichStaysAsItIs) {
    try_at(1);
    for (int i = 0; i < 30; ++i) tick(lab);
    const std::uint64_t before = lab.document.session.snapshot().tick;
    const int weakest = shown()->report->weakest;
    handle(lab, RobotsRequest{.replays = std::optional<int>(weakest)});
    ASSERT_TRUE(lab.together);
    EXPECT_EQ(shown()->replayed, weakest);
    for (int i = 0; i < 10 * static_cast<int>(insight::robot_path_ticks); ++i) tick(lab);
    const Pose& pose = shown()->report->robots[static_cast<std::size_t>(weakest)].path[10];
    EXPECT_FLOAT_EQ(view_of(lab).now->vehicles[0].x, pose.x);
    EXPECT_FLOAT_EQ(view_of(lab).now->vehicles[0].y, pose.y);
    handle(lab, RobotsRequest{.replays = std::optional<std::optional<int>>(std::in_place, std::nullopt)});
    EXPECT_FALSE(lab.together);
    EXPECT_EQ(lab.document.session.snapshot().tick, before);
}

TEST_F(LabRobots, ReplayAllInWorldsOfTheirOwn) {
    try_at(1);
    handle(lab, RobotsRequest{.replays = std::optional<int>(every_robot)});
    ASSERT_TRUE(lab.together);
    EXPECT_EQ(view_of(lab).now->vehicles.size(), 40u);
}

TEST_F(LabRobots, AreNotShownBeforeThePredictionOfAnExercise) {
    lab = opened_lab("21-reality");
    handle(lab, Action::reality);
    EXPECT_FALSE(shown()) << "the prediction comes first";
    EXPECT_EQ(lab.notice.key, "unavailable.reality");
}

}  // namespace
}  // namespace braitenlab::tests::robot_trial_test
