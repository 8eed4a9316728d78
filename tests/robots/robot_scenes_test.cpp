// Scenes of robots at their own scale: they load, and they move as their figures say.
#include <cmath>

#include "core/world/world.h"
#include "tests/robots/exported.h"

namespace braitenlab::tests::robot_scenes_test {
namespace {

struct Figures {
    const char* file;
    const char* target;
    float top_speed, track;  // m/s, m
};
constexpr Figures robots_of_scenes[] = {{"tt2wd-ldr", "arduino", 0.60f, 0.130f}, {"thymio2", "thymio", 0.17f, 0.0936f}};

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
Path driven(const Figures& figures, float left, float right) {
    auto world = World::create(ideal(figures), 1);
    Snapshot now;
    world->capture(now);
    EXPECT_FALSE(world->apply(Steer{now.vehicles[0].id, left, right}));
    for (int tick = 0; tick < 120; ++tick) world->step();
    world->capture(now);
    const VehicleView before = now.vehicles[0];
    double length = 0, turn = 0;
    VehicleView last = before;
    for (int tick = 0; tick < 60; ++tick) {
        world->step();
        world->capture(now);
        const VehicleView& here = now.vehicles[0];
        length += std::hypot(here.x - last.x, here.y - last.y);
        turn += std::remainder(here.heading - last.heading, 2 * M_PI);
        last = here;
    }
    return {length, std::fabs(turn) > 1e-6 ? length / std::fabs(turn) : 0};
}

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
            EXPECT_EQ(robot.name, figures.file);
            EXPECT_TRUE(robots::export_brain({"", scene.kinds[0].brain, scene.kinds[0].sensors}, target.value, robot));
        }
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
