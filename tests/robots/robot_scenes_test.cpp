// Scenes of robots at their own scale: they load, and they move as their figures say.
#include <cmath>

#include "core/world/world.h"
#include "tests/robots/exported.h"

namespace braitenlab::tests::robot_scenes_test {
namespace {

struct Figures {
    const char* file;
    const char *target, *robot;  // of the export
    float top_speed, track;      // m/s, m
};
// The published figures; their sources are in the scenes.
constexpr Figures robots_of_scenes[] = {{"tt2wd-ldr", "arduino", "tt2wd-ldr", 0.60f, 0.130f},
                                        {"thymio2", "thymio", "thymio2", 0.17f, 0.0936f},
                                        {"e-puck2", "c", "any", 0.154f, 0.052f},
                                        {"romi", "c", "any", 0.55f, 0.141f}};

Scene scene_of(const Figures& figures) {
    auto scene = load_scene(fs::path(BRAITENLAB_SOURCE) / "exercises/robots" / (std::string(figures.file) + ".toml"));
    EXPECT_TRUE(scene) << scene.error().text();
    return *scene;
}

// The same robot without errors of its motors, steered by hand on an empty floor.
Scene ideal(const Figures& figures) {
    Scene scene = scene_of(figures);
    scene.arena.width = scene.arena.height = 20;
    scene.obstacles.clear();
    scene.kinds[0].driver = Driver::manual;
    scene.kinds[0].body.mismatch = scene.kinds[0].body.dead_band = 0;
    return scene;
}

struct Path {
    double speed = 0, radius = 0;  // m/s, m; of the last second
};
Path driven(const Scene& scene, float left, float right) {
    auto world = World::create(scene, 1);
    Snapshot now;
    world->capture(now);
    EXPECT_FALSE(world->apply(Steer{now.vehicles[0].id, left, right}));
    for (int tick = 0; tick < 120; ++tick) world->step();
    world->capture(now);
    const VehicleView before = now.vehicles[0];
    double length = 0, turn = 0;
    const double axle = now.scene->kinds[0].body.wheels[0].x;  // ahead of the middle of the chassis
    VehicleView last = before;
    for (int tick = 0; tick < 60; ++tick) {
        world->step();
        world->capture(now);
        const VehicleView& here = now.vehicles[0];
        length += std::hypot(here.x + axle * std::cos(here.heading) - last.x - axle * std::cos(last.heading),
                             here.y + axle * std::sin(here.heading) - last.y - axle * std::sin(last.heading));
        turn += std::remainder(here.heading - last.heading, 2 * M_PI);
        last = here;
    }
    return {length, std::fabs(turn) > 1e-6 ? length / std::fabs(turn) : 0};
}

Path driven(const Figures& figures, float left, float right) { return driven(ideal(figures), left, right); }

TEST(RobotScenes, ReachTheTopSpeedOfTheRobot) {
    for (const Figures& figures : robots_of_scenes)
        EXPECT_NEAR(driven(figures, 1, 1).speed, figures.top_speed, 0.05 * figures.top_speed) << figures.file;
}

TEST(RobotScenes, TurnWithTheRadiusOfTheTrack) {
    for (const Figures& figures : robots_of_scenes) {
        // A differential drive: radius = track/2 · (left + right)/(left − right).
        const double radius = figures.track / 2 * (0.4 + 0.2) / (0.4 - 0.2);
        EXPECT_NEAR(driven(figures, 0.4f, 0.2f).radius, radius, 0.05 * radius) << figures.file;
    }
}

TEST(RobotScenes, HaveABrainThatTheirRobotHolds) {
    for (const Figures& figures : robots_of_scenes) {
        const Scene scene = scene_of(figures);
        for (const auto& target : robots::target_table) {
            if (target.word != figures.target) continue;
            const robots::Robot& robot = *robots::find_robot(target.robot);
            EXPECT_EQ(robot.name, figures.robot);
            EXPECT_TRUE(robots::export_brain({"", scene.kinds[0].brain, scene.kinds[0].sensors}, target.value, robot));
        }
    }
}

// What the left sensor of a robot reads of a wall or a lamp at this distance (m) on its axis.
float reading_at(const Figures& figures, float distance) {
    Scene scene = ideal(figures);
    Kind& kind = scene.kinds[0];
    scene.arena.lux = 0;
    kind.sensors.resize(1);
    Sensor& sensor = kind.sensors[0];
    sensor.x = sensor.y = sensor.angle = 0, sensor.noise = sensor.latency = sensor.gain_spread = 0;
    const bool sees_walls = sensor.channel == Channel::obstacle;
    if (sees_walls) sensor.x = kind.body.length / 2;  // outside the hull
    for (Wire& wire : kind.brain.wires) wire.weight = 0;
    Start& start = scene.starts[0];
    start.x = start.y = start.heading = 0, start.facing.clear(), start.heading_spread = 0;
    const float from = sensor.x;
    const float candela = scene.sources.empty() ? 0 : scene.sources[0].candela;
    scene.sources.clear();
    if (sees_walls)
        scene.obstacles.push_back({.name = "wall", .x = from + distance + 0.5f, .length = 1, .width = 4});
    else
        scene.sources.push_back({.name = "lamp", .x = distance, .candela = candela});
    const auto world = World::create(scene, 1);
    EXPECT_TRUE(world) << world.error().text();
    Snapshot now;
    world->capture(now);
    return now.sensed[static_cast<std::size_t>(now.vehicles[0].first_sensed)];
}

TEST(RobotScenes, DriveTheThymioAboutAnAxleBehindItsMiddle) {
    const Body body = scene_of(robots_of_scenes[1]).kinds[0].body;
    for (const Wheel& wheel : body.wheels)
        if (wheel.motor != Motor::none) {
            EXPECT_FLOAT_EQ(body.length / 2 - wheel.x, 0.08f) << "the hull ahead of the axle, by Enki";
            EXPECT_FLOAT_EQ(body.length / 2 + wheel.x, 0.03f) << "and behind it";
        }
    // A turn on the spot: the axle stays, so its path is short beside that of the middle.
    EXPECT_LT(driven(robots_of_scenes[1], -0.3f, 0.3f).speed, 0.005);
}

TEST(RobotScenes, AreAsFastAsMeasuredAtTheVoltagesOfTheMotorsOfTheArduinoRobot) {
    // 0.41 m/s at 3 V, 0.63 m/s at 4.5 V, 0.85 m/s at 6 V (SunFounder).
    for (const auto& [voltage, speed] : {std::pair{3.0f, 0.41f}, {4.5f, 0.63f}, {6.0f, 0.85f}}) {
        Scene scene = ideal(robots_of_scenes[0]);
        scene.kinds[0].body.voltage = voltage;
        EXPECT_NEAR(driven(scene, 1, 1).speed, speed, 0.05 * speed) << voltage;
    }
}

TEST(RobotScenes, ReadWhatWebotsPublishesOfAnEPuck) {
    // The lookup table of the distance sensors of Webots' e-puck: raw values of 4095.
    constexpr std::pair<float, float> table[] = {{0.005f, 2133}, {0.01f, 1466}, {0.02f, 384}, {0.03f, 235},
                                                 {0.04f, 158},   {0.05f, 120},  {0.06f, 104}};
    for (const auto& [distance, raw] : table)
        EXPECT_NEAR(reading_at(robots_of_scenes[2], distance), raw / 4095, 0.01f) << distance;
    EXPECT_EQ(reading_at(robots_of_scenes[2], 0.075f), 0);
}

TEST(RobotScenes, ReadWhatEnkiPublishesOfAThymio) {
    for (const float cm : {2.0f, 4.0f, 8.0f, 12.0f, 14.5f}) {
        const float raw = cm > 14 ? 1000 : 4505 * 73 / (cm * cm - 0.06f * cm + 73);
        EXPECT_NEAR(reading_at(robots_of_scenes[1], cm / 100), std::min(1.0f, (raw - 1000) / 3308), 0.005f) << cm;
    }
}

TEST(RobotScenes, ReadAPhotoresistorsDividerOfExponentSevenTenths) {
    // E = 84 cd/d²; a GL5528 of 15 kΩ at 10 lx over 1.5 kΩ: 1/(1 + (R10/Rf)·(E/10 lx)^−0.7), half scale at 268 lx.
    for (const std::size_t robot : {0u, 3u})
        for (const float distance : {0.3f, 0.56f, 1.0f, 2.0f}) {
            const float lux = 84 / (distance * distance);
            EXPECT_NEAR(reading_at(robots_of_scenes[robot], distance), 1 / (1 + 10 * std::pow(lux / 10, -0.7f)), 0.01f)
                << robots_of_scenes[robot].file << " " << distance;
        }
}

TEST(RobotScenes, ComeToTheTorchAndKeepOffTheBoxes) {
    int near = 0, moving = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        auto torch = World::create(scene_of(robots_of_scenes[0]), seed),
             boxes = World::create(scene_of(robots_of_scenes[1]), seed);
        Snapshot now;
        for (int tick = 0; tick < 30 * 60; ++tick) torch->step(), boxes->step();
        torch->capture(now);
        const Source& lamp = now.scene->sources[0];
        near += std::hypot(now.vehicles[0].x - lamp.x, now.vehicles[0].y - lamp.y) < 0.8f;
        boxes->capture(now);
        moving += std::fabs(now.vehicles[0].speed) > 0.02f;
    }
    EXPECT_GE(near, 8);
    EXPECT_GE(moving, 8);
}

}  // namespace
}  // namespace braitenlab::tests::robot_scenes_test
