// Commands that edit the arena, the ecology, the kinds and the population, with undo.
#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "core/io/run_file.h"
#include "core/scene/scene_file.h"
#include "core/scene/schema.h"
#include "core/session/session.h"
#include "tests/core/scenes.h"
#include "tests/core/sessions.h"

namespace braitenlab::tests::value_commands_test {
namespace {

Session opened(const Scene& scene, std::uint64_t seed = 3) {
    auto session = Session::open(scene, seed);
    EXPECT_TRUE(session) << session.error().text();
    return std::move(*session);
}

int count_of(const Session& session, int kind) {
    const auto& all = session.snapshot().vehicles;
    return static_cast<int>(
        std::count_if(all.begin(), all.end(), [kind](const VehicleView& v) { return v.kind == kind; }));
}

const Kind& kind_at(const Session& session, int kind) {
    return session.snapshot().scene->kinds[static_cast<std::size_t>(kind)];
}

}  // namespace

TEST(EditArena, BringsVehiclesAndStartsInsideAndUndoTakesThemBack) {
    Scene scene = tests::crowd(0);
    scene.arena.width = scene.arena.height = 40;
    scene.starts = {{"far", "hunter", 18, 18, 1}, {"further", "hunter", 18.2f, 15, 1}, {"near", "hunter", 1, 1, 1}};
    Session session = opened(scene);
    Arena small = scene.arena;
    small.width = 10, small.height = 12, small.edge = Boundary::open;
    ASSERT_FALSE(session.apply(EditArena{small}));
    const Snapshot& now = session.snapshot();
    EXPECT_EQ(now.scene->arena, small);
    for (const VehicleView& v : now.vehicles) {
        EXPECT_LT(std::fabs(v.x), 5);
        EXPECT_LT(std::fabs(v.y), 6);
    }
    EXPECT_GT(std::hypot(now.vehicles[0].x - now.vehicles[1].x, now.vehicles[0].y - now.vehicles[1].y), 0.9f)
        << "each at a free position";
    EXPECT_EQ(now.vehicles[2].x, 1);
    EXPECT_EQ(session.undo_depth(), 1);
    session.undo();
    EXPECT_EQ(*now.scene, scene);
    EXPECT_FLOAT_EQ(now.vehicles[0].x, 18);
    EXPECT_FLOAT_EQ(now.vehicles[1].y, 15);
    session.redo();
    EXPECT_EQ(now.scene->arena, small);
    EXPECT_LT(std::fabs(now.vehicles[0].x), 5);
}

TEST(EditArena, IsOneStepForADragThatMovesFurtherVehicles) {
    Scene scene = tests::crowd(0);
    scene.arena.width = scene.arena.height = 40;
    scene.starts = {{"a", "hunter", 18, 0}, {"b", "hunter", 9, 0}};
    Session session = opened(scene);
    Arena to = scene.arena;
    for (const float width : {30.0f, 20.0f, 14.0f, 13.0f}) {
        to.width = width;
        ASSERT_FALSE(session.apply(EditArena{to}, 8));
    }
    EXPECT_EQ(session.undo_depth(), 1);
    EXPECT_LT(session.snapshot().vehicles[1].x, 7);
    session.undo();
    EXPECT_FLOAT_EQ(session.snapshot().vehicles[0].x, 18);
    EXPECT_FLOAT_EQ(session.snapshot().vehicles[1].x, 9) << "it was moved by a later command of the drag";
    EXPECT_EQ(*session.snapshot().scene, scene);
}

TEST(EditArena, RefusesValuesOutsideTheirRanges) {
    Session session = opened(tests::crowd(3));
    EXPECT_TRUE(session.apply(EditArena{Arena{.width = 0.4f}}));
    EXPECT_TRUE(session.apply(EditArena{Arena{.grip = std::nanf("")}}));
    EXPECT_EQ(session.undo_depth(), 0);
}

TEST(EditEcology, KeepsThePopulation) {
    Session session = opened(tests::crowd(6));
    ASSERT_FALSE(session.apply(EditEcology{Ecology{.population = 99, .drain = 0.5f}}));
    EXPECT_EQ(session.snapshot().scene->ecology.population, 6);
    for (int i = 0; i < 60; ++i) session.step();
    EXPECT_LT(session.snapshot().vehicles[0].energy, 0.8f);
    session.undo();
    EXPECT_EQ(session.snapshot().scene->ecology.drain, 0);
    EXPECT_TRUE(session.apply(EditEcology{Ecology{.drain = 2}}));
}

TEST(Kinds, AreAddedAndRemovedWithUndo) {
    Session session = opened(tests::crowd(4));
    Kind copy = kind_at(session, 0);
    copy.share = 0;
    ASSERT_FALSE(session.apply(AddKind{copy, 0}));
    EXPECT_EQ(kind_at(session, 0).name, "kind") << "the name was in use";
    EXPECT_EQ(kind_at(session, 1).name, "hunter");
    EXPECT_EQ(count_of(session, 0), 0) << "vehicles keep their kind";
    EXPECT_EQ(count_of(session, 1), 2);
    ASSERT_FALSE(session.apply(TurnDial{{.kind = 0}, Dial::LL, 2}));
    const auto refused = session.apply(RemoveKind{1});
    ASSERT_TRUE(refused);
    EXPECT_NE(refused->text().find("2 vehicles are of the kind 'hunter'"), std::string::npos) << refused->text();
    ASSERT_FALSE(session.apply(RemoveKind{0}));
    EXPECT_EQ(count_of(session, 0), 2);
    session.undo();
    EXPECT_EQ(at(read_dials(*session.snapshot().kind_brains[0]), Dial::LL), 2) << "with its brain";
    session.undo(), session.undo();
    EXPECT_EQ(session.snapshot().scene->kinds, tests::crowd(4).kinds);
    EXPECT_TRUE(session.apply(RemoveKind{7}));
}

TEST(Kinds, KeepTheirVehiclesWhenTheyAreRenamed) {
    Scene scene = tests::crowd(2);
    scene.starts = {{"one", "hunter", 1, 1}};
    scene.members = {{.name = "1", .kind = "hunted"}};
    Session session = opened(scene);
    Kind to = kind_at(session, 0);
    to.name = "wolf";
    ASSERT_FALSE(session.apply(EditKind{0, to}));
    to = kind_at(session, 1);
    to.name = "deer";
    ASSERT_FALSE(session.apply(EditKind{1, to}));
    EXPECT_EQ(session.snapshot().scene->starts[0].kind, "wolf");
    EXPECT_EQ(session.snapshot().scene->members[0].kind, "deer");
    session.reset();
    EXPECT_EQ(session.snapshot().vehicles.size(), 3u);
    to.name = "wolf";
    EXPECT_TRUE(session.apply(EditKind{1, to})) << "two kinds of one name";
    to.name = "bad name";
    EXPECT_TRUE(session.apply(EditKind{1, to}));
    session.undo(), session.undo();
    EXPECT_EQ(session.snapshot().scene->starts, scene.starts);
}

TEST(Kinds, GiveTheirNewValuesToTheirVehicles) {
    Session session = opened(tests::crowd(4));
    ASSERT_FALSE(session.apply(ChooseDriver{session.snapshot().vehicles[0].id, Driver::wander}));
    const int kind = session.snapshot().vehicles[0].kind;
    Kind to = kind_at(session, kind);
    const std::vector<Sensor> sensors = to.sensors;
    to.driver = Driver::wander, to.role = Role::none, to.sensors.clear(), to.brain = {};
    to.body = resized(to.body, 0.05f, 0.05f);
    to.body.top_speed = 0.05f, to.body.mass = 0.05f, to.body.mismatch = 0.2f;
    ASSERT_FALSE(session.apply(EditKind{kind, to}));
    for (const VehicleView& v : session.snapshot().vehicles)
        if (v.kind == kind) {
            EXPECT_EQ(v.driver, Driver::wander);
            EXPECT_EQ(v.role, Role::none);
        }
    EXPECT_EQ(kind_at(session, kind).sensors, sensors) << "sensors have a command of their own";
    for (int i = 0; i < 60; ++i) session.step();
    EXPECT_LT(session.snapshot().vehicles[0].speed, 0.08f) << "a robot of 5 cm at 0.05 m/s";
    session.undo();
    EXPECT_EQ(kind_at(session, kind), tests::crowd(4).kinds[static_cast<std::size_t>(kind)]);
    EXPECT_EQ(session.snapshot().vehicles[0].driver, Driver::wander) << "its own driver";
    EXPECT_EQ(session.snapshot().vehicles[2].driver, Driver::brain);
}

TEST(Kinds, ColoursDoNotChangeTheRunAndAreCheckedAndWritten) {
    Session plain = opened(tests::crowd(4)), tinted = opened(tests::crowd(4));
    Kind to = kind_at(tinted, 0);
    to.colour = "#12ab9F";
    ASSERT_FALSE(tinted.apply(EditKind{0, to}));
    EXPECT_EQ(tinted.hash(), plain.hash());
    const auto again = parse_scene(write_scene(tinted.edited_scene()), "a.toml");
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ(again->kinds[0].colour, "#12ab9F");
    for (const char* wrong : {"red", "#12345", "#1234567", "#12345g"}) {
        to.colour = wrong;
        EXPECT_TRUE(tinted.apply(EditKind{0, to})) << wrong;
    }
    const auto read = parse_scene("format = 1\n[kind.a]\ncolour = \"red\"\n", "a.toml");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().line, 3);
}

