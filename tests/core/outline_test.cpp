#include "core/sensing/outline.h"

#include <gtest/gtest.h>

#include "core/maths/angle.h"
#include "tests/core/chance.h"

namespace braitenlab::tests::outline_test {
namespace {

using namespace sensing;
using maths::vec2;
using tests::Chance;

Outline random_box(Chance& chance) {
    const float l = chance.number(0.2f, 4), w = chance.number(0.2f, 4);
    return outline_of({{-l, -w}, {l, -w}, {l, w}, {-l, w}}, chance.motion());
}

// Calls visit(point) for many points along the sides.
template <class Visit>
void walk(const Outline& outline, Visit visit) {
    constexpr int steps = 2000;
    for (std::size_t i = 0; i < side_count(outline); ++i)
        for (int k = 0; k <= steps; ++k) {
            const Segment s = side(outline, i);
            visit(s.a + (s.b - s.a) * (static_cast<float>(k) / steps));
        }
}

TEST(Outline, AnOutlineIsSensedAtItsNearestPointInTheField) {
    Chance chance(5);
    int felt = 0;
    for (int i = 0; i < 400; ++i) {
        Sensor sensor = chance.sensor();
        sensor.response = SensorResponse::graded;
        const CompiledSensor compiled(sensor);
        const Pose pose = chance.pose();
        const SensorPose placed = sensor_pose(compiled, {pose.x, pose.y}, maths::direction(pose.heading));
        const Outline outline = random_box(chance);
        float nearest = 1e9f, expected = 0;
        walk(outline, [&](vec2 p) {
            if (const float d = maths::distance(p, placed.position); d < nearest && in_field(compiled, placed, p))
                nearest = d, expected = response_to(compiled, placed, p, 1);
        });
        if (nearest < 0.2f) continue;  // at short distances the direction changes fast along the side
        ASSERT_NEAR(response_to_outline(compiled, placed, outline), expected, 0.02f) << i;
        felt += expected > 0.02f;
    }
    EXPECT_GT(felt, 100);
}

TEST(Outline, AnOutlineHidesObjectsBehindIt) {
    Chance chance(6);
    int hidden = 0;
    for (int i = 0; i < 400; ++i) {
        const float half = chance.number(0.3f, 2);
        const Outline box =
            outline_of({{-half, -half}, {half, -half}, {half, half}, {-half, half}}, mechanics::at_rest({}, 0));
        const vec2 a = chance.place(5), b = chance.place(5);
        const auto depth = [&](vec2 p) { return std::max(std::fabs(p.x), std::fabs(p.y)) - half; };  // below 0: inside
        float deepest = 1e9f;
        for (int k = 0; k <= 4000; ++k)
            deepest = std::min(deepest, depth(a + (b - a) * (static_cast<float>(k) / 4000)));
        if (std::fabs(deepest) < 0.01f || depth(a) < 0 || depth(b) < 0) continue;
        ASSERT_EQ(crosses(box, a, b), deepest < 0) << i;
        hidden += deepest < 0;
    }
    EXPECT_GT(hidden, 50);
}

Scene with_obstacle(const Obstacle& obstacle) {
    Scene scene;
    scene.arena.edge = Boundary::open;
    scene.obstacles.push_back(obstacle);
    return scene;
}

Outlines outlines_of(const Scene& scene) {
    std::vector<mechanics::Motion> motions;
    for (const Obstacle& o : scene.obstacles) motions.push_back(mechanics::at_rest({o.x, o.y}, o.heading));
    return {scene, motions};
}

TEST(Outline, OutlinesAreHiddenByObstaclesButNotByPosts) {
    Scene scene = with_obstacle({.name = "box", .x = 2});
    scene.sources.push_back({.name = "post", .x = -2, .solid = true});
    const Outlines outlines = outlines_of(scene);
    EXPECT_TRUE(outlines.block({0, 0}, {4, 0}));
    EXPECT_TRUE(outlines.block({4, 0}, {0, 0}));
    EXPECT_FALSE(outlines.block({0, 0}, {1, 0}));
    EXPECT_FALSE(outlines.block({0, 0}, {4, 3}));
    EXPECT_FALSE(outlines.block({0, 0}, {-4, 0}));
    EXPECT_TRUE(outlines.any_obstacle_near({0, 0}, 1.6f));
    EXPECT_FALSE(outlines.any_obstacle_near({0, 0}, 1.0f));
}

TEST(Outline, OutlinesSenseObstaclesAndPostsAcrossASeamOnceEach) {
    Scene scene = with_obstacle({.name = "box", .x = 9, .y = 0});
    scene.arena.edge = Boundary::torus;
    const CompiledSensor compiled({.shape = SensorShape::omni, .x = 0, .range = 4});
    const Outlines outlines = outlines_of(scene);
    const float near =
        outlines.total(compiled, sensor_pose(compiled, {-9.5f, 0}, {1, 0}));  // its side at 9.5 is 1 m away
    EXPECT_NEAR(near, response_to(compiled, sensor_pose(compiled, {0, 0}, {1, 0}), {1, 0}, 1), 1e-5f);
    EXPECT_TRUE(outlines.block({-9.5f, 0}, {-13, 0}));
    scene.obstacles.clear();
    EXPECT_EQ(outlines_of(scene).total(compiled, sensor_pose(compiled, {-9.5f, 0}, {1, 0})), 0);
    scene.sources.push_back({.name = "post", .x = 9, .solid = true});
    EXPECT_GT(outlines_of(scene).total(compiled, sensor_pose(compiled, {-9.5f, 0}, {1, 0})), 0.5f);
}

TEST(Outline, OutlinesOutOfRangeAddNothing) {
    Chance chance(8);
    int felt = 0, beyond = 0;
    for (int i = 0; i < 3000; ++i) {
        Scene scene;
        scene.arena.width = chance.number(4, 40), scene.arena.height = chance.number(4, 40);
        scene.obstacles.resize(3);
        std::vector<mechanics::Motion> at;
        std::vector<Outline> all;
        const float w = scene.arena.width / 2, h = scene.arena.height / 2;
        for (const Segment& wall :
             {Segment{{-w, -h}, {w, -h}}, {{w, -h}, {w, h}}, {{w, h}, {-w, h}}, {{-w, h}, {-w, -h}}})
            all.push_back({{wall.a, wall.b}});
        for (const Obstacle& obstacle : scene.obstacles) {
            at.push_back(chance.motion());
            all.push_back(outline_of(corners_of(obstacle), at.back()));
        }
        const CompiledSensor sensor(chance.sensor());
        const SensorPose pose = sensor_pose(sensor, {chance.number(-1, 1) * w, chance.number(-1, 1) * h},
                                            maths::direction(chance.number(-4, 4)));
        float expected = 0;
        for (const Outline& outline : all) {
            const float response = response_to_outline(sensor, pose, outline);
            expected += response;
            ++(response > 0 ? felt : beyond);
        }
        EXPECT_EQ(Outlines(scene, at).total(sensor, pose), expected);
    }
    EXPECT_GT(felt, 500);
    EXPECT_GT(beyond, 500);
}

TEST(Outline, OutlinesMoveWithPushedObstacles) {
    Scene scene = with_obstacle({.name = "box", .x = 2, .mass = 5});
    Outlines outlines = outlines_of(scene);
    outlines.move(scene, {mechanics::at_rest({0, 3}, 0)});
    EXPECT_FALSE(outlines.block({0, 0}, {4, 0}));
    EXPECT_TRUE(outlines.block({0, 0}, {0, 5}));
}

TEST(Outline, ABumperSensesOnlyOnItsSide) {
    const Body body;
    const mechanics::Motion motion = mechanics::at_rest({1, 2}, maths::radians(90));
    const Outline ahead{{{-5, 2.52f}, {5, 2.52f}}}, far_ahead{{{-5, 2.7f}, {5, 2.7f}}},
        behind{{{-5, 1.48f}, {5, 1.48f}}};
    const CompiledSensor front({.channel = Channel::touch}),
        back({.channel = Channel::touch, .x = -0.3f, .angle = maths::pi});
    EXPECT_TRUE(touches_field(front, body, motion, ahead));
    EXPECT_FALSE(touches_field(front, body, motion, far_ahead));
    EXPECT_FALSE(touches_field(front, body, motion, behind));
    EXPECT_TRUE(touches_field(back, body, motion, behind));
    EXPECT_FALSE(touches_field(back, body, motion, ahead));
    const CompiledSensor all({.channel = Channel::touch, .shape = SensorShape::omni});
    EXPECT_TRUE(touches_field(all, body, motion, ahead) && touches_field(all, body, motion, behind));
}

}  // namespace
}  // namespace braitenlab::tests::outline_test
