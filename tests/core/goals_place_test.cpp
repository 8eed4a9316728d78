#include <gtest/gtest.h>

#include "core/lesson/goals/others.h"
#include "core/lesson/goals/place.h"
#include "tests/core/goal_runs.h"

namespace braitenlab::tests::goals_place_test {
namespace {

TEST(PlaceGoals, AnEmptySourceIsTheNearestOne) {
    EXPECT_TRUE(is_done(goals::Touches{"", 1}, {{0, {9.5f, 0}}}));
    EXPECT_FALSE(is_done(goals::Touches{"lamp", 1}, {{0, {9.5f, 0}}}));
    EXPECT_FLOAT_EQ(value_of(goals::Touches{"", 1}, {{0, {7, 0}}}), 3);
}

TEST(PlaceGoals, AnAvoidedSourceMustNeverHaveBeenNear) {
    const Goal goal = goals::AllOf{{{goals::Runs{2}}, {goals::Avoids{"lamp", 2}}}};
    EXPECT_TRUE(is_done(goal, {{0, {5, 0}}, {1, {2.5f, 0}}, {2, {3, 0}}}));
    EXPECT_FALSE(is_done(goal, {{0, {5, 0}}, {1, {1.5f, 0}}, {2, {3, 0}}}));
    EXPECT_TRUE(is_lost(goal, {{0, {5, 0}}, {1, {1.5f, 0}}}));
    EXPECT_FALSE(is_lost(goal, {{0, {5, 0}}, {1, {2.5f, 0}}}));
    EXPECT_FLOAT_EQ(value_of(goals::Avoids{"lamp", 9}, {{0, {5, 0}}, {1, {3, 0}}, {2, {4, 0}}}), 3);
}

TEST(PlaceGoals, ADistanceIsKeptBetweenTwoValues) {
    const Exercise exercise = exercise_with({goals::KeepsDistance{"lamp", 2, 4}, "", 1});
    EXPECT_TRUE(verdict_on(exercise, {{0, {3, 0}}, {1, {0, 3.9f}}}).done);
    EXPECT_FALSE(verdict_on(exercise, {{0, {3, 0}}, {1, {0, 4.1f}}}).done);
    EXPECT_FALSE(verdict_on(exercise, {{0, {1.9f, 0}}, {1, {0, 3}}}).done);
    const Measure measure = verdict_on(exercise, {{0, {3, 0}}}).measures.front();
    EXPECT_EQ(measure.needed, 2);
    EXPECT_EQ(measure.needed_most, 4);
}

// In an arena of 16 m × 12 m whose opposite edges are joined; the fire is at (7.5, 0).
Exercise in_torus(Check check) {
    Exercise exercise = exercise_with(std::move(check));
    exercise.scene.arena = {.width = 16, .height = 12, .edge = Boundary::torus};
    exercise.scene.sources[1].x = 7.5f;
    return exercise;
}

TEST(PlaceGoals, ADistanceToASourceGoesAcrossTheSeamOfATorus) {
    const Moment beyond{0, {-7.5f, 0}};
    EXPECT_FLOAT_EQ(verdict_on(in_torus({goals::Touches{"fire", 2}}), {beyond}).measures.front().value, 1);
    EXPECT_TRUE(verdict_on(in_torus({goals::Touches{"", 2}}), {beyond}).done);
    EXPECT_TRUE(verdict_on(in_torus({goals::Visits{1.5f, 1}}), {beyond}).done);
    EXPECT_FALSE(is_done(goals::Visits{1.5f, 1}, {beyond})) << "where edges are not joined";
}

TEST(PlaceGoals, ADistanceToTheReferenceGoesAcrossTheSeamOfATorus) {
    const Exercise exercise = in_torus({goals::Matches{2, 0.1f}});
    const Snapshot now = snapshot_of(exercise, {0, {-7.5f, 0}});
    const std::vector<VehicleId> ids{0, 1};
    const ReferencePath path{{7.5f, 0, 0}};
    goals::Matches::State state;
    const auto reading = measure(std::get<goals::Matches>(exercise.steps[0].check.goal), state,
                                 {now, now.vehicles[0], {exercise.scene.starts, ids}, &path});
    ASSERT_TRUE(reading);
    EXPECT_FLOAT_EQ(reading->value, 1);
}

// On a circle about the lamp, every 30 degrees, from one angle to another.
std::vector<Moment> arc(float radius, int from, int to, double start = 0) {
    std::vector<Moment> run;
    for (int degrees = from; from < to ? degrees <= to : degrees >= to; degrees += from < to ? 30 : -30)
        run.push_back({start + 0.1 * static_cast<double>(run.size()),
                       maths::from_polar(radius, maths::radians(static_cast<float>(degrees)))});
    return run;
}

TEST(PlaceGoals, ARoundCountsInEitherDirectionAndOnlyInsideTheRing) {
    const Goal goal = goals::Circles{"lamp", 2, 4, 0.99f};
    EXPECT_TRUE(is_done(goal, arc(3, 0, 360)));
    EXPECT_TRUE(is_done(goal, arc(3, 360, 0)));
    EXPECT_FALSE(is_done(goal, arc(3, 0, 330)));
    EXPECT_FALSE(is_done(goal, arc(5, 0, 360)));
    EXPECT_NEAR(value_of(goal, arc(3, 0, 180)), 0.5f, 1e-4f);
    std::vector<Moment> interrupted = arc(3, 0, 330);
    interrupted.push_back({4, {5, 0}});
    for (const Moment& moment : arc(3, 0, 90, 5)) interrupted.push_back(moment);
    EXPECT_FALSE(is_done(goal, interrupted));
    EXPECT_NEAR(value_of(goal, interrupted), 0.25f, 1e-4f);
}

TEST(PlaceGoals, ADistanceIsSteadyWhenItVariesLittleForTheTime) {
    const Goal goal = goals::SteadyDistance{"lamp", 10, 2};
    EXPECT_TRUE(is_done(goal, {{0, {3, 0}}, {1, {2.8f, 0}}, {2, {3, 0}}}));
    EXPECT_FALSE(is_done(goal, {{0, {3, 0}}, {1, {2.6f, 0}}, {2, {3, 0}}}));
    EXPECT_TRUE(is_done(goal, {{0, {9, 0}}, {1, {3, 0}}, {2, {3, 0}}, {3, {3, 0}}})) << "after a first change";
}

TEST(PlaceGoals, ARoundAfterHoursIsCountedAsTheFirst) {
    const goals::Circles circles{"lamp", 2, 4, 1000};
    const Exercise exercise = exercise_with({circles});
    goals::Circles::State state{.inside = true, .turned = 950 * 2 * maths::pi_d};
    std::optional<goals::Reading> reading;
    for (int i = 0; i <= 12000; ++i) {
        const Snapshot now =
            snapshot_of(exercise, {.at = maths::from_polar(3, 2 * maths::pi * static_cast<float>(i) / 12000)});
        reading = measure(circles, state, {now, now.vehicles[0], {}, nullptr});
    }
    ASSERT_TRUE(reading);
    EXPECT_NEAR(reading->value, 951, 0.001f);
}

TEST(PlaceGoals, ASteadyDistanceAfterTwoDaysIsTimedAsOneAtTheStart) {
    std::vector<Moment> moments{{0, {3, 0}}};
    for (int i = 0; i <= 60; ++i) moments.push_back({200000 + i / 60.0, {5, 0}});
    EXPECT_EQ(value_of(goals::SteadyDistance{"lamp", 10, 2}, moments), 1);
}

TEST(PlaceGoals, VisitsCountDifferentSources) {
    const Goal goal = goals::Visits{1, 2};
    EXPECT_TRUE(is_done(goal, {{0, {0, 0}}, {1, {10, 0.5f}}}));
    EXPECT_FALSE(is_done(goal, {{0, {0, 0}}, {1, {5, 0}}, {2, {0, 0}}}));
    EXPECT_EQ(value_of(goal, {{0, {0, 0}}, {1, {5, 0}}}), 1);
}

Exercise with_zone(const Zone& zone) {
    Exercise exercise = exercise_with({goals::Enters{"bay"}});
    exercise.scene.zones = {zone};
    exercise.scene.zones[0].name = "bay";
    return exercise;
}

TEST(PlaceGoals, AZoneIsEnteredByTheVehiclesOrigin) {
    const auto distance = [](const Zone& zone, maths::vec2 at) {
        return verdict_on(with_zone(zone), {{0, at}}).measures.front().value;
    };
    const Zone box{.x = 5, .heading = maths::radians(90), .length = 4, .width = 2};
    EXPECT_NEAR(distance(box, {8, 0}), 2, 1e-5f);
    EXPECT_NEAR(distance(box, {5, 5}), 3, 1e-5f);
    EXPECT_EQ(distance(box, {5.9f, 1.9f}), 0);
    EXPECT_TRUE(verdict_on(with_zone(box), {{0, {5.9f, 1.9f}}}).done);
    EXPECT_FALSE(verdict_on(with_zone(box), {{0, {6.1f, 1.9f}}}).done);
    const Zone disc{.x = 5, .length = 4, .width = 4, .round = true};
    EXPECT_NEAR(distance(disc, {9, 0}), 2, 1e-5f);
    EXPECT_FALSE(verdict_on(with_zone(disc), {{0, {6.9f, 1.9f}}}).done) << "inside the rectangle around it";
    EXPECT_TRUE(verdict_on(with_zone(disc), {{0, {5, 1.9f}}}).done);
}

TEST(PlaceGoals, ADistanceToAZoneGoesAcrossTheSeamOfATorus) {
    Exercise exercise = with_zone({.x = 9, .length = 4, .width = 2});
    exercise.scene.arena.width = exercise.scene.arena.height = 20;
    const auto distance = [&](maths::vec2 at) { return verdict_on(exercise, {{0, at}}).measures.front().value; };
    EXPECT_NEAR(distance({-8, 0}), 15, 1e-4f);
    exercise.scene.arena.edge = Boundary::torus;
    EXPECT_NEAR(distance({-8, 0}), 1, 1e-4f) << "the zone continues at the opposite edge to -9 m";
    EXPECT_NEAR(distance({5, 0}), 2, 1e-4f);
    EXPECT_TRUE(verdict_on(exercise, {{0, {-9.5f, 0.5f}}}).done);
}

TEST(PlaceGoals, AGateIsCrossedBetweenItsPosts) {
    Exercise exercise = exercise_with({goals::DrivesThrough{"a", "b"}});
    exercise.scene.obstacles = {{.name = "a", .x = 5, .y = 1}, {.name = "b", .x = 5, .y = -1}};
    EXPECT_TRUE(verdict_on(exercise, {{0, {4, 0}}, {1, {6, 0.5f}}, {2, {9, 0}}}).done);
    EXPECT_TRUE(verdict_on(exercise, {{0, {6, 0}}, {1, {4, 0}}}).done) << "in either direction";
    EXPECT_FALSE(verdict_on(exercise, {{0, {4, 2}}, {1, {6, 2}}}).done);
    EXPECT_FALSE(verdict_on(exercise, {{0, {4, 0}}, {1, {4.9f, 0}}}).done);
    EXPECT_FLOAT_EQ(verdict_on(exercise, {{0, {3, 0}}}).measures.front().value, 2);
}

TEST(PlaceGoals, AStepAcrossTheSeamOfATorusIsShort) {
    Exercise exercise = in_torus({goals::DrivesThrough{"a", "b"}});
    const auto crosses = [&](float gate, float from, float to) {
        exercise.scene.obstacles = {{.name = "a", .x = gate, .y = 1}, {.name = "b", .x = gate, .y = -1}};
        return verdict_on(exercise, {{0, {from, 0}}, {1, {to, 0}}}).done;
    };
    EXPECT_FALSE(crosses(0, -7.8f, 7.8f));
    EXPECT_TRUE(crosses(7.9f, 7.8f, -7.8f)) << "a gate before the seam";
    EXPECT_TRUE(crosses(-7.9f, 7.8f, -7.8f)) << "a gate behind the seam";
    EXPECT_TRUE(crosses(0, -0.5f, 0.5f));
}

TEST(PlaceGoals, AGateIsNotCrossedByAMoveToTheStart) {
    Exercise exercise = exercise_with({goals::DrivesThrough{"a", "b"}});
    exercise.scene.obstacles = {{.name = "a", .x = 5, .y = 1}, {.name = "b", .x = 5, .y = -1}};
    Referee referee(exercise);
    referee.watch(snapshot_of(exercise, {0, {4, 0}}));
    Snapshot next = snapshot_of(exercise, {1, {6, 0}});
    next.generation = 2;
    referee.watch(next);
    EXPECT_FALSE(referee.passed());
    next = snapshot_of(exercise, {2, {4, 0}});
    next.generation = 2;
    next.events.falls = 1;
    referee.watch(next);
    EXPECT_FALSE(referee.passed()) << "after a fall";
    next = snapshot_of(exercise, {3, {6, 0}});
    next.generation = 2, next.events.falls = 1;
    referee.watch(next);
    EXPECT_TRUE(referee.passed());
}

TEST(PlaceGoals, ALapCountsOnlyNearTheTape) {
    Exercise exercise = exercise_with({goals::FollowsLine{0.3f, 0.9f}});
    for (int i = 0; i < 12; ++i) {  // a circle of radius 3 in twelve pieces
        const float angle = maths::radians(30 * static_cast<float>(i));
        const maths::vec2 at = maths::from_polar(3, angle);
        exercise.scene.zones.push_back({.x = at.x,
                                        .y = at.y,
                                        .heading = angle + maths::pi / 2,
                                        .length = 1.6f,
                                        .width = 0.2f,
                                        .surface = Surface::tape});
    }
    EXPECT_TRUE(verdict_on(exercise, arc(3.1f, 0, 360)).done);
    EXPECT_FALSE(verdict_on(exercise, arc(4, 0, 360)).done);
    std::vector<Moment> half = arc(3, 0, 180);
    for (const Moment& moment : arc(4, 180, 360, 3)) half.push_back(moment);
    EXPECT_NEAR(verdict_on(exercise, half).measures.front().value, 0.5f, 0.01f);
}

}  // namespace
}  // namespace braitenlab::tests::goals_place_test