TEST(Starts, AreRenamedAndTintedWithUndo) {
    Scene scene = tests::crowd(0);
    scene.starts = {{"one", "hunter", 1, 1}, {"two", "hunter", 4, 1}};
    Session session = opened(scene), plain = opened(scene);
    Start to = scene.starts[0];
    to.name = "first", to.colour = "#00ff00";
    ASSERT_FALSE(session.apply(EditStart{0, to}));
    EXPECT_EQ(session.snapshot().scene->starts[0].name, "first");
    const auto again = parse_scene(write_scene(session.edited_scene()), "a.toml");
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ(again->starts[0].colour, "#00ff00");
    to.name = "two";
    EXPECT_TRUE(session.apply(EditStart{0, to})) << "two of one name";
    to.name.clear();
    ASSERT_FALSE(session.apply(EditStart{0, to}));
    EXPECT_EQ(session.snapshot().scene->starts[0].name, "first") << "an empty name changes nothing";
    session.undo(), session.undo();
    EXPECT_EQ(session.snapshot().scene->starts, scene.starts);
    ASSERT_FALSE(session.apply(AddVehicle{.kind = 0, .at = Pose{6, 6}, .colour = "#123456"}));
    EXPECT_EQ(session.snapshot().scene->starts[2].colour, "#123456");
    ASSERT_FALSE(plain.apply(AddVehicle{.kind = 0, .at = Pose{6, 6}}));
    EXPECT_EQ(session.hash(), plain.hash()) << "a colour is display only";
    auto run = io::read_run(io::write_run(session.save()), "a.run");
    ASSERT_TRUE(run) << run.error().text();
    EXPECT_EQ(Session::resume(std::move(*run)).snapshot().scene->starts[2].colour, "#123456");
}

