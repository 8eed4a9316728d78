#include "core/lesson/referee.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/maths/angle.h"

namespace braitenlab::tests::referee_test {
namespace {

Exercise with(std::vector<Check> checks) {
    Exercise exercise;
    exercise.scene.sources.push_back({"other", Channel::light, 50, 50, 1});
    exercise.scene.sources.push_back({"lamp", Channel::light, 0, 0, 1});
    for (Check& check : checks) exercise.steps.push_back({"", std::move(check)});
    return exercise;
}

const Check touch{Goal::touches, "lamp", 0.5f, 0, 0, 0};
const Check turn{Goal::turns_to, "lamp", 0, 0, 20, 0};
const Check faster{Goal::speeds_up, "lamp", 0.5f, 0, 0, 1.5f};
const Check last{Goal::runs, "", 0, 2, 0, 0};

// A vehicle at (x, 0) at a moment.
Snapshot moment(std::uint64_t tick, float x, float degrees = 180, float speed = 1) {
    Snapshot snapshot;
    snapshot.tick = tick;
    snapshot.seconds = static_cast<double>(tick) / 60;
    VehicleView vehicle;
    vehicle.id = 4;
    vehicle.x = x;
    vehicle.heading = maths::wrap_angle(maths::radians(degrees));
    vehicle.speed = speed;
    snapshot.vehicles.push_back(vehicle);
    snapshot.sources = {{0, Channel::light, 50, 50, 1}, {1, Channel::light, 0, 0, 1}};
    snapshot.scene = std::make_shared<const Scene>(with({}).scene);
    return snapshot;
}

TEST(Referee, TicksATouchOnceAndForAll) {
    Referee referee(with({touch}));
    referee.watch(moment(0, 3));
    EXPECT_FALSE(referee.passed());
    EXPECT_FLOAT_EQ(referee.verdicts()[0].measured, 3);
    EXPECT_FLOAT_EQ(referee.verdicts()[0].needed, 0.5f);
    EXPECT_EQ(referee.verdicts()[0].unit, "m");
    referee.watch(moment(1, 0.4f));
    EXPECT_TRUE(referee.passed());
    referee.watch(moment(2, 3));
    EXPECT_TRUE(referee.passed());
    EXPECT_FLOAT_EQ(referee.verdicts()[0].measured, 0.4f);
}

TEST(Referee, KnowsASourceByItsNameWhateverElseIsRemoved) {
    Referee referee(with({touch}));
    referee.watch(moment(0, 3));
    Snapshot later = moment(1, 3);
    Scene scene = *later.scene;
    scene.sources.erase(scene.sources.begin());
    later.scene = std::make_shared<const Scene>(scene);
    later.sources = {{0, Channel::light, 2.8f, 0, 1}};
    referee.watch(later);
    EXPECT_TRUE(referee.passed());
    later.scene = std::make_shared<const Scene>();
    later.sources.clear();
    later.tick = 2;
    referee.watch(later);  // the lamp itself is gone: nothing to judge by, nothing to crash on
}

TEST(Referee, ShowsTheNearestDistanceSoFar) {
    Referee referee(with({touch}));
    referee.watch(moment(0, 3));
    referee.watch(moment(1, 1));
    referee.watch(moment(2, 2));
    EXPECT_FLOAT_EQ(referee.verdicts()[0].measured, 1);
}

TEST(Referee, CallsItATurnOnlyWhenTheSourceWasOutsideBefore) {
    Referee referee(with({turn}));
    referee.watch(moment(0, 3, 180));  // already looks at it
    EXPECT_FALSE(referee.passed());
    referee.watch(moment(1, 3, 150));
    EXPECT_FALSE(referee.passed());
    referee.watch(moment(2, 3, -165));  // across the cut of the angles
    EXPECT_TRUE(referee.passed());
    EXPECT_NEAR(referee.verdicts()[0].needed, 20, 1e-4);
}

TEST(Referee, ComparesTheSpeedOfTheFirstTouchWithThatAfterOneSecond) {
    for (const float speed : {1.4f, 1.6f}) {
        Referee referee(with({faster}));
        referee.watch(moment(0, 3, 180, 0));
        referee.watch(moment(60, 3, 180, 1));
        referee.watch(moment(61, 2, 180, 3));  // fast, but not there
        EXPECT_FALSE(referee.passed());
        EXPECT_FLOAT_EQ(referee.verdicts()[0].measured, 3);
        referee.watch(moment(62, 0.5f, 180, speed));
        EXPECT_EQ(referee.passed(), speed > 1.5f);
        referee.watch(moment(63, 0.4f, 180, 3));  // too late
        EXPECT_EQ(referee.passed(), speed > 1.5f);
        EXPECT_FLOAT_EQ(referee.verdicts()[0].measured, speed);
    }
}

TEST(Referee, DoesNotLetAStandingStartCountAsAnySpeedUp) {
    Referee referee(with({faster}));
    referee.watch(moment(0, 3, 180, 0));
    referee.watch(moment(60, 3, 180, 0));
    referee.watch(moment(61, 0.4f, 180, 0.06f));
    EXPECT_FALSE(referee.passed());
}

TEST(Referee, CountsTheSecondsOfARun) {
    Referee referee(with({last}));
    referee.watch(moment(0, 3));
    referee.watch(moment(119, 3));
    EXPECT_FALSE(referee.passed());
    referee.watch(moment(120, 3));
    EXPECT_TRUE(referee.passed());
}

TEST(Referee, NeedsEveryStep) {
    Referee referee(with({touch, last}));
    referee.watch(moment(0, 0.1f));
    EXPECT_TRUE(referee.verdicts()[0].done);
    EXPECT_FALSE(referee.passed());
}

TEST(Referee, BeginsAnewWhenTheRunDoesAndNotWhenAMomentIsShownTwice) {
    Referee referee(with({touch}));
    referee.watch(moment(0, 3));
    referee.watch(moment(1, 0.1f));
    referee.watch(moment(2, 3));
    referee.watch(moment(2, 3));
    EXPECT_TRUE(referee.passed());
    referee.watch(moment(0, 3));
    EXPECT_FALSE(referee.passed());
    EXPECT_FLOAT_EQ(referee.verdicts()[0].measured, 3);
    referee.watch(moment(50, 0.1f));
    referee.watch(moment(20, 3));  // stepped back
    EXPECT_FALSE(referee.passed());
}

TEST(Referee, FollowsTheVehicleThatWasFirstAndNoOther) {
    Referee referee(with({touch}));
    referee.watch(moment(0, 3));
    Snapshot other = moment(1, 0.1f);
    other.vehicles[0].id = 9;  // the first one is gone
    referee.watch(other);
    EXPECT_FALSE(referee.passed());
}

TEST(Referee, CountsNothingInARunThatAHandDisturbedButWhatWasDoneBefore) {
    Referee referee(with({turn, touch}));
    referee.watch(moment(0, 3, 90));
    referee.watch(moment(1, 3, 180));
    referee.disturb();
    EXPECT_TRUE(referee.by_hand());
    referee.watch(moment(2, 0.1f));
    EXPECT_TRUE(referee.verdicts()[0].done);
    EXPECT_FALSE(referee.verdicts()[1].done);
    referee.watch(moment(0, 3));
    EXPECT_FALSE(referee.by_hand()) << "the next run is another";
    referee.watch(moment(1, 0.1f));
    EXPECT_TRUE(referee.verdicts()[1].done);
}

TEST(Referee, CountsNothingWhereALampStandsElsewhereOrThereIsOneTooMany) {
    for (const bool added : {false, true}) {
        Referee referee(with({touch}));
        Snapshot snapshot = moment(0, 0.1f);
        Scene scene = *snapshot.scene;
        added ? scene.sources.push_back({"bait", Channel::light, 1, 1, 1}) : void(scene.sources[1].x += 1);
        snapshot.scene = std::make_shared<const Scene>(scene);
        referee.watch(snapshot);
        EXPECT_TRUE(referee.by_hand());
        EXPECT_FALSE(referee.passed());
        referee.watch(moment(0, 0.1f));  // put back
        EXPECT_FALSE(referee.by_hand());
        EXPECT_TRUE(referee.passed());
    }
}

TEST(Referee, CountsNothingFromAnotherStartOrWithAPersonAtTheWheel) {
    Exercise exercise = with({touch});
    exercise.scene.kinds.push_back({.name = "vehicle"});
    exercise.scene.starts.push_back({.name = "one", .kind = "vehicle", .x = 3});
    const auto given = [&](const Scene& scene, Driver driver) {
        Referee referee(exercise);
        Snapshot snapshot = moment(0, 0.1f);
        snapshot.scene = std::make_shared<const Scene>(scene);
        snapshot.vehicles[0].driver = driver;
        referee.watch(snapshot);
        EXPECT_EQ(referee.by_hand(), !referee.passed());
        return referee.passed();
    };
    EXPECT_TRUE(given(exercise.scene, Driver::brain));
    EXPECT_FALSE(given(exercise.scene, Driver::manual));
    Scene nearer = exercise.scene;
    nearer.starts[0].x = 1;
    EXPECT_FALSE(given(nearer, Driver::brain));
}

TEST(Grade, IsTheSameEveryTimeAndCountsWhatItSays) {
    const auto exercise =
        load_exercise(std::filesystem::path(BRAITENLAB_SOURCE) / "exercises/guided/05-aggressor.toml");
    ASSERT_TRUE(exercise) << exercise.error().text();
    const BrainGraph half = make_graph({.LR = 0.4f, .RL = 0.4f, .LM = 0.3f, .RM = 0.3f});
    const Grade one = grade(*exercise, half), two = grade(*exercise, half);
    EXPECT_EQ(one.passed, two.passed);
    EXPECT_EQ(one.passed.size(), 10u);
    EXPECT_EQ(one.good, one.count >= exercise->needed);
    EXPECT_EQ(grade(*exercise, BrainGraph{}).count, 0);
}

}  // namespace
}  // namespace braitenlab::tests::referee_test
