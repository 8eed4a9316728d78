#include "core/world/world.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "core/mechanics/wheel.h"
#include "tests/core/scenes.h"
#include "tests/response_law.h"

namespace braitenlab::tests::world_test {
namespace {

using tests::alone;
using tests::crowd;

World make(const Scene& scene, std::uint64_t seed = 1) {
    auto world = World::create(scene, seed);
    EXPECT_TRUE(world) << world.error().text();
    return std::move(*world);
}

Snapshot after(World& world, double seconds) {
    const auto until = world.tick() + static_cast<std::uint64_t>(std::llround(seconds * 60));
    while (world.tick() < until) world.step();
    Snapshot now;
    world.capture(now);
    return now;
}

TEST(World, RepeatsARunBitForBit) {
    World a = make(crowd(30), 7), b = make(crowd(30), 7), other = make(crowd(30), 8);
    after(a, 20), after(b, 20), after(other, 20);
    EXPECT_EQ(a.hash(), b.hash());
    EXPECT_NE(a.hash(), other.hash());
}

TEST(World, HashesDifferForDifferentWeights) {
    World a = make(crowd(2)), b = make(crowd(2));
    ASSERT_FALSE(b.apply(TurnDial{{.kind = 0}, Dial::LL, 0.001f}));
    EXPECT_NE(a.hash(), b.hash());
}

TEST(World, ASnapshotTellsWhetherItsCommandsAreThoseOfTheNextTick) {
    World world = make(alone({.LM = 0.5f, .RM = 0.5f}));
    EXPECT_FALSE(after(world, 1).is_preview);
    ASSERT_FALSE(world.apply(TurnDial{{.kind = 0}, Dial::LM, -0.5f}));
    const Snapshot edited = after(world, 0);
    EXPECT_TRUE(edited.is_preview);
    EXPECT_FLOAT_EQ(edited.vehicles[0].motor[0], -0.5f);
    world.step();
    EXPECT_FALSE(after(world, 0).is_preview);
}

TEST(World, WheelsDriveStraightAheadOnEqualCommands) {
    World world = make(alone({.LM = 0.5f, .RM = 0.5f}));
    const Snapshot now = after(world, 5);
    EXPECT_NEAR(now.vehicles[0].speed, 1.5f, 0.05f);
    EXPECT_NEAR(now.vehicles[0].y, 0, 1e-3f);
    EXPECT_GT(now.vehicles[0].x, 6);
}

TEST(World, WheelsFollowTheCircleOfADifferentialDrive) {
    for (const auto& [left, right] : {std::pair{0.2f, 0.5f}, {0.5f, 0.3f}, {-0.2f, 0.2f}, {0.1f, 0.6f}}) {
        World world = make(alone({.LM = left, .RM = right}));
        const Snapshot a = after(world, 3), b = after(world, 1);
        const float track = 0.6f, top = 3;
        const auto drive = mechanics::drive_of_wheels(left * top, right * top, track);
        const float turned = maths::wrap_angle(b.vehicles[0].heading - a.vehicles[0].heading);
        EXPECT_NEAR(turned, maths::wrap_angle(drive.turning), std::fabs(drive.turning) * 0.05f) << left << " " << right;
        EXPECT_NEAR(b.vehicles[0].speed, drive.forward, 0.05f * std::fabs(drive.forward) + 0.01f);
    }
}

TEST(World, WheelsDoNotOscillateAroundACommandedSpeed) {
    World world = make(alone({.LM = 0.4f, .RM = 0.4f}));
    after(world, 4);
    float slowest = 1e9f, fastest = -1e9f;
    for (int i = 0; i < 60; ++i) {
        const Snapshot now = after(world, 1.0 / 60);
        slowest = std::min(slowest, now.vehicles[0].speed);
        fastest = std::max(fastest, now.vehicles[0].speed);
    }
    EXPECT_LT(fastest - slowest, 1e-3f);
}

TEST(World, WheelsAccelerateWithinTheLimitsOfMotorsAndFriction) {
    Scene scene = alone({.LM = 1, .RM = 1});
    scene.arena.grip = 0.1f;  // ice
    World world = make(scene);
    const Body body;
    const float friction = 0.1f * 0.9f * 0.8f * body.mass * mechanics::gravity;
    const Snapshot now = after(world, 0.5);
    EXPECT_LE(now.vehicles[0].speed, 0.5f * friction / body.mass * 1.02f);
    EXPECT_GT(now.vehicles[0].speed, 0.5f * friction / body.mass * 0.9f);
}

TEST(World, WallsKeepVehiclesInTheArena) {
    Scene scene = alone({.LM = 1, .RM = 1});
    scene.arena.width = scene.arena.height = 10;
    World world = make(scene);
    const Snapshot now = after(world, 10);
    EXPECT_LT(now.vehicles[0].x, 5);
    EXPECT_NEAR(now.vehicles[0].x, 4.5f, 0.05f);  // the front of the chassis, 0.5 m ahead, touches the wall
    EXPECT_GT(now.events.contacts, 0);
}

TEST(World, EyesReadMoreForALampOnTheirSide) {
    Scene scene = alone({}, 0, 0, 0);
    scene.sources.push_back({.name = "lamp", .x = 4, .y = 0.3f});
    World world = make(scene);
    Snapshot now;
    world.capture(now);
    EXPECT_GT(now.sensed[0], now.sensed[1]);
    EXPECT_GT(now.sensed[1], 0);
}

TEST(World, EyesFollowTheGradedFormula) {
    Scene scene = alone({});
    scene.kinds[0].sensors.resize(1);
    scene.kinds[0].sensors[0].x = scene.kinds[0].sensors[0].y = scene.kinds[0].sensors[0].angle = 0;
    scene.sources.push_back({.name = "lamp", .x = 4 * std::cos(0.3f), .y = 4 * std::sin(0.3f), .strength = 0.8f});
    World world = make(scene);
    Snapshot now;
    world.capture(now);
    EXPECT_NEAR(now.sensed[0], 0.8 * std::cos(0.3) * reading_at(4), 1e-5);
}

TEST(World, EyesAddUpSeveralLampsAndSaturate) {
    Scene scene = alone({});
    for (int i = 0; i < 9; ++i)
        scene.sources.push_back({.name = std::string(1, static_cast<char>('a' + i)), .x = 3, .y = 0});
    World world = make(scene);
    Snapshot now;
    world.capture(now);
    EXPECT_EQ(now.sensed[0], 1);
}

TEST(World, EyesSenseAWallByItsNearestVisiblePoint) {
    Scene scene = alone({}, 0, 0, 0);
    scene.arena.width = 20;
    auto& sensor = scene.kinds[0].sensors[0];
    sensor.channel = Channel::obstacle;
    sensor.angle = 0;
    sensor.x = sensor.y = 0;
    World world = make(scene);
    Snapshot now;
    world.capture(now);
    EXPECT_NEAR(now.sensed[0], reading_at(10), 1e-5);
}

TEST(World, RolesLetPredatorsSenseOnlyPreyAndPreyOnlyPredators) {
    Scene scene = crowd(0);
    scene.starts = {{.name = "a", .kind = "hunter", .x = 0, .y = 0},
                    {.name = "b", .kind = "hunter", .x = 3, .y = 0},
                    {.name = "c", .kind = "hunted", .x = -5, .y = 0, .heading = maths::pi},
                    {.name = "d", .kind = "hunted", .x = -8, .y = 0, .heading = maths::pi}};
    World world = make(scene);
    Snapshot now;
    world.capture(now);
    for (const float s : now.sensed) EXPECT_EQ(s, 0);  // a points at b, c points at d: no vehicle of the sensed role
    ASSERT_FALSE(world.apply(MoveVehicle{now.vehicles[2].id, 3, 3, 0}));
    ASSERT_FALSE(world.apply(MoveVehicle{now.vehicles[1].id, 3, -8, 0}));
    world.capture(now);
    EXPECT_GT(now.sensed[0], 0);  // prey is in the field of a's left eye
}

TEST(World, APredatorBitesPreyOnceASecondWhileTheyTouch) {
    Scene scene = crowd(0);
    scene.arena.width = scene.arena.height = 20;
    scene.kinds[0].brain = make_graph({.LM = 0.5f, .RM = 0.5f});
    scene.kinds[1].brain = make_graph({});
    scene.kinds[1].driver = Driver::parked;
    scene.ecology.bite = 0.1f;
    scene.starts = {{.name = "a", .kind = "hunter", .x = 0}, {.name = "b", .kind = "hunted", .x = 1.2f}};
    World world = make(scene);
    const Snapshot now = after(world, 4.5);
    EXPECT_GE(now.events.captures, 3);
    EXPECT_LE(now.events.captures, 5);
    EXPECT_NEAR(now.vehicles[1].energy, 1 - 0.1f * static_cast<float>(now.events.captures), 1e-5f);
}

TEST(World, EnergyAtZeroReplacesTheVehicleByOneOfTheOppositeRole) {
    Scene scene = crowd(4);
    scene.kinds[1].share = 0;  // predators only at first
    scene.ecology.drain = 0.5f;
    scene.ecology.bite = 0;
    World world = make(scene);
    const Snapshot before = after(world, 1), now = after(world, 1.2);
    EXPECT_EQ(before.events.deaths, 0);
    EXPECT_EQ(now.events.deaths, 4);
    EXPECT_EQ(now.events.births, 4);
    EXPECT_EQ(before.predators, 4);
    EXPECT_EQ(now.prey, 4);
    EXPECT_EQ(now.vehicles.size(), 4u);
    EXPECT_GT(now.vehicles.front().id, before.vehicles.back().id);  // ids are never reused
}

TEST(World, TheGenerationIncreasesAfterTheIdleTimeOfTheScene) {
    Scene scene = crowd(4);
    for (Kind& kind : scene.kinds) kind.driver = Driver::parked;
    scene.ecology.inactivity = 2;
    World world = make(scene);
    EXPECT_EQ(after(world, 1.5).generation, 1);
    const Snapshot now = after(world, 1);
    EXPECT_EQ(now.generation, 2);
    EXPECT_EQ(now.vehicles.size(), 4u);
}

TEST(World, APopulationKeepsAddedAndRemovedVehiclesInANewWorld) {
    World world = make(crowd(6));
    ASSERT_FALSE(world.apply(AddVehicle{}));
    ASSERT_FALSE(world.apply(AddVehicle{}));
    ASSERT_FALSE(world.apply(RemoveVehicle{}));
    ASSERT_FALSE(world.apply(NewPopulation{}));
    Snapshot now;
    world.capture(now);
    EXPECT_EQ(now.vehicles.size(), 7u);
    EXPECT_EQ(now.generation, 2);
    EXPECT_LE(std::abs(now.predators - now.prey), 1);
}

TEST(World, APopulationStartsWithoutOverlap) {
    World world = make(crowd(50));
    Snapshot now;
    world.capture(now);
    for (std::size_t i = 0; i < now.vehicles.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GT(std::hypot(now.vehicles[i].x - now.vehicles[j].x, now.vehicles[i].y - now.vehicles[j].y), 1.2f);
}

TEST(World, APopulationOfTwoThousandCanBeAddedAndRemoved) {
    Scene scene = crowd(0);
    scene.arena.width = scene.arena.height = 120;
    World world = make(scene);
    for (int i = 0; i < 2000; ++i) ASSERT_FALSE(world.apply(AddVehicle{}));
    after(world, 0.5);
    for (int i = 0; i < 2000; ++i) ASSERT_FALSE(world.apply(RemoveVehicle{}));
    EXPECT_TRUE(world.apply(RemoveVehicle{}));  // no vehicle is left
    EXPECT_EQ(after(world, 0.1).vehicles.size(), 0u);
}

TEST(World, CommandsForAKindApplyToItsPresentAndLaterVehicles) {
    World world = make(crowd(4));
    ASSERT_FALSE(world.apply(TurnDial{{.kind = 1}, Dial::LL, -2}));
    ASSERT_FALSE(world.apply(AddVehicle{1}));
    Snapshot now;
    world.capture(now);
    for (const VehicleView& v : now.vehicles)
        EXPECT_EQ(read_dials(*now.brains[static_cast<std::size_t>(v.brain)]).LL, v.kind == 1 ? -2.0f : 0.0f);
    EXPECT_EQ(now.brains.size(), 2u);  // vehicles that shared a brain still share one
}

TEST(World, CommandsForOneVehicleDoNotChangeOtherVehicles) {
    World world = make(crowd(4));
    Snapshot now;
    world.capture(now);
    const VehicleId chosen = now.vehicles[2].id;
    ASSERT_FALSE(world.apply(TurnDial{{.vehicle = chosen}, Dial::RM, -0.5f}));
    world.capture(now);
    for (const VehicleView& v : now.vehicles)
        EXPECT_EQ(read_dials(*now.brains[static_cast<std::size_t>(v.brain)]).RM == -0.5f, v.id == chosen);
}

TEST(World, CommandsThatAreInvalidAreRefusedAndChangeNothing) {
    World world = make(crowd(4));
    const auto before = world.hash();
    BrainGraph broken = make_graph({});
    broken.wires.front().to = 99;
    EXPECT_TRUE(world.apply(SetBrain{{.kind = 0}, broken}));
    EXPECT_TRUE(world.apply(TurnDial{{.vehicle = 77}, Dial::LL, 1}));
    EXPECT_TRUE(world.apply(TurnDial{{.kind = 0}, Dial::LL, std::nanf("")}));
    EXPECT_TRUE(world.apply(MoveVehicle{0, std::nanf(""), 0, 0}));
    EXPECT_EQ(world.hash(), before);
}

TEST(Snapshot, OfAPausedWorldShowsTheEffectOfACommandOnTheBrainWithoutATick) {
    Scene scene = alone({});
    find_node(scene.kinds[0].brain, "MR")->time_constant = 0.5f;  // a leaky motor: a second update would change it
    World world = make(scene);
    const auto before = world.hash();
    Snapshot now;
    for (int look = 0; look < 3; ++look) world.capture(now);
    EXPECT_EQ(world.hash(), before);
    ASSERT_FALSE(world.apply(TurnDial{{.kind = 0}, Dial::LM, 0.5f}));
    ASSERT_FALSE(world.apply(TurnDial{{.kind = 0}, Dial::RM, 0.5f}));
    world.capture(now);
    EXPECT_EQ(now.vehicles[0].motor[0], 0.5f);
    const float foreseen = now.vehicles[0].motor[1];
    EXPECT_GT(foreseen, 0);
    EXPECT_EQ(after(world, 1.0 / 60).vehicles[0].motor[1], foreseen);
}

TEST(Snapshot, HasTheValueOfEveryNode) {
    Scene scene = alone({.LL = 0.5f, .LM = 0.25f});
    scene.sources.push_back({.name = "lamp", .x = 2, .y = 0});
    World world = make(scene);
    const Snapshot now = after(world, 1.0 / 60);
    const VehicleView& v = now.vehicles[0];
    EXPECT_EQ(node_value(now, v, 0), now.sensed[0]);
    EXPECT_GT(node_value(now, v, 2), 0.25f);
    EXPECT_EQ(node_value(now, v, 3), 0);
    EXPECT_EQ(node_value(now, v, 99), 0);
}

}  // namespace
}  // namespace braitenlab::tests::world_test