TEST(Body, KeepsTheProportionsOfItsWheelsWhenResized) {
    const Body to = resized(Body{}, 2, 0.35f);
    EXPECT_FLOAT_EQ(to.wheels[0].y, 0.15f);
    EXPECT_FLOAT_EQ(to.wheels[2].x, 0.76f);
    EXPECT_FLOAT_EQ(to.wheels[0].radius, 0.40f);
    EXPECT_EQ(to.wheels[0].grip, Body{}.wheels[0].grip);
    EXPECT_GE(resized(Body{}, 0.05f, 0.05f).wheels[2].radius, 0.005f) << "within the range";
}

TEST(SetPopulation, AddsAndRemovesVehiclesOfOneKindInOneStep) {
    Scene scene = tests::crowd(6);
    scene.starts = {{"one", "hunter", 1, 1}};
    Session session = opened(scene);
    const int hunters = count_of(session, 0), hunted = count_of(session, 1);
    const auto hash = session.hash();
    ASSERT_FALSE(session.apply(SetPopulation{1, 40}));
    EXPECT_EQ(count_of(session, 1), 40);
    EXPECT_EQ(count_of(session, 0), hunters);
    EXPECT_EQ(session.undo_depth(), 1);
    session.undo();
    EXPECT_EQ(count_of(session, 1), hunted);
    EXPECT_EQ(*session.snapshot().scene, scene);
    EXPECT_NE(session.hash(), hash) << "ids of removed vehicles are not used again";
    session.redo();
    EXPECT_EQ(count_of(session, 1), 40);
    ASSERT_FALSE(session.apply(SetPopulation{0, 1}));
    ASSERT_EQ(count_of(session, 0), 1);
    EXPECT_EQ(session.snapshot().scene->starts.size(), 1u) << "vehicles with a start are removed last";
    ASSERT_FALSE(session.apply(SetPopulation{0, 0}));
    EXPECT_TRUE(session.snapshot().scene->starts.empty());
    session.undo(), session.undo();
    EXPECT_EQ(count_of(session, 0), hunters);
    EXPECT_EQ(session.snapshot().scene->starts, scene.starts);
}

