#include <cmath>

#include <gtest/gtest.h>

#include "core/scene/arena.h"
#include "render/view/pick.h"
#include "ui/lab_view.h"
#include "ui/scene_input/clipboard.h"
#include "ui/scene_input/edits.h"
#include "ui/scene_input/under_pointer.h"

namespace braitenlab::tests::stage_room_test {

using namespace ui;
namespace {

using maths::vec2;

// An arena of 10 by 8 m with a wall, a lamp in its middle and a box to the right.
struct SceneInputEdits : testing::Test {
    std::shared_ptr<Scene> scene = std::make_shared<Scene>();
    Snapshot now;

    SceneInputEdits() {
        scene->arena = {.width = 10, .height = 8};
        scene->kinds.resize(1);
        scene->sources.resize(1);
        scene->obstacles = {{.name = "box", .x = 3, .y = 0, .length = 1, .width = 2}};
        now.scene = scene;
        now.sources = {{.source = 0}};
    }
    void stand(float x, float y) {
        VehicleView vehicle;
        vehicle.id = static_cast<int>(now.vehicles.size());
        vehicle.x = x, vehicle.y = y;
        now.vehicles.push_back(vehicle);
    }
    float reach() const { return std::hypot(scene->kinds[0].body.length, scene->kinds[0].body.width) / 2; }
};

TEST_F(SceneInputEdits, AddsRemovesMovesAndCopiesAZone) {
    scene->zones = {{.name = "pond", .x = 1, .heading = 0.5f, .length = 2, .surface = Surface::ice}};
    const SceneObject pond{SceneObjectKind::zone, 0};
    EXPECT_EQ(removal_of(now, pond), Command(RemoveZone{0}));
    EXPECT_EQ(move_of(now, pond, {9, 1, 2}), Command(MoveZone{0, 5, 1, 2})) << "clamped to the arena";
    const auto copy = copy_of(now, pond);
    ASSERT_TRUE(copy);
    const Zone& zone = std::get<AddZone>(*copy).object;
    EXPECT_EQ(zone.surface, Surface::ice);
    EXPECT_EQ(zone.heading, 0.5f);
    EXPECT_NE(zone.x, 1);
    EXPECT_EQ(added_by(now, *copy), pond) << "the last one of a snapshot captured after it";
    EXPECT_EQ(with_room(now, AddZone{{.x = 3}}), Command(AddZone{{.x = 3}})) << "a zone may lie below an obstacle";
    EXPECT_FALSE(removal_of(now, {SceneObjectKind::zone, 1}));
}

TEST_F(SceneInputEdits, RemovesSeveralObjectsFromTheLastIndexOn) {
    scene->zones.resize(3);
    const auto zone = [](int index) { return SceneObject{SceneObjectKind::zone, index}; };
    const std::vector<Command> removals =
        removals_of(now, {zone(0), {SceneObjectKind::source, 0}, zone(2), zone(5), zone(1)});
    const std::vector<Command> wanted{RemoveZone{2}, RemoveZone{1}};
    ASSERT_EQ(removals.size(), 4u) << "one zone does not exist";
    EXPECT_EQ(removals[0], wanted[0]);
    EXPECT_EQ(removals[1], wanted[1]);
    EXPECT_EQ(std::count(removals.begin(), removals.end(), Command(RemoveSource{0})), 1);
}

TEST_F(SceneInputEdits, KeepsAFreePosition) {
    const vec2 at = free_place(now, {-3, 2}, 0.6f);
    EXPECT_EQ(at.x, -3);
    EXPECT_EQ(at.y, 2);
}

TEST_F(SceneInputEdits, KeepsAddedObjectsOffTheWalls) {
    for (const vec2 wanted : {vec2{9, 9}, vec2{-5, 0.5f}, vec2{0, -30}, vec2{4.9f, 3.9f}}) {
        const vec2 at = free_place(now, wanted, 0.6f);
        EXPECT_LE(std::fabs(at.x), 4.4f + 1e-4f);
        EXPECT_LE(std::fabs(at.y), 3.4f + 1e-4f);
    }
    scene->arena.edge = Boundary::torus;
    EXPECT_EQ(free_place(now, {5, 3}, 0.6f).x, 5) << "a position on a joined edge is free";
}

TEST_F(SceneInputEdits, KeepsObjectsInARoundArena) {
    scene->arena.round = true;
    const auto moved = std::get<MoveSource>(*move_of(now, {SceneObjectKind::source, 0}, {4.9f, 3.9f, 0}));
    EXPECT_TRUE(is_inside(scene->arena, {moved.x, moved.y}));
    EXPECT_FALSE(is_inside(scene->arena, {moved.x, moved.y}, 0.05f)) << "at the edge";
    EXPECT_TRUE(is_inside(scene->arena, free_place(now, {-4.5f, 3.5f}, 0.6f), 0.6f));
    LabView view{.now = &now};
    EXPECT_TRUE(is_inside(scene->arena, in_arena(view, {-9, 9})));
    EXPECT_EQ(in_arena(view, {1, 2}), (vec2{1, 2}));
    Scene copy;
    copy.sources.push_back({.x = 0, .y = 0});
    const std::vector<Command> commands = pasted(now, copy, vec2{4.9f, -3.9f});
    const Source& source = std::get<AddSource>(commands.at(0)).object;
    EXPECT_TRUE(is_inside(scene->arena, {source.x, source.y}));
}

TEST_F(SceneInputEdits, MovesAsideFromOtherObjectsAsLittleAsNecessary) {
    stand(-3, 2);
    const float both = 0.6f + reach();
    const vec2 at = free_place(now, {-3, 2.1f}, 0.6f);
    const float away = maths::distance(at, {-3, 2});
    EXPECT_GE(away, both - 1e-4f);
    EXPECT_LE(away, both + 0.25f);
    const vec2 beside_lamp = free_place(now, {0, 0}, 0.6f);
    EXPECT_GE(maths::length(beside_lamp), 0.9f - 1e-4f);
    EXPECT_LE(maths::length(beside_lamp), 1.15f);
    const vec2 beside_box = free_place(now, {3, 0}, 0.6f);
    EXPECT_LE(beside_box.x, 3 - 0.5f - 0.6f + 1e-4f);
}

TEST_F(SceneInputEdits, UsesTheGivenPositionInAFullArena) {
    scene->obstacles[0] = {.name = "box", .length = 30, .width = 30};
    const vec2 at = free_place(now, {9, 1}, 0.6f);
    EXPECT_NEAR(at.x, 4.4f, 1e-4f);
    EXPECT_NEAR(at.y, 1, 1e-4f);
}

TEST_F(SceneInputEdits, FindsAPositionOnlyForAddedObjects) {
    stand(-3, 2);
    const auto vehicle = std::get<AddVehicle>(with_room(now, AddVehicle{0, Pose{-3, 2, 1}}));
    EXPECT_GE(maths::distance(vec2{vehicle.at->x, vehicle.at->y}, vec2{-3, 2}), 2 * reach() - 1e-4f);
    EXPECT_EQ(vehicle.at->heading, 1);
    const auto lamp = std::get<AddSource>(with_room(now, AddSource{{.x = 8, .y = 1}}));
    EXPECT_LT(lamp.object.x, 5);
    const auto box = std::get<AddObstacle>(with_room(now, AddObstacle{{.x = 3.2f, .y = 0.2f}}));
    EXPECT_GE(maths::distance(vec2{box.object.x, box.object.y}, vec2{3, 0}), 0.99f);
    EXPECT_EQ(with_room(now, Command(AddVehicle{})), Command(AddVehicle{})) << "the world chooses a free position";
    const Command move = MoveVehicle{0, 3, 0, 0};
    EXPECT_EQ(with_room(now, move), move) << "a move keeps the position of the user";
}

}  // namespace
}  // namespace braitenlab::tests::stage_room_test
