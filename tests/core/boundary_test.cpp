// The edge of the arena, and obstacles.
#include <cmath>

#include "tests/core/runs.h"
#include "tests/core/scenes.h"

namespace braitenlab::tests::boundary_test {
namespace {

using namespace world;
using tests::after;
using tests::alone;
using tests::begin_with;
using tests::look;
using tests::make;

Scene small_arena(Boundary edge, float x, float y, float heading) {
    Scene scene = alone({.LM = 0.5f, .RM = 0.5f}, x, y, heading);
    scene.arena.width = 10;
    scene.arena.height = 6;
    scene.arena.edge = edge;
    return scene;
}

TEST(World, ARimHoldsAVehicleAndOnlyItsBumperFeelsIt) {
    for (const bool round : {false, true})
        for (const Boundary edge : {Boundary::wall, Boundary::rim}) {
            Scene scene = small_arena(edge, 0, 0, 0);
            scene.arena.round = round;
            Sensor bumper{.channel = Channel::touch}, eye{.channel = Channel::obstacle};
            bumper.name = "T", bumper.fov = maths::radians(200), bumper.response = SensorResponse::boolean;
            eye.name = "O";
            scene.kinds[0].sensors.insert(scene.kinds[0].sensors.end(), {bumper, eye});
            const std::size_t first = scene.kinds[0].sensors.size() - 2;
            World world = make(scene);
            const Snapshot now = after(world, 10);
            EXPECT_LT(now.vehicles[0].x, 5);
            EXPECT_GT(now.vehicles[0].x, 4);
            EXPECT_EQ(now.sensed[first], 1);
            EXPECT_EQ(now.sensed[first + 1] > 0, edge == Boundary::wall);
        }
}

TEST(World, ATorusMovesAVehicleToTheOppositeEdgeAndKeepsItsSpeed) {
    World world = make(small_arena(Boundary::torus, 0, 1, 0));
    const double lap = 10 / 1.5;
    after(world, 3 * lap);
    float farthest = 0, slowest = 10;
    for (int tick = 0; tick < 600; ++tick) {
        const VehicleView now = after(world, 1.0 / 60).vehicles[0];
        farthest = std::max(farthest, std::fabs(now.x));
        slowest = std::min(slowest, now.speed);
        EXPECT_NEAR(now.y, 1, 1e-3f);
    }
    EXPECT_LE(farthest, 5);
    EXPECT_GT(farthest, 4.9f);
    EXPECT_GT(slowest, 1.49f);
    EXPECT_EQ(look(world).events, EventCounts{});
}

TEST(World, ATorusConnectsTheUpperAndLowerEdges) {
    World world = make(small_arena(Boundary::torus, 2, 2, maths::pi / 2));
    const VehicleView now = after(world, 1.5).vehicles[0];
    EXPECT_LT(now.y, -1);
    EXPECT_NEAR(now.x, 2, 1e-3f);
}

TEST(World, AnOpenEdgeLetsAVehicleFallAndReturnsItToItsStartWithItsId) {
    World world = make(small_arena(Boundary::open, 4, 0.5f, 0));
    const VehicleId id = look(world).vehicles[0].id;
    Snapshot now = look(world);
    while (now.events.falls == 0 && now.tick < 600) now = after(world, 1.0 / 60);
    EXPECT_EQ(now.events.falls, 1);
    EXPECT_EQ(now.events.deaths, 1);
    EXPECT_EQ(now.events.births, 1);
    ASSERT_EQ(now.vehicles.size(), 1u);
    EXPECT_EQ(now.vehicles[0].id, id);
    EXPECT_EQ(now.vehicles[0].x, 4);
    EXPECT_EQ(now.vehicles[0].y, 0.5f);
    EXPECT_EQ(now.vehicles[0].speed, 0);
    EXPECT_EQ(now.fallen, std::vector<VehicleId>{id});
    EXPECT_EQ(look(World::restore(world.checkpoint())).fallen, now.fallen);
    EXPECT_TRUE(after(world, 1.0 / 60).fallen.empty()) << "of the last tick only";
}

TEST(World, AnOpenEdgeReplacesFallenVehiclesOfThePopulation) {
    Scene scene = small_arena(Boundary::open, 0, 0, 0);
    scene.starts.clear();
    scene.kinds[0].share = 1;
    scene.ecology.population = 3;
    World world = make(scene);
    const Snapshot now = after(world, 60);
    EXPECT_GT(now.events.falls, 3);
    EXPECT_EQ(now.events.deaths, now.events.falls);
    EXPECT_EQ(now.vehicles.size(), 3u);
}

TEST(World, WallsKeepVehiclesThatAreMovedBehindThemInside) {
    World world = make(small_arena(Boundary::wall, 0, 0, 0));
    ASSERT_FALSE(world.apply(MoveVehicle{0, 700, -3.1f, 1}));
    const VehicleView now = after(world, 1).vehicles[0];
    EXPECT_LT(std::fabs(now.x), 5);
    EXPECT_LT(std::fabs(now.y), 3);
}

// A vehicle 2 m left of the middle drives against the obstacle there.
Scene at_the_middle(float speed = 0.5f) { return alone({.LM = speed, .RM = speed}, -2, 0, 0); }

TEST(World, ObstaclesStopAVehicleAtTheirSideForAnyShape) {
    Scene wedge = at_the_middle();
    // A triangle whose left side is at x = −0.5 from its middle.
    wedge.obstacles.push_back({.name = "wedge", .corners = {{-0.5f, -1}, {1, 0}, {-0.5f, 1}}});
    World world = make(wedge);
    EXPECT_NEAR(after(world, 5).vehicles[0].x, -1, 0.03f);  // its front is half a metre ahead
    Scene post = at_the_middle();
    post.sources.push_back({.name = "post", .solid = true});
    World other = make(post);
    EXPECT_NEAR(after(other, 3).vehicles[0].x, -0.5f - solid_source_radius, 0.03f);
    Scene table = at_the_middle(0.2f);
    table.arena.width = table.arena.height = 2;
    table.starts[0].x = -0.8f;
    table.kinds[0].body = resized(table.kinds[0].body, 0.1f, 0.07f);
    table.kinds[0].body.mass = 0.2f, table.kinds[0].body.top_speed = 0.5f;
    table.sources = post.sources;
    World small = make(table);
    EXPECT_NEAR(after(small, 12).vehicles[0].x, -0.05f - 0.06f, 0.01f) << "posts are smaller on a table of 2 m";
    Scene ghost = at_the_middle();
    ghost.sources.push_back({.name = "lamp"});
    World third = make(ghost);
    EXPECT_GT(after(third, 5).vehicles[0].x, 2) << "a vehicle passes through a lamp that is not solid";
}

TEST(World, ObstaclesWithAMassArePushedAndStopAgain) {
    Scene scene = at_the_middle();
    scene.obstacles.push_back({.name = "box", .length = 0.5f, .width = 0.5f, .mass = 2});
    World world = make(scene);
    const float pushed = after(world, 4).obstacles[0].x;
    EXPECT_GT(pushed, 0.5f);
    ASSERT_FALSE(world.apply(ChooseDriver{0, Driver::parked}));
    const float then = after(world, 3).obstacles[0].x;
    EXPECT_NEAR(after(world, 1).obstacles[0].x, then, 1e-3f) << "the floor brakes an obstacle that is not pushed";
    Scene heavy = scene;
    heavy.obstacles[0].mass = 5000;
    World slow = make(heavy);
    EXPECT_LT(after(slow, 4).obstacles[0].x, 0.25f);
}

TEST(World, ObstaclesCrossTheSeamOfATorus) {
    Scene scene = small_arena(Boundary::torus, -1, 0, maths::pi);
    scene.obstacles.push_back({.name = "box", .x = 4, .length = 0.5f, .width = 0.5f, .mass = 1});
    World world = begin_with(scene, [](State& m) { m.obstacles[0].velocity = {6, 0}; });
    const float there = after(world, 0.8).obstacles[0].x;
    EXPECT_LT(there, -3.8f);
    EXPECT_GE(there, -5);
    EXPECT_LT(after(world, 1.2).obstacles[0].x, -4.4f) << "the vehicle pushes it at its present position";
}

}  // namespace
}  // namespace braitenlab::tests::boundary_test
