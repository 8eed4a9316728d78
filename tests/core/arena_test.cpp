// Rectangular and round arenas: which positions are inside, and what happens at a round edge.
#include "core/scene/arena.h"

#include <algorithm>
#include <cmath>

#include "core/sensing/environment.h"
#include "core/session/session.h"
#include "tests/core/runs.h"
#include "tests/core/scenes.h"
#include "tests/tells.h"

namespace braitenlab::tests::arena_test {
namespace {

using maths::vec2;
using tests::after;
using tests::alone;
using tests::look;
using tests::make;

Arena round(float width, float height, Boundary edge = Boundary::wall) {
    return {.width = width, .height = height, .edge = edge, .round = true};
}

// A vehicle in the middle that drives straight ahead at its top speed and has a bumper.
Scene at_full_speed(const Arena& arena, float heading) {
    Scene scene = alone({.LM = 1, .RM = 1}, 0, 0, heading);
    scene.arena = arena;
    scene.kinds[0].sensors.push_back(
        {.name = "T", .channel = Channel::touch, .shape = SensorShape::omni, .fov = 2 * maths::pi});
    return scene;
}

float bumper(const Snapshot& now) {
    return now.sensed.at(static_cast<std::size_t>(now.vehicles.at(0).first_sensed) + 2);
}

// Shortest distance from the ellipse, by trying many of its points.
float distance_from_ellipse(const Arena& arena, vec2 position) {
    constexpr int points = 4000;  // at most 7 cm apart: at a distance of 0.7 m an error below 1 mm
    float least = 1e9f;
    for (int i = 0; i < points; ++i) {
        const vec2 on = maths::direction(static_cast<float>(i) * 2 * maths::pi / points);
        least = std::min(least, maths::distance({on.x * arena.width / 2, on.y * arena.height / 2}, position));
    }
    return least;
}

TEST(Arena, KnowsThePositionsInsideItsEdge) {
    const Arena box{.width = 10, .height = 6};
    EXPECT_TRUE(is_inside(box, {5, -3}));
    EXPECT_FALSE(is_inside(box, {5.01f, 0}));
    EXPECT_FALSE(is_inside(box, {0, 2.6f}, 0.5f));
    const Arena oval = round(10, 6);
    EXPECT_TRUE(is_inside(oval, {5, 0}));
    EXPECT_FALSE(is_inside(oval, {4.9f, 2.9f})) << "in the corner of the rectangle";
    EXPECT_FALSE(is_inside(oval, {0, 3.01f}));
    EXPECT_FALSE(is_inside(oval, {0, 0}, 3.5f)) << "the arena is narrower than this";
}

TEST(Arena, KeepsTheMarginFromARoundEdge) {
    for (const Arena& arena : {round(10, 10), round(12, 4), round(3, 90)}) {
        int inside = 0, outside = 0;
        for (int i = -12; i <= 12; ++i)
            for (int j = -12; j <= 12; ++j) {
                const vec2 at{arena.width / 24 * static_cast<float>(i), arena.height / 24 * static_cast<float>(j)};
                const float distance = distance_from_ellipse(arena, at);
                if (std::fabs(distance - 0.7f) < 0.02f) continue;  // the polygon is up to 1 cm inside
                const bool expected = is_inside(arena, at) && distance > 0.7f;
                EXPECT_EQ(is_inside(arena, at, 0.7f), expected) << at << " in " << arena.width;
                ++(expected ? inside : outside);
            }
        EXPECT_GT(inside, 10);
        EXPECT_GT(outside, 100);
    }
}

TEST(Arena, MovesPositionsInside) {
    const Arena box{.width = 10, .height = 6}, oval = round(10, 6);
    EXPECT_EQ(moved_inside(box, {8, 1}, 0.5f), (vec2{4.5f, 1}));
    EXPECT_EQ(moved_inside(oval, {2, -1}, 0.5f), (vec2{2, -1})) << "inside already";
    for (const float margin : {0.0f, 0.5f})
        for (const vec2 from : {vec2{8, 1}, vec2{-5, 3}, vec2{0, -700}}) {
            const vec2 to = moved_inside(oval, from, margin);
            EXPECT_TRUE(is_inside(oval, to, margin)) << from;
            EXPECT_NEAR(distance_from_ellipse(oval, to), margin, 0.012f) << from;
        }
    EXPECT_EQ(moved_inside(oval, {9, 9}, 4), vec2{});
}

TEST(Arena, RefusesARoundTorusAndStartsOutsideTheEllipse) {
    Scene scene = alone({}, 4.5f, 4.5f);
    scene.arena = round(10, 10);
    ASSERT_TRUE(check_scene(scene));
    EXPECT_TRUE(tells(*check_scene(scene), message_of("starts_outside")));
    EXPECT_TRUE(check_scene(scene)->text().starts_with("vehicle.it.x: "));
    scene.arena.round = false;
    EXPECT_FALSE(check_scene(scene));
    scene.arena.round = true, scene.starts[0].x = 1;
    EXPECT_FALSE(check_scene(scene));
    scene.ecology.population = 1;
    scene.members = {{.name = "0", .placed = true, .x = -4, .y = 4}};
    EXPECT_TRUE(check_scene(scene)) << "a member starts outside";
    scene.members.clear();
    scene.arena.edge = Boundary::torus;
    ASSERT_TRUE(check_scene(scene));
    EXPECT_NE(check_scene(scene)->text().find("arena.round: a torus cannot be round"), std::string::npos);
}

TEST(Arena, ARoundWallKeepsAVehicleAtFullSpeedInside) {
    for (const Arena& arena : {round(10, 10), round(20, 6), round(2000, 2000)})
        for (const float heading : {0.0f, 0.3f, 0.9f}) {
            World world = make(at_full_speed(arena, heading));
            if (arena.width > 100) {  // close to the wall
                ASSERT_FALSE(world.apply(MoveVehicle{0, 990, 0, heading}));
            }
            Arena wider = arena;
            wider.width += 0.04f, wider.height += 0.04f;
            int touching = 0;
            for (int tick = 0; tick < 60 * 60; ++tick) {
                world.step();
                const VehicleView v = look(world).vehicles[0];
                ASSERT_TRUE(is_inside(arena, position(v))) << tick;
                const vec2 front = position(v) + maths::direction(v.heading) * 0.5f;
                ASSERT_TRUE(is_inside(wider, front)) << front << " at tick " << tick;
                touching += bumper(look(world)) > 0.5f;
            }
            if (arena.width > 100) continue;  // its wall is so straight that a vehicle which met it drives away
            EXPECT_EQ(bumper(look(world)), 1) << arena.width << ' ' << heading;
            EXPECT_GT(touching, 30 * 60);
        }
}

TEST(Arena, ARoundWallKeepsAPushedObstacleInside) {
    Scene scene = at_full_speed(round(10, 8), 0.4f);
    scene.obstacles.push_back({.name = "crate", .x = 1.5f, .y = 0.6f, .length = 0.6f, .width = 0.6f, .mass = 3});
    World world = make(scene);
    float farthest = 0;
    for (int second = 0; second < 30; ++second) {
        const Pose crate = after(world, 1).obstacles.at(0);
        ASSERT_TRUE(is_inside(scene.arena, {crate.x, crate.y}, 0.25f)) << crate.x << ' ' << crate.y;
        farthest = std::max(farthest, std::hypot(crate.x, crate.y));
    }
    EXPECT_GT(farthest, 3) << "it is pushed to the wall";
}

TEST(Arena, AVehicleWithPlaceMemoryMarksARoundWall) {
    Scene scene = at_full_speed(round(10, 10), 0.3f);
    scene.kinds[0].memory = {.marks = 3, .fade = 60, .strength = 0.7f};
    World world = make(scene);
    const Snapshot now = after(world, 5);
    ASSERT_FALSE(now.marks.empty());
    EXPECT_NEAR(std::hypot(now.marks[0].x, now.marks[0].y), 5, 0.05f);
}

TEST(Arena, AVehicleFallsWhereItLeavesTheEllipse) {
    World world = make(at_full_speed(round(10, 10, Boundary::open), maths::pi / 4));
    vec2 last;
    while (look(world).events.falls == 0 && world.tick() < 600) {
        last = position(look(world).vehicles[0]);
        world.step();
    }
    EXPECT_EQ(look(world).events.falls, 1);
    EXPECT_NEAR(maths::length(last), 5, 0.06f) << "the corner of the rectangle is at 7 m";
}

TEST(Arena, AnObstacleSensorReadsARoundWallAtItsDistance) {
    for (const Arena& arena : {round(20, 20), round(24, 8)}) {
        Scene scene;
        scene.arena = arena;
        const sensing::Environment environment(scene, {});
        Sensor sensor{
            .channel = Channel::obstacle, .shape = SensorShape::omni, .x = 0, .fov = 2 * maths::pi, .range = 6};
        const sensing::CompiledSensor compiled(sensor);
        int read = 0;
        for (int i = 0; i < 60; ++i) {
            const vec2 on = maths::direction(0.1f * static_cast<float>(i)) * (0.4f + 0.008f * static_cast<float>(i));
            const vec2 at{on.x * arena.width / 2, on.y * arena.height / 2};
            const float distance = distance_from_ellipse(arena, at);
            if (distance > 5.5f || distance < 1) continue;
            const sensing::SensorPose pose = sensing::sensor_pose(compiled, at, {1, 0});
            const float reading = environment.outlines.total(compiled, pose);
            EXPECT_LT(reading, sensing::response_to(compiled, pose, at + vec2{0.99f * distance, 0}, 1)) << at;
            EXPECT_GT(reading, sensing::response_to(compiled, pose, at + vec2{1.01f * distance, 0}, 1)) << at;
            ++read;
        }
        EXPECT_GT(read, 20);
        EXPECT_EQ(environment.outlines.total(compiled, sensing::sensor_pose(compiled, {}, {1, 0})) > 0,
                  arena.height < 12);
    }
}

TEST(Arena, RandomVehiclesStartInsideTheEllipse) {
    for (const Boundary edge : {Boundary::wall, Boundary::open}) {
        Scene scene = tests::crowd(120);
        scene.arena = round(30, 20, edge);
        for (std::uint64_t seed = 1; seed <= 5; ++seed)
            for (const VehicleView& v : look(make(scene, seed)).vehicles)
                EXPECT_TRUE(is_inside(scene.arena, position(v), 0.7f)) << position(v);
    }
}

TEST(Arena, BecomesRoundWithItsVehiclesInsideAndUndoTakesThemBack) {
    Scene scene = tests::crowd(0);
    scene.starts = {{"corner", "hunter", 9, 9, 1}, {"beside", "hunter", 9, 8, 1}, {"near", "hunter", 1, 1, 1}};
    auto session = Session::open(scene, 3);
    ASSERT_TRUE(session);
    Arena oval = scene.arena;
    oval.round = true, oval.height = 16;
    ASSERT_FALSE(session->apply(EditArena{oval}));
    const Snapshot& now = session->snapshot();
    EXPECT_EQ(now.scene->arena, oval);
    for (const VehicleView& v : now.vehicles) EXPECT_TRUE(is_inside(oval, position(v), 0.4f)) << position(v);
    EXPECT_GT(maths::distance(position(now.vehicles[0]), position(now.vehicles[1])), 0.9f);
    EXPECT_EQ(now.vehicles[2].x, 1);
    EXPECT_FALSE(check_scene(*now.scene)) << "the starts are inside, too";
    session->undo();
    EXPECT_EQ(*now.scene, scene);
    EXPECT_FLOAT_EQ(now.vehicles[0].x, 9);
    EXPECT_FLOAT_EQ(now.vehicles[1].y, 8);
    Arena torus = oval;
    torus.edge = Boundary::torus;
    EXPECT_TRUE(session->apply(EditArena{torus})) << "refused";
    EXPECT_EQ(*now.scene, scene);
}

TEST(Arena, ItsShapeIsPartOfTheHash) {
    Scene scene = alone({});
    const std::uint64_t rectangular = make(scene).hash();
    scene.arena.round = true;
    EXPECT_NE(make(scene).hash(), rectangular);
}

TEST(Arena, IsReadAndWrittenWithItsShape) {
    Scene scene = alone({});
    EXPECT_EQ(write_scene(scene).find("round"), std::string::npos) << "a default is not written";
    scene.arena = round(12, 9);
    const auto back = parse_scene(write_scene(scene), "test.toml");
    ASSERT_TRUE(back) << back.error().text();
    EXPECT_EQ(back->arena, scene.arena);
}

}  // namespace
}  // namespace braitenlab::tests::arena_test
