#include "core/insight/robustness.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/scene/scene_file.h"
#include "core/scene/schema.h"
#include "tests/core/scenes.h"

namespace braitenlab::tests::robustness_test {
namespace {

using namespace insight;
using braitenlab::limits::converter_bits;

// A vehicle that drives straight to a lamp 6 m ahead and steers by nothing.
Scene straight() {
    Scene scene = tests::alone({.LM = 0.6f, .RM = 0.6f});
    scene.sources.push_back({.name = "lamp", .x = 6});
    return scene;
}

// The same with crossed wires: its eyes correct what its motors do wrong.
Scene steered() {
    Scene scene = straight();
    scene.kinds[0] = tests::two_eyed(scene.kinds[0].name.c_str(), {.LR = 0.8f, .RL = 0.8f, .LM = 0.2f, .RM = 0.2f});
    return scene;
}

RobotsReport tried(RobotsQuestion question) {
    question.vehicle = 0;
    const auto robots = Robots::create(std::move(question));
    EXPECT_TRUE(robots) << robots.error().text();
    const RobotsQuestion& asked = (*robots)->question();
    const auto complete = [&](JudgedRun run, std::uint64_t seed) {
        while (!run.advance(asked.ticks)) {
        }
        return result_of(run, seed, asked.ticks);
    };
    std::vector<RobotResult> all;
    for (int i = 0; i < asked.robots; ++i) all.push_back(complete((*robots)->run(i), (*robots)->seed_of(i)));
    return report_of(complete((*robots)->ideal_run(), asked.seed), std::move(all), false);
}

TEST(Robustness, IdealRobotsAllDoTheSameFromTheSameStart) {
    Scene scene = straight();
    scene.starts[0].place_spread = 1, scene.starts[0].heading_spread = 1;
    scene.kinds[0].body.mismatch = 0.2f;
    const RobotsReport report = tried({.scene = scene, .seed = 5, .reality = 0, .robots = 6, .ticks = 200});
    for (const RobotResult& robot : report.robots) EXPECT_EQ(robot.path, report.robots[0].path) << robot.seed;
    EXPECT_EQ(report.ideal.path, report.robots[0].path);
    EXPECT_EQ(report.working, 6);
    EXPECT_EQ(report.share(), 1);
    Snapshot start;
    World::create(scene, 5)->capture(start);
    EXPECT_EQ(report.robots[3].path.front(),
              (Pose{start.vehicles[0].x, start.vehicles[0].y, start.vehicles[0].heading}))
        << "the start of seed 5, though the world of the robot has seed 8";
}

TEST(Robustness, RealRobotsDifferAndOpenLoopFailsWhereEyesCorrect) {
    const RobotsReport blind = tried({.scene = straight(), .robots = 20});
    EXPECT_NE(blind.robots[0].path, blind.robots[1].path);
    EXPECT_EQ(blind.ideal.outcome.behaviour, Behaviour::touches);
    EXPECT_LT(blind.working, 12) << "motors of ±10 % miss a lamp 6 m away";
    EXPECT_GT(blind.working, 0);
    EXPECT_EQ(tried({.scene = steered(), .robots = 20}).working, 20);
    EXPECT_GE(tried({.scene = straight(), .reality = 0.1f, .robots = 20}).working, blind.working + 5);
}

TEST(Robustness, TheWeakestRobotFailsFarthestFromTheIdeal) {
    const RobotsReport report = tried({.scene = straight(), .robots = 20});
    const RobotResult& weakest = report.robots[static_cast<std::size_t>(report.weakest)];
    EXPECT_FALSE(weakest.works);
    for (const RobotResult& robot : report.robots) {
        if (robot.works) continue;
        EXPECT_LE(robot.outcome.closest, weakest.outcome.closest);
    }
    RobotResult early, late, works;
    early.failed_step = 0, late.failed_step = 2, works.works = true;
    EXPECT_TRUE(is_weaker(early, late, works));
    EXPECT_FALSE(is_weaker(late, early, works));
    EXPECT_TRUE(is_weaker(late, works, works));
    EXPECT_FALSE(is_weaker(works, late, works));
    RobotResult near = works, far = works;
    near.outcome.closest = far.outcome.closest = NAN;
    near.path = {{0, 0, 0}, {1, 0.1f, 0}}, far.path = {{0, 0, 0}, {1, 0.5f, 0}}, works.path = {{0, 0, 0}, {1, 0, 0}};
    works.outcome.closest = NAN;
    EXPECT_TRUE(is_weaker(far, near, works)) << "without an object paths are compared";
    EXPECT_FALSE(is_weaker(near, far, works));
}

TEST(Robustness, ScalesTheFiguresOfAKindWithinTheirRanges) {
    Scene scene = straight();
    Kind& kind = scene.kinds[0];
    kind.body.mismatch = 0.3f, kind.body.dead_band = 0.1f;
    kind.sensors[0].noise = 0.02f, kind.sensors[1].latency = 0.6f;
    scene.starts[0].sensors = kind.sensors;
    EXPECT_EQ(with_reality(scene, 0, 1), scene) << "1 is as in the scene";
    EXPECT_EQ(reality_of(with_reality(scene, 0, 0).kinds[0]), Reality{});
    const Scene twice = with_reality(scene, 0, 2);
    EXPECT_EQ(reality_of(twice.kinds[0]), (Reality{.mismatch = 0.5f, .noise = 0.04f, .latency = 1, .dead_band = 0.2f}));
    EXPECT_EQ(twice.starts[0].sensors, twice.kinds[0].sensors) << "sensors of its own, too";
    EXPECT_FALSE(check_scene(twice));
}

TEST(Robustness, GivesAnIdealKindTheFiguresOfATypicalRobotButNoErrorsToBumpers) {
    Scene scene = straight();
    scene.kinds[0].sensors.push_back({.name = "front", .channel = Channel::touch});
    const Scene real = with_reality(scene, 0, 1);
    EXPECT_EQ(reality_of(real.kinds[0]), typical_robot);
    EXPECT_EQ(real.kinds[0].sensors.back(), scene.kinds[0].sensors.back());
    EXPECT_FALSE(check_scene(with_reality(scene, 0, 2)));
}

TEST(Robustness, ScalesTheSamplesAndTheStepsOfAConverter) {
    Scene scene = straight();
    for (Sensor& sensor : scene.kinds[0].sensors) sensor.interval = 0.1f, sensor.bits = 10;
    scene.kinds[0].sensors[1].bits = 8;
    EXPECT_EQ(reality_of(scene.kinds[0]), (Reality{.interval = 0.1f, .bits = 8})) << "the coarser converter";
    EXPECT_EQ(with_reality(scene, 0, 1), scene);
    const auto scaled = [&](float reality) { return with_reality(scene, 0, reality).kinds[0].sensors[0]; };
    EXPECT_EQ(scaled(2).bits, 9) << "steps twice as large";
    EXPECT_FLOAT_EQ(scaled(2).interval, 0.2f);
    EXPECT_EQ(scaled(0.25f).bits, 12);
    EXPECT_EQ(scaled(0.001f).bits, converter_bits);
    EXPECT_EQ(scaled(0).bits, 0);
    EXPECT_EQ(scaled(0).interval, 0);
}

TEST(Robustness, KeepsTheStartPosesOfARandomPopulation) {
    Scene scene = straight();
    scene.kinds[0].share = 1;
    scene.ecology.population = 4;
    scene.members.push_back({.name = "2", .driver = Driver::parked});
    const auto robots = Robots::create({.scene = scene, .seed = 3, .vehicle = 0});
    ASSERT_TRUE(robots);
    Snapshot wanted, found;
    World::create(scene, 3)->capture(wanted);
    World::create((*robots)->scene(), 77)->capture(found);
    ASSERT_EQ(found.vehicles.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(found.vehicles[i].x, wanted.vehicles[i].x) << i;
        EXPECT_EQ(found.vehicles[i].heading, wanted.vehicles[i].heading) << i;
        EXPECT_EQ(found.vehicles[i].driver, wanted.vehicles[i].driver) << i;
    }
}

TEST(Robustness, RefusesNumbersOutOfRangeAndAnUnknownVehicle) {
    const auto is_refused = [](RobotsQuestion question) { return !Robots::create(std::move(question)); };
    EXPECT_FALSE(is_refused({.scene = straight(), .vehicle = 0}));
    EXPECT_TRUE(is_refused({.scene = straight(), .vehicle = 9}));
    EXPECT_TRUE(is_refused({.scene = straight(), .vehicle = 0, .reality = 2.5f}));
    EXPECT_TRUE(is_refused({.scene = straight(), .vehicle = 0, .reality = NAN}));
    EXPECT_TRUE(is_refused({.scene = straight(), .vehicle = 0, .robots = 0}));
    EXPECT_TRUE(is_refused({.scene = Scene{}, .vehicle = 0}));
}

}  // namespace
}  // namespace braitenlab::tests::robustness_test
