#include <gtest/gtest.h>

#include "core/lesson/goals/direction.h"
#include "core/lesson/goals/motion.h"
#include "core/lesson/goals/others.h"
#include "tests/core/goal_runs.h"

namespace braitenlab::tests::goals_motion_test {
namespace {

TEST(DirectionGoals, FacingNeedsNoTurnAndTurningAwayDoes) {
    EXPECT_TRUE(is_done(goals::Faces{"lamp", 15}, {{0, {-3, 0}, 10}}));
    EXPECT_FALSE(is_done(goals::Faces{"lamp", 15}, {{0, {-3, 0}, 20}}));
    EXPECT_FALSE(is_done(goals::TurnsAway{"lamp", 90}, {{0, {-3, 0}, 100}}));
    EXPECT_TRUE(is_done(goals::TurnsAway{"lamp", 90}, {{0, {-3, 0}, 20}, {1, {-3, 0}, 100}}));
    EXPECT_FALSE(is_done(goals::TurnsAway{"lamp", 90}, {{0, {-3, 0}, 20}, {1, {-3, 0}, 80}}));
}

TEST(DirectionGoals, ADirectionGoesAcrossTheSeamOfATorus) {
    Exercise exercise = exercise_with({goals::Faces{"fire", 15}});
    exercise.scene.arena = {.width = 16, .height = 12, .edge = Boundary::torus};
    exercise.scene.sources[1].x = 7.5f;
    EXPECT_TRUE(verdict_on(exercise, {{0, {-7.5f, 0}, 180}}).done);
    EXPECT_FALSE(verdict_on(exercise, {{0, {-7.5f, 0}, 0}}).done);
}

TEST(MotionGoals, RestingAndDrivingAreMeasuredBySpeedInEitherDirection) {
    EXPECT_TRUE(is_done(goals::Rests{0.1f}, {{0, {}, 0, -0.05f}}));
    EXPECT_FALSE(is_done(goals::Rests{0.1f}, {{0, {}, 0, -0.2f}}));
    EXPECT_TRUE(is_done(goals::Drives{0.5f}, {{0, {}, 0, -0.6f}}));
    EXPECT_FALSE(is_done(goals::Drives{0.5f}, {{0, {}, 0, 0.4f}}));
    EXPECT_TRUE(is_done(goals::KeepsSpeed{0.5f, 1}, {{0, {}, 0, 0.7f}}));
    EXPECT_FALSE(is_done(goals::KeepsSpeed{0.5f, 1}, {{0, {}, 0, -0.7f}}));
    EXPECT_FALSE(is_done(goals::KeepsSpeed{0.5f, 1}, {{0, {}, 0, 1.1f}}));
}

TEST(MotionGoals, SurvivalLastsUntilTheFirstFallAndIsLostThen) {
    const Moment start{}, at_10{.seconds = 10}, fallen{.seconds = 7, .events = {.falls = 1}},
        later{.seconds = 10, .events = {.falls = 2}};
    EXPECT_FALSE(is_done(goals::Survives{10}, {start, {.seconds = 9}}));
    EXPECT_TRUE(is_done(goals::Survives{10}, {start, at_10}));
    EXPECT_FALSE(is_done(goals::Survives{10}, {start, fallen, later}));
    EXPECT_TRUE(is_lost(goals::Survives{10}, {start, fallen}));
    EXPECT_EQ(value_of(goals::Survives{10}, {start, fallen, later}), 7);
}

TEST(MotionGoals, OneRestThatIsTooLongIsNeverForgiven) {
    const Goal goal = goals::AllOf{{{goals::Runs{4}}, {goals::KeepsMoving{0.1f, 1}}}};
    const auto run = [](std::vector<float> speeds) {
        std::vector<Moment> moments;
        for (const float speed : speeds) moments.push_back({0.5 * static_cast<double>(moments.size()), {}, 0, speed});
        return moments;
    };
    EXPECT_TRUE(is_done(goal, run({1, 0, 0, 0, 1, 1, 1, 0, 0})));
    EXPECT_FALSE(is_done(goal, run({1, 0, 0, 0, 0, 1, 1, 1, 1})));
    EXPECT_TRUE(is_lost(goal, run({1, 0, 0, 0, 0, 1})));
    EXPECT_FLOAT_EQ(verdict_on(goal, run({1, 0, 0, 0, 1})).measures[1].value, 1);
}

TEST(MotionGoals, ARestAfterTwoDaysIsMeasuredAsOneAtTheStart) {
    std::vector<Moment> moments{{0, {}, 0, 1}};
    for (int i = 0; i <= 60; ++i) moments.push_back({200000 + i / 60.0, {}, 0, 0});
    const Goal never_done = goals::AllOf{{{goals::Captures{1}}, {goals::KeepsMoving{0.1f, 2}}}};
    EXPECT_EQ(verdict_on(never_done, moments).measures[1].value, 1);
}

TEST(MotionGoals, EachTickOfDaysCountsInACorrelation) {
    const Exercise exercise = exercise_with({goals::SpeedFollows{"S", 0.9f, 5}});
    constexpr double ticks = 1 << 24;
    goals::SpeedFollows::State state{ticks, 0, 0, ticks, ticks, 0};
    for (int i = 0; i < 100; ++i) {
        const Snapshot now = snapshot_of(exercise, {.seconds = 300000, .speed = 0.5f, .reading = 0.5f});
        (void)measure(goals::SpeedFollows{"S", 0.9f, 5}, state, {now, now.vehicles[0], {}, nullptr});
    }
    EXPECT_EQ(state.count, ticks + 100);
    EXPECT_NEAR(state.product_moment, 25, 0.01);
    EXPECT_NEAR(state.speed_moment, ticks + 25, 0.01);
}

TEST(MotionGoals, SpeedFollowsASignalThatItIsCorrelatedWith) {
    const auto run = [](float slope, float wobble) {
        std::vector<Moment> moments;
        for (int i = 0; i < 60; ++i) {
            const float reading = std::fabs(std::sin(static_cast<float>(i) * 0.3f));
            const float noise = wobble * std::sin(static_cast<float>(i) * 1.7f);
            moments.push_back({i / 10.0, {}, 0, slope * reading + noise, 1, reading});
        }
        return moments;
    };
    const Goal goal = goals::SpeedFollows{"S", 0.9f, 5};
    EXPECT_TRUE(is_done(goal, run(1, 0)));
    EXPECT_NEAR(value_of(goals::SpeedFollows{"S", 1, 100}, run(2, 0)), 1, 1e-4f);
    EXPECT_NEAR(value_of(goals::SpeedFollows{"S", 1, 100}, run(-1, 0)), -1, 1e-4f);
    EXPECT_FALSE(is_done(goal, run(1, 1)));
    EXPECT_FALSE(is_done(goal, run(0, 0))) << "a constant speed has no correlation";
    std::vector<Moment> brief = run(1, 0);
    brief.resize(49);
    EXPECT_FALSE(is_done(goal, brief)) << "before its time";
}

TEST(MotionGoals, ASpeedThatWasTooLowOnArrivalIsLost) {
    const Goal goal = goals::SpeedsUp{"lamp", 1, 1.5f};
    EXPECT_TRUE(is_lost(goal, {{0, {3, 0}}, {1, {3, 0}, 0, 1}, {2, {0.5f, 0}, 0, 1.2f}}));
    EXPECT_TRUE(is_done(goal, {{0, {3, 0}}, {1, {3, 0}, 0, 1}, {2, {0.5f, 0}, 0, 1.6f}}));
}

TEST(OthersGoals, AFollowedVehicleIsNearAndAhead) {
    const Goal goal = goals::Follows{"two", 3, 30};
    const auto run = [](float degrees, maths::vec2 other) {
        return std::vector<Moment>{{0, {0, 0}, degrees, 0, 1, 0, other}};
    };
    EXPECT_TRUE(is_done(goal, run(0, {2, 0.5f})));
    EXPECT_FALSE(is_done(goal, run(0, {4, 0})));
    EXPECT_FALSE(is_done(goal, run(90, {2, 0})));
}

TEST(OthersGoals, AFollowedVehicleHasADistanceAndAnAngle) {
    const auto measured = [](float degrees, maths::vec2 other) {
        return verdict_on(goals::Follows{"two", 3, 30}, {{0, {0, 0}, degrees, 0, 1, 0, other}}).measures;
    };
    const std::vector<Measure> far = measured(10, {4, 0});
    ASSERT_EQ(far.size(), 2u);
    EXPECT_FLOAT_EQ(far[0].value, 4);
    EXPECT_EQ(far[0].unit, "m");
    EXPECT_FALSE(far[0].met);
    EXPECT_NEAR(far[1].value, 10, 1e-3);
    EXPECT_EQ(far[1].needed, 30);
    EXPECT_EQ(far[1].unit, "°");
    EXPECT_TRUE(far[1].at_most);
    EXPECT_EQ(far[1].source, "two");
    EXPECT_TRUE(far[1].met) << "only the distance is missing";
    const std::vector<Measure> aside = measured(40, {2, 0});
    EXPECT_TRUE(aside[0].met);
    EXPECT_FALSE(aside[1].met) << "only the angle is missing";
    EXPECT_EQ(measures({goals::Follows{"two", 3, 30}}, initial_state({goals::Follows{"two", 3, 30}})).size(), 1u)
        << "nothing is measured yet";
}

TEST(OthersGoals, AVehicleIsFollowedAcrossTheSeamOfATorus) {
    Exercise exercise = exercise_with({goals::Follows{"two", 3, 30}});
    exercise.scene.arena.width = 12;
    const std::vector<Moment> run{{0, {5, 0}, 0, 0, 1, 0, {-5, 0.5f}}};
    EXPECT_FALSE(verdict_on(exercise, run).done) << "a wall lies between them";
    exercise.scene.arena.edge = Boundary::torus;
    EXPECT_TRUE(verdict_on(exercise, run).done);
}

TEST(OthersGoals, ContactsAndCapturesAreCounted) {
    const auto run = [](std::int64_t contacts, std::int64_t captures) {
        Moment moment;
        moment.events.contacts = contacts, moment.events.captures = captures;
        return std::vector<Moment>{moment};
    };
    EXPECT_TRUE(is_done(goals::Collides{1}, run(1, 0)));
    EXPECT_TRUE(is_lost(goals::Collides{1}, run(2, 0)));
    EXPECT_TRUE(is_done(goals::Captures{2}, run(0, 2)));
    EXPECT_FALSE(is_done(goals::Captures{2}, run(0, 1)));
    EXPECT_TRUE(is_done(goals::Population{"kind", 2}, run(0, 0)));
    EXPECT_FALSE(is_done(goals::Population{"kind", 3}, run(0, 0)));
}

TEST(OthersGoals, ARechargeGoesFromLowToHigh) {
    const auto run = [](const std::vector<float>& energies) {
        std::vector<Moment> moments;
        for (const float energy : energies) moments.push_back({static_cast<double>(moments.size()), {}, 0, 0, energy});
        return moments;
    };
    const Goal goal = goals::Recharges{0.3f, 0.8f, 2};
    EXPECT_TRUE(is_done(goal, run({1, 0.2f, 0.9f, 0.2f, 0.9f})));
    EXPECT_FALSE(is_done(goal, run({1, 0.9f, 0.2f, 0.9f, 0.4f, 0.9f})));
    EXPECT_EQ(value_of(goal, run({1, 0.2f, 0.5f, 0.9f})), 1);
}

// The solution's run is the reference: a vehicle that does the same has distance 0.
TEST(OthersGoals, AMatchIsMeasuredAgainstTheSolutionsRun) {
    Exercise exercise = exercise_with({goals::Matches{0.2f, 1}});
    exercise.scene.starts[0].x = -3;
    exercise.scene.starts[1].x = 5;
    exercise.solution.submission.brain = make_graph({.LM = 0.2f, .RM = 0.2f});
    exercise.solution.submission.sensors = exercise.scene.kinds[0].sensors;
    Reference reference(exercise, 0);
    const ReferencePath path = reference.until(60);
    ASSERT_GT(path.size(), 60u);
    EXPECT_GT(path[60].x, -2.9f);
    const auto run = [&](float aside) {
        std::vector<Moment> moments;
        for (std::size_t tick = 0; tick <= 60; ++tick)
            moments.push_back({static_cast<double>(tick) / 60, {path[tick].x, path[tick].y + aside}});
        return verdict_on(exercise, moments);
    };
    EXPECT_TRUE(run(0).done);
    EXPECT_TRUE(run(0.1f).done);
    EXPECT_FALSE(run(0.3f).done);
    EXPECT_NEAR(run(0.3f).measures.front().value, 0.3f, 1e-4f);
}

}  // namespace
}  // namespace braitenlab::tests::goals_motion_test