TEST(SetPopulation, TakesTwoThousandVehiclesAndBack) {
    Scene scene = tests::crowd(10);
    scene.arena.width = scene.arena.height = 120;
    Session session = opened(scene);
    ASSERT_FALSE(session.apply(SetPopulation{0, 2000}));
    EXPECT_EQ(count_of(session, 0), 2000);
    ASSERT_FALSE(session.apply(SetPopulation{1, 2000}));
    ASSERT_FALSE(session.apply(SetPopulation{0, 3}));
    session.undo();
    EXPECT_EQ(count_of(session, 0), 2000);
    session.undo(), session.undo();
    EXPECT_EQ(*session.snapshot().scene, scene);
}

TEST(SetPopulation, RestoresRemovedVehiclesAsTheyWere) {
    Session session = opened(tests::crowd(12));
    const VehicleId own = session.snapshot().vehicles[10].id;
    ASSERT_FALSE(session.apply(TurnDial{{.vehicle = own}, Dial::LL, -1}));
    ASSERT_FALSE(session.apply(
        EditMember{number_in_population(session.snapshot(), own), Member{.placed = true, .x = 2, .y = 3}}));
    for (int i = 0; i < 90; ++i) session.step();
    const Snapshot before = session.snapshot();
    const Scene scene = session.edited_scene();
    for (const int count : {5, 0, 3, 1}) ASSERT_FALSE(session.apply(SetPopulation{0, count}, 4));
    EXPECT_EQ(count_of(session, 0), 1);
    session.undo();
    EXPECT_EQ(session.edited_scene(), scene);
    const Snapshot& now = session.snapshot();
    ASSERT_EQ(now.vehicles.size(), before.vehicles.size());
    for (std::size_t i = 0; i < now.vehicles.size(); ++i) {
        EXPECT_EQ(now.vehicles[i].id, before.vehicles[i].id);
        EXPECT_NEAR(now.vehicles[i].x, before.vehicles[i].x, 1e-5f);
        EXPECT_EQ(*brain_of(now, now.vehicles[i]), *brain_of(before, before.vehicles[i]));
    }
    for (int i = 0; i < 100; ++i) session.step();
}

TEST(SetPopulation, HoldsAfterAResetAndInASavedScene) {
    Session session = opened(tests::crowd(10));
    ASSERT_FALSE(session.apply(SetPopulation{0, 17}));
    ASSERT_FALSE(session.apply(SetPopulation{1, 3}));
    const Session saved = opened(*parse_scene(write_scene(session.edited_scene()), "a.toml"));
    EXPECT_EQ(count_of(saved, 0), 17);
    EXPECT_EQ(count_of(saved, 1), 3);
    session.reset();
    EXPECT_EQ(count_of(session, 0), 17);
    EXPECT_EQ(count_of(session, 1), 3);
    EXPECT_TRUE(session.apply(SetPopulation{0, -1}));
    EXPECT_TRUE(session.apply(SetPopulation{0, braitenlab::limits::vehicles}));
    EXPECT_TRUE(session.apply(SetPopulation{5, 1}));
}

TEST(SetPopulation, KeepsTheNumbersOfTheOtherKindsInTheScene) {
    Scene scene = tests::crowd(20);
    scene.ecology.drain = 0.02f;
    scene.members = {{.name = "3", .placed = true, .x = 1, .y = 1}};
    Session session = opened(scene);
    for (int i = 0; i < 100 * 60 && count_of(session, 0) == 10; ++i) session.step();
    const int hunters = count_of(session, 0);
    ASSERT_NE(hunters, 10) << "deaths changed the numbers in the world";
    const Scene before = *session.snapshot().scene;
    ASSERT_FALSE(session.apply(SetPopulation{1, 12}));
    EXPECT_EQ(count_of(session, 0), hunters);
    EXPECT_EQ(count_of(session, 1), 12);
    session.undo();
    EXPECT_EQ(*session.snapshot().scene, before);
    session.redo();
    ASSERT_FALSE(session.apply(SetPopulation{0, 1}));
    ASSERT_FALSE(session.apply(SetPopulation{0, 7}));
    EXPECT_EQ(session.snapshot().scene->ecology.population, 19);
    session.undo(), session.undo();
    for (const std::uint64_t seed : {3U, 4U}) {
        session.restart(seed, Keep::edits);
        EXPECT_EQ(count_of(session, 0), 10);
        EXPECT_EQ(count_of(session, 1), 12);
    }
}

