// The shipped scenes with obstacles: a dead end for a vehicle that remembers, and obstacles that can be pushed.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/core/runs.h"

namespace braitenlab::tests::shipped_obstacles_test {
namespace {

constexpr std::uint64_t seeds = 20;
constexpr int minute = 60;  // s

// Runs of the obstacle course that reach the flower within 60 s, and the bumps of all runs.
struct Course {
    int reached = 0;
    std::int64_t bumps = 0;
};

Course run_course(const Scene& scene) {
    Course course;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        bool reached = false;
        std::int64_t bumps = 0;
        watch_run(scene, seed, minute, [&](const Snapshot& now) {
            const maths::vec2 flower{now.sources[0].x, now.sources[0].y};
            reached |= maths::distance(position(now.vehicles[0]), flower) < 1;
            bumps = now.events.contacts;
        });
        course.reached += reached;
        course.bumps += bumps;
    }
    return course;
}

TEST(ShippedScenes, MemoryLeadsOutOfADeadEndWithFewerBumps) {
    const Scene scene = shipped_scene("obstacle-course");
    Scene forgetful = scene;
    forgetful.kinds[0].memory.marks = 0;
    const Course with_memory = run_course(scene), without = run_course(forgetful);
    EXPECT_GE(with_memory.reached, 15) << "of 20";
    EXPECT_LE(without.reached, 10) << "of 20";
    EXPECT_LT(2 * with_memory.bumps, without.bumps);
}

TEST(ShippedScenes, AVehiclePushesObstaclesAwayFromTheStove) {
    const Scene scene = shipped_scene("pushing");
    ASSERT_TRUE(std::all_of(scene.obstacles.begin(), scene.obstacles.end(),
                            [](const Obstacle& obstacle) { return obstacle.mass > 0; }));
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        World world = make(scene, seed);
        const Snapshot first = look(world), last = after(world, minute);
        const maths::vec2 stove{first.sources[0].x, first.sources[0].y};
        const auto count = static_cast<float>(first.obstacles.size());
        float before = 0, now = 0;
        int moved = 0;
        for (std::size_t i = 0; i < first.obstacles.size(); ++i) {
            const maths::vec2 from{first.obstacles[i].x, first.obstacles[i].y},
                to{last.obstacles[i].x, last.obstacles[i].y};
            before += maths::distance(stove, from) / count, now += maths::distance(stove, to) / count;
            moved += maths::distance(from, to) > 0.3f;
            EXPECT_LT(std::max(std::fabs(to.x) - scene.arena.width / 2, std::fabs(to.y) - scene.arena.height / 2), 0);
        }
        EXPECT_GT(now, before + 0.5f) << seed;
        EXPECT_GE(moved, 6) << seed;
    }
}

}  // namespace
}  // namespace braitenlab::tests::shipped_obstacles_test
