// Ecology: energy, recharging, roles by wiring, and counted events.
#include <cmath>

#include "core/io/run_file.h"
#include "core/session/session.h"
#include "tests/core/runs.h"
#include "tests/core/scenes.h"

namespace braitenlab::tests::ecology_test {
namespace {

using namespace world;
using tests::after;
using tests::alone;
using tests::begin_with;
using tests::look;
using tests::make;

TEST(World, RechargingGivesEnergyOnlyInItsZoneAndAtMostOne) {
    Scene scene = alone({});
    scene.kinds[0].driver = Driver::parked;
    scene.starts.push_back({.name = "beside", .kind = "tester", .x = 3});
    scene.ecology.drain = 0.1f;
    scene.zones.push_back({.name = "hutch", .length = 2, .width = 2, .recharge = 0.3f});
    World world = begin_with(scene, [](State& m) { m.vehicles.energy = {0.5f, 0.5f}; });
    Snapshot now = after(world, 1);
    EXPECT_NEAR(now.vehicles[0].energy, 0.7f, 1e-4f);
    EXPECT_NEAR(now.vehicles[1].energy, 0.4f, 1e-4f);
    now = after(world, 2);
    EXPECT_EQ(now.vehicles[0].energy, 1);
}

TEST(World, ADrainOfTenHoursTakesItsShareInTenMinutes) {
    Scene scene = alone({});
    scene.kinds[0].driver = Driver::parked;
    scene.ecology.drain = 1.0f / 36000;
    World world = make(scene);
    EXPECT_NEAR(after(world, 600).vehicles[0].energy, 1 - 600.0f / 36000, 1e-5f);
}

// Predators and prey by wiring only: crossed wires approach other vehicles, uncrossed wires avoid them.
Scene by_wiring() {
    Scene scene = alone({});
    scene.kinds.clear();
    scene.kinds.push_back(tests::two_eyed("drawn", {.LR = 1, .RL = 1, .LM = 0.4f, .RM = 0.4f}, Channel::vehicle));
    scene.kinds.push_back(tests::two_eyed("shy", {.LL = 1, .RR = 1}, Channel::vehicle));
    scene.kinds[1].driver = Driver::parked;
    for (Kind& kind : scene.kinds) kind.role = Role::wiring;
    scene.starts = {{.name = "a", .kind = "drawn", .x = -2}, {.name = "b", .kind = "shy"}};
    return scene;
}

TEST(World, ARoleByWiringMakesAVehicleThatApproachesOthersAPredatorThatBites) {
    World world = make(by_wiring());
    Snapshot now = look(world);
    EXPECT_EQ(now.vehicles[0].role, Role::predator);
    EXPECT_EQ(now.vehicles[1].role, Role::prey);
    now = after(world, 3);
    EXPECT_GT(now.events.captures, 0);
    EXPECT_LT(now.vehicles[1].energy, 1);
}

TEST(World, ARoleByWiringIsNoneForAVehicleThatSensesLightOnly) {
    Scene scene = by_wiring();
    for (Sensor& sensor : scene.kinds[0].sensors) sensor.channel = Channel::light;
    EXPECT_EQ(look(make(scene)).vehicles[0].role, Role::none);
}

TEST(World, ARoleByWiringFollowsFromThePairThatSensesVehicles) {
    Scene scene = by_wiring();
    Kind& kind = scene.kinds[0];  // approaches others, and flees light by another pair
    for (const char* name : {"EL", "ER"}) {
        Sensor eye = kind.sensors[name[1] == 'L' ? 0 : 1];
        eye.name = name, eye.channel = Channel::light;
        kind.sensors.insert(kind.sensors.begin(), eye);
        kind.brain.nodes.push_back({.id = name[1] == 'L' ? 10 : 11, .kind = NodeKind::sensor, .name = name});
    }
    for (const Dial dial : {Dial::LL, Dial::RR}) turn(kind.brain, dial, 1, {"EL", "ER"});
    EXPECT_EQ(look(make(scene)).vehicles[0].role, Role::predator);
}

TEST(World, ARoleByWiringChangesWithTheWiring) {
    World world = make(by_wiring());
    ASSERT_FALSE(world.apply(SetBrain{{.vehicle = 0}, make_graph({.LL = 1, .RR = 1})}));
    EXPECT_EQ(look(world).vehicles[0].role, Role::prey);
    ASSERT_FALSE(world.apply(SetBrain{{.vehicle = 0}, make_graph({.LM = 1, .RM = 1})}));
    EXPECT_EQ(look(world).vehicles[0].role, Role::none);
}

TEST(World, ARoleByWiringDeterminesTheKindThatReplacesAStarvedVehicle) {
    World world = begin_with(by_wiring(), [](State& m) { m.vehicles.energy = {0, 1}; });
    const Snapshot now = after(world, 1.0 / 60);
    ASSERT_EQ(now.vehicles.size(), 2u);
    EXPECT_EQ(now.events.deaths, 1);
    EXPECT_EQ(now.events.births, 1);
    EXPECT_EQ(now.vehicles[1].kind, 1) << "a predator has starved, so prey is added";
    EXPECT_EQ(now.vehicles[1].energy, 1);
}

TEST(World, EventsCountALongContactOnce) {
    Scene scene = alone({.LM = 0.5f, .RM = 0.5f});
    scene.arena.width = scene.arena.height = 6;
    World world = make(scene);
    const std::int64_t met = after(world, 4).events.contacts;
    EXPECT_GE(met, 1);
    EXPECT_LE(met, 3) << "the vehicle may bounce";
    EXPECT_EQ(after(world, 10).events.contacts, met) << "also across keyframes";
}

TEST(World, RecordsWhereAVehicleStrikesAWallForASecond) {
    Scene scene = alone({.LM = 0.5f, .RM = 0.5f});
    scene.arena.width = scene.arena.height = 6;
    World world = make(scene);
    EXPECT_TRUE(look(world).strikes.empty());
    Snapshot now = look(world);
    while (now.events.contacts == 0 && now.seconds < 10) now = after(world, 1.0 / 60);
    ASSERT_EQ(now.strikes.size(), 1u);
    EXPECT_EQ(now.strikes[0].vehicle, 0);
    EXPECT_NEAR(now.strikes[0].x, 3, 0.05f) << "it drives along x, to the wall at 3 m";
    EXPECT_NEAR(now.strikes[0].y, 0, 0.4f);
    EXPECT_LE(now.strikes[0].age, 1.1f / 60);
    now = after(world, 0.5);
    ASSERT_EQ(now.strikes.size(), 1u) << "of one vehicle at most once a second";
    EXPECT_NEAR(now.strikes[0].age, 0.5f, 0.05f);
    const auto kept = begin_with(scene, [](State& m) { m.strikes = {{0, {1, 2}, 0}}; });
    ASSERT_EQ(look(kept).strikes.size(), 1u);
    EXPECT_EQ(look(kept).strikes[0].y, 2);
    EXPECT_EQ(kept.hash(), make(scene).hash()) << "strikes are for display";
    EXPECT_TRUE(after(world, 2).strikes.empty()) << "it pushes against the wall and does not strike again";
}

TEST(World, RecordsWhereTwoVehiclesStrikeEachOther) {
    Scene scene = alone({.LM = 0.5f, .RM = 0.5f});
    scene.starts.push_back({.name = "other", .kind = "tester", .x = 4, .heading = maths::pi});
    World world = make(scene);
    Snapshot now = look(world);
    while (now.events.contacts == 0 && now.seconds < 10) now = after(world, 1.0 / 60);
    ASSERT_EQ(now.strikes.size(), 1u);
    EXPECT_EQ(now.strikes[0].vehicle, 0);
    EXPECT_EQ(now.strikes[0].other, 1);
    EXPECT_NEAR(now.strikes[0].x, 2, 0.1f) << "half way between both";
    Session session = std::move(*Session::open(scene, 1));
    while (session.snapshot().strikes.empty() && session.snapshot().seconds < 10) session.step();
    const auto kept = io::read_run(io::write_run(session.save()), "a.run");
    ASSERT_TRUE(kept) << kept.error().text();
    ASSERT_EQ(Session::resume(*kept).snapshot().strikes.size(), 1u);
    EXPECT_EQ(Session::resume(*kept).snapshot().strikes[0].other, 1);
}

TEST(World, EventsCountOneBitePerSecondAndPairForAnyNumberOfPredators) {
    Scene scene = tests::crowd(0);
    scene.ecology.bite = 0.001f;
    for (Kind& kind : scene.kinds) kind.driver = Driver::parked;
    // Prey between four predators that touch it from all sides.
    scene.starts.push_back({.name = "prey", .kind = "hunted"});
    for (int i = 0; i < 4; ++i) {
        const maths::vec2 at = maths::direction(maths::pi / 2 * static_cast<float>(i));
        const float far = i % 2 == 0 ? 0.999f : 0.849f;
        scene.starts.push_back({.name = "h" + std::to_string(i),
                                .kind = "hunter",
                                .x = at.x * far,
                                .y = at.y * far,
                                .heading = maths::pi / 2 * static_cast<float>(i)});
    }
    World world = make(scene);
    EXPECT_TRUE(look(world).bites.empty());
    ASSERT_FALSE(world.apply(MoveVehicle{1, 4, 4, 0}));  // the first predator arrives later than the others
    EXPECT_EQ(after(world, 0.5).events.captures, 3);
    const auto bites = look(world).bites;
    ASSERT_EQ(bites.size(), 3u);
    EXPECT_EQ(bites[0].one, 0) << "the prey";
    EXPECT_EQ(bites[0].other, 2);
    EXPECT_GT(bites[0].age, 0.3f);
    EXPECT_LE(bites[0].age, 0.5f);
    ASSERT_FALSE(world.apply(MoveVehicle{1, 0.999f, 0, 0}));
    EXPECT_EQ(after(world, 0.4).events.captures, 4);
    EXPECT_EQ(after(world, 0.4).events.captures, 7);
    EXPECT_EQ(after(world, 0.5).events.captures, 8);
    EXPECT_EQ(after(world, 1).events.captures, 12);
}

}  // namespace
}  // namespace braitenlab::tests::ecology_test