TEST(SetPopulation, KeepsTheOwnBrainsWhereASmallerPopulationIsLeft) {
    Scene scene = tests::crowd(20);
    scene.ecology.drain = 0.02f;
    Session session = opened(scene);
    for (int i = 0; i < 100 * 60 && count_of(session, 0) == 10; ++i) session.step();
    const int fewer = count_of(session, 0) < 10 ? 0 : 1;
    ASSERT_FALSE(session.apply(SetPopulation{fewer, 1}));
    const auto population = static_cast<std::size_t>(session.snapshot().scene->ecology.population);
    const auto& vehicles = session.snapshot().vehicles;
    ASSERT_LT(population, vehicles.size());
    const VehicleId first = vehicles[population - 1].id, last = vehicles.back().id;
    ASSERT_FALSE(session.apply(TurnDial{{.vehicle = first}, Dial::LR, -0.75f}));
    ASSERT_FALSE(session.apply(TurnDial{{.vehicle = last}, Dial::LR, 1.25f}));
    ASSERT_FALSE(session.apply(SetLook{last, {"Anna", "#112233"}}));
    session.reset();
    ASSERT_EQ(session.snapshot().vehicles.size(), population);
    std::multiset<float> dials;
    for (std::size_t i = 0; i < population; ++i) dials.insert(dial(session, Dial::LR, i));
    EXPECT_EQ(dials.count(-0.75f), 1u);
    EXPECT_EQ(dials.count(1.25f), 1u);
    ASSERT_EQ(session.snapshot().looks.size(), 1u);
    EXPECT_EQ(session.snapshot().looks[0].look.label, "Anna");
}

// A brain of 9,000 nodes and wires fits 10 vehicles but not the 2,500 of the opened scene.
TEST(Session, SaysWhyAResetTakesTheSceneAsItWasOpened) {
    Scene scene = tests::crowd(2500);
    scene.arena.width = scene.arena.height = 200;
    scene.starts = {{"one", "hunter", 1, 1}};
    Session session = opened(scene);
    session.reset(Keep::submission);
    EXPECT_FALSE(session.last_reset_error());
    ASSERT_FALSE(session.apply(SetPopulation{0, 5}));
    ASSERT_FALSE(session.apply(SetPopulation{1, 5}));
    BrainGraph large = *session.snapshot().kind_brains[0];
    for (int i = 0; i < 1000; ++i)
        large.nodes.push_back({.id = 100 + i, .kind = NodeKind::neuron, .name = "N" + std::to_string(i)});
    for (int i = 0; i < 8000; ++i) large.wires.push_back({100 + i / 8, 100 + (i / 8 + i % 8) % 1000, 0.5f});
    const auto refused = session.apply(SetBrain{{.kind = 0}, large});
    ASSERT_FALSE(refused) << refused->text();
    session.reset(Keep::submission);
    EXPECT_EQ(session.snapshot().vehicles.size(), 2501u);
    ASSERT_TRUE(session.last_reset_error());
    EXPECT_TRUE(session.last_reset_error()->text().starts_with("the reset took the scene as it was opened"))
        << session.last_reset_error()->text();
}

TEST(SetLook, NamesAndTintsAVehicleOfThePopulationForTheFileAndAfterDeaths) {
    Scene scene = tests::crowd(20);
    scene.ecology.drain = 0.02f;
    scene.members = {{.name = "3", .label = "Bob", .colour = "#112233"}};
    Session session = opened(scene);
    ASSERT_TRUE(find_look(session.snapshot().looks, 3));
    EXPECT_EQ(find_look(session.snapshot().looks, 3)->label, "Bob");
    const Look to{"Anna Ä", "#3d7cc9"};
    const auto hash = session.hash();
    ASSERT_FALSE(session.apply(SetLook{19, to}));
    EXPECT_EQ(session.hash(), hash) << "display only";
    session.undo();
    EXPECT_FALSE(find_look(session.snapshot().looks, 19));
    session.redo();
    ASSERT_FALSE(session.apply(RemoveVehicle{19}));
    EXPECT_EQ(session.snapshot().looks.size(), 1u);
    session.undo();
    ASSERT_TRUE(find_look(session.snapshot().looks, 19));
    EXPECT_EQ(*find_look(session.snapshot().looks, 19), to);
    ASSERT_FALSE(session.apply(RemoveVehicle{0}));
    EXPECT_EQ(look_of(session.snapshot(), *find_vehicle(session.snapshot(), 19)), to);
    const Session saved = opened(*parse_scene(write_scene(session.edited_scene()), "a.toml"));
    EXPECT_EQ(*find_look(saved.snapshot().looks, 18), to) << "its number in the population";
    auto run = io::read_run(io::write_run(session.save()), "a.run");
    ASSERT_TRUE(run) << run.error().text();
    EXPECT_EQ(Session::resume(std::move(*run)).snapshot().looks, session.snapshot().looks);
    session.reset();
    EXPECT_EQ(*find_look(session.snapshot().looks, 18), to);
    for (int i = 0; i < 100 * 60 && find_vehicle(session.snapshot(), 18); ++i) session.step();
    EXPECT_FALSE(find_look(session.snapshot().looks, 18)) << "a successor has no name";
    EXPECT_TRUE(session.apply(SetLook{18, to}));
    EXPECT_TRUE(session.apply(SetLook{session.snapshot().vehicles.front().id, {"", "blue"}}));
}

