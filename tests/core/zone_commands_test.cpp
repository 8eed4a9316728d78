// Commands that edit the zones of a running world.
#include <limits>

#include <gtest/gtest.h>

#include "core/session/session.h"
#include "core/world/world.h"
#include "tests/core/scenes.h"

namespace braitenlab::tests::zone_commands_test {
namespace {

World make(const Scene& scene) {
    auto world = World::create(scene, 1);
    EXPECT_TRUE(world) << world.error().text();
    return std::move(*world);
}

Snapshot captured(const World& world) {
    Snapshot now;
    world.capture(now);
    return now;
}

// A vehicle that moves only if a zone pushes it.
Scene at_rest() {
    Scene scene = tests::alone({});
    scene.arena.friction = 0;
    return scene;
}

const Zone wind{.length = 20, .width = 20, .wind_x = 150};  // N, more than the friction of its wheels

TEST(Command, AnAddedZoneActsFromTheNextTickAndARemovedOneNoLonger) {
    World world = make(at_rest());
    ASSERT_FALSE(world.apply(AddZone{wind}));
    for (int t = 0; t < 30; ++t) world.step();
    const float pushed = captured(world).vehicles[0].x;
    EXPECT_GT(pushed, 0.01f);
    World still = make(at_rest());
    ASSERT_FALSE(still.apply(AddZone{wind}));
    ASSERT_FALSE(still.apply(RemoveZone{0}));
    for (int t = 0; t < 30; ++t) still.step();
    EXPECT_EQ(captured(still).vehicles[0].x, 0);
}

TEST(Command, AMovedOrEditedZoneActsWhereItIsNow) {
    Scene scene = at_rest();
    scene.zones = {wind};
    scene.zones[0].name = "wind";
    World world = make(scene);
    ASSERT_FALSE(world.apply(MoveZone{0, 50, 0, 1}));
    for (int t = 0; t < 30; ++t) world.step();
    EXPECT_EQ(captured(world).vehicles[0].x, 0);
    Zone back = wind;
    back.wind_x = -150;
    ASSERT_FALSE(world.apply(EditZone{0, back}));
    for (int t = 0; t < 30; ++t) world.step();
    EXPECT_LT(captured(world).vehicles[0].x, -0.01f);
    EXPECT_EQ(captured(world).scene->zones[0].name, "wind") << "an edit keeps the name";
}

TEST(Command, GivesAnAddedZoneAFreeNameAtTheRequestedIndex) {
    World world = make(at_rest());
    ASSERT_FALSE(world.apply(AddZone{wind}));
    ASSERT_FALSE(world.apply(AddZone{wind, 0}));
    const auto scene = captured(world).scene;
    ASSERT_EQ(scene->zones.size(), 2u);
    EXPECT_EQ(scene->zones[0].name, "zone-2");
    EXPECT_EQ(scene->zones[1].name, "zone");
}

TEST(Command, RefusesAZoneThatTheSceneDoesNotHaveOrThatIsInvalid) {
    World world = make(at_rest());
    ASSERT_FALSE(world.apply(AddZone{wind}));
    const auto before = captured(world).scene;
    Zone dented = wind;
    dented.corners = {{0, 0}, {1, 1}, {1, 0}};
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const Command& command :
         {Command(RemoveZone{1}), Command(MoveZone{-1}), Command(EditZone{7, wind}), Command(MoveZone{0, nan, 0, 0}),
          Command(EditZone{0, {.length = -1}}), Command(AddZone{dented})})
        EXPECT_TRUE(world.apply(command)) << command.index();
    EXPECT_EQ(*captured(world).scene, *before);
}

TEST(Command, ARunWithZoneCommandsRepeatsFromItsCheckpoint) {
    World world = make(tests::crowd(12));
    for (int t = 0; t < 20; ++t) world.step();
    for (const Command& command : {Command(AddZone{wind}), Command(MoveZone{0, 1, 1, 0.5f}), Command(AddZone{wind, 0}),
                                   Command(EditZone{1, {.surface = Surface::ice}}), Command(RemoveZone{0})}) {
        ASSERT_FALSE(world.apply(command));
        for (int t = 0; t < 10; ++t) world.step();
    }
    World again = World::restore(world.checkpoint());
    EXPECT_EQ(again.hash(), world.hash());
    for (int t = 0; t < 400; ++t) world.step(), again.step();
    EXPECT_EQ(again.hash(), world.hash());
}

TEST(Session, UndoRestoresZonesAndMakesOneStepOfADrag) {
    Scene scene = at_rest();
    scene.zones = {{.name = "a", .x = 1}, {.name = "b", .x = 2, .surface = Surface::sand}};
    Session session = std::move(*Session::open(scene, 1));
    for (int i = 1; i <= 5; ++i) ASSERT_FALSE(session.apply(MoveZone{1, static_cast<float>(i), 3, 1}, 7));
    EXPECT_EQ(session.undo_depth(), 1);
    ASSERT_FALSE(session.apply(EditZone{0, {.pull = 3}}, 8));
    ASSERT_FALSE(session.apply(EditZone{0, {.pull = 4}}, 8));
    EXPECT_EQ(session.undo_depth(), 2);
    ASSERT_FALSE(session.apply(RemoveZone{0}));
    ASSERT_FALSE(session.apply(AddZone{wind, 0}));
    const Scene edited = session.edited_scene();
    while (session.undo()) {
    }
    EXPECT_EQ(session.edited_scene().zones, scene.zones);
    while (session.redo()) {
    }
    EXPECT_EQ(session.edited_scene(), edited);
}

TEST(Session, MakesOneShortStepOfADragOfSeveralObjects) {
    Scene scene = at_rest();
    scene.zones = {{.name = "a", .x = 1}, {.name = "b", .x = 2}};
    scene.sources = {{.name = "lamp", .x = 3}};
    Session session = std::move(*Session::open(scene, 1));
    const auto drag_to = [&](float by) {
        for (const int zone : {0, 1})
            ASSERT_FALSE(session.apply(MoveZone{zone, scene.zones[static_cast<std::size_t>(zone)].x + by, 0, 0}, 5));
        ASSERT_FALSE(session.apply(MoveSource{0, 3 + by, 0}, 5));
    };
    for (int i = 1; i <= 50; ++i) drag_to(0.1f * static_cast<float>(i));
    ASSERT_EQ(session.undo_depth(), 1);
    const Bookmark bookmark = session.bookmark();
    EXPECT_EQ(bookmark.edits.done[0]->again.size(), 3u) << "one command of each object";
    EXPECT_EQ(bookmark.edits.done[0]->back.size(), 3u);
    session.undo();
    EXPECT_EQ(session.edited_scene(), scene);
    session.redo();
    EXPECT_FLOAT_EQ(session.edited_scene().zones[1].x, 7);
    session.undo();
    drag_to(1);
    drag_to(0);
    EXPECT_EQ(session.undo_depth(), 0) << "all objects are back where the drag began";
}

}  // namespace
}  // namespace braitenlab::tests::zone_commands_test