TEST(ValueCommands, AreKeptInARunFile) {
    Session session = opened(tests::crowd(8));
    for (int i = 0; i < 20; ++i) session.step();
    Kind to = kind_at(session, 1);
    to.body = resized(to.body, 0.5f, 0.4f), to.colour = "#ff0000";
    ASSERT_FALSE(session.apply(EditArena{Arena{.width = 12, .edge = Boundary::torus}}));
    ASSERT_FALSE(session.apply(EditEcology{Ecology{.drain = 0.01f}}));
    ASSERT_FALSE(session.apply(AddKind{to}));
    ASSERT_FALSE(session.apply(EditKind{1, to}));
    ASSERT_FALSE(session.apply(SetPopulation{2, 4}));
    ASSERT_FALSE(session.apply(SetPopulation{1, 1}));
    session.undo();
    ASSERT_FALSE(session.apply(AddKind{to}));
    ASSERT_FALSE(session.apply(RemoveKind{3}));
    for (int i = 0; i < 50; ++i) session.step();
    auto run = io::read_run(io::write_run(session.save()), "a.run");
    ASSERT_TRUE(run) << run.error().text();
    Session resumed = Session::resume(std::move(*run));
    EXPECT_EQ(resumed.hash(), session.hash());
    EXPECT_EQ(kind_at(resumed, 1).colour, "#ff0000");
    for (int i = 0; i < 200; ++i) session.step(), resumed.step();
    EXPECT_EQ(resumed.hash(), session.hash());
}

TEST(Session, RestartsWithAnotherSeedAndKeepsItAndTheEdits) {
    Session session = opened(tests::crowd(6));
    const float x = session.snapshot().vehicles[0].x;
    ASSERT_FALSE(session.apply(TurnDial{{.kind = 0}, Dial::LL, 2}));
    for (int i = 0; i < 30; ++i) session.step();
    session.restart(11);
    EXPECT_EQ(session.seed(), 11u);
    EXPECT_EQ(session.snapshot().tick, 0u);
    EXPECT_NE(session.snapshot().vehicles[0].x, x) << "another random pose";
    EXPECT_EQ(at(read_dials(*session.snapshot().kind_brains[0]), Dial::LL), 2);
    const auto hash = session.hash();
    for (int i = 0; i < 30; ++i) session.step();
    session.reset();
    EXPECT_EQ(session.seed(), 11u);
    EXPECT_EQ(session.hash(), hash) << "the same start";
    const auto run = io::read_run(io::write_run(session.save()), "a.run");
    ASSERT_TRUE(run);
    EXPECT_EQ(Session::resume(*run).seed(), 11u);
    session.undo();
    EXPECT_EQ(at(read_dials(*session.snapshot().kind_brains[0]), Dial::LL), 0) << "undo is kept";
}

TEST(Session, ResetsTheBrainsOfKindsByNameAfterKindsWereAdded) {
    Session session = opened(tests::crowd(4));
    ASSERT_FALSE(session.apply(AddKind{kind_at(session, 1), 0}));
    ASSERT_FALSE(session.apply(TurnDial{{.kind = 1}, Dial::LL, 2}));
    session.reset(Keep::submission);
    ASSERT_EQ(session.snapshot().scene->kinds.size(), 2u);
    EXPECT_EQ(at(read_dials(*session.snapshot().kind_brains[0]), Dial::LL), 2);
}

}  // namespace braitenlab::tests::value_commands_test
