#include "core/session/undo.h"

#include <gtest/gtest.h>

#include "tests/core/sessions.h"

namespace braitenlab::tests::undo_test {
namespace {

TEST(Undo, RevertsAWholeDragInOneStep) {
    Session session = open_session(tests::crowd(4));
    for (const float value : {0.1f, 0.4f, 0.9f}) ASSERT_FALSE(session.apply(TurnDial{{.kind = 0}, Dial::LL, value}, 5));
    EXPECT_EQ(session.undo_depth(), 1);
    EXPECT_TRUE(session.undo());
    EXPECT_EQ(dial(session, Dial::LL), 0);
    EXPECT_TRUE(session.redo());
    EXPECT_EQ(dial(session, Dial::LL), 0.9f);
    EXPECT_FALSE(session.redo());
}

TEST(Undo, HasNoStepForADragThatEndsWhereItBegan) {
    Session session = open_session(tests::crowd(4));
    for (const float value : {0.5f, 1.0f, 0.0f}) ASSERT_FALSE(session.apply(TurnDial{{.kind = 0}, Dial::LL, value}, 5));
    EXPECT_EQ(session.undo_depth(), 0);
    ASSERT_FALSE(session.apply(TurnDial{{.kind = 0}, Dial::LL, 0.25f}, 5)) << "the gesture may continue";
    EXPECT_EQ(session.undo_depth(), 1);
    session.undo();
    EXPECT_EQ(dial(session, Dial::LL), 0);
}

TEST(Undo, HasNoStepForADragOfSeveralObjectsThatAllEndWhereTheyBegan) {
    Session session = open_session(furnished());
    const Source lamp = session.snapshot().scene->sources[0], stove = session.snapshot().scene->sources[1];
    const Zone pond = session.snapshot().scene->zones[0];
    for (const float by : {1.0f, 2.0f, 0.0f}) {
        ASSERT_FALSE(session.apply(MoveSource{0, lamp.x + by, lamp.y}, 5));
        ASSERT_FALSE(session.apply(MoveSource{1, stove.x + by, stove.y}, 5));
        EXPECT_EQ(session.undo_depth(), 1) << "the zone or a source is elsewhere";
        ASSERT_FALSE(session.apply(MoveZone{0, pond.x + by, pond.y, pond.heading}, 5));
        EXPECT_EQ(session.undo_depth(), by == 0 ? 0 : 1);
    }
}

TEST(Undo, RestoresTheBrainOfEachVehicle) {
    Session session = open_session(tests::crowd(4));
    const VehicleId own = session.snapshot().vehicles[0].id;
    ASSERT_FALSE(session.apply(TurnDial{{.vehicle = own}, Dial::LL, -1}));
    ASSERT_FALSE(session.apply(TurnDial{{.kind = 0}, Dial::LL, 2}));
    EXPECT_EQ(dial(session, Dial::LL, 0), 2);
    session.undo();
    EXPECT_EQ(dial(session, Dial::LL, 0), -1);
    EXPECT_EQ(dial(session, Dial::LL, 2), 0);
}

// Two vehicles in a row: the rear one drives ahead, the front one stands.
Scene rear_and_front() {
    Scene scene = tests::crowd(0);
    scene.kinds.resize(1);
    scene.kinds[0].brain = make_graph({});
    scene.starts = {{.name = "rear", .kind = scene.kinds[0].name, .x = -3},
                    {.name = "front", .kind = scene.kinds[0].name}};
    return scene;
}

TEST(Undo, PutsARemovedVehicleBesideOneThatHasMovedToItsPose) {
    Session session = open_session(rear_and_front());
    ASSERT_FALSE(session.apply(RemoveVehicle{1}));
    ASSERT_FALSE(session.apply(TurnDial{{.vehicle = 0}, Dial::LM, 1}));
    ASSERT_FALSE(session.apply(TurnDial{{.vehicle = 0}, Dial::RM, 1}));
    for (int i = 0; i < 600 && session.snapshot().vehicles[0].x < -0.1f; ++i) session.step();
    ASSERT_GE(session.snapshot().vehicles[0].x, -0.1f) << "it is where the other one was";
    const Bookmark before = session.bookmark();
    for (int i = 0; i < 3; ++i) session.undo();
    const auto apart = [&] {
        const auto& v = session.snapshot().vehicles;
        return maths::distance(maths::vec2{v[0].x, v[0].y}, maths::vec2{v[1].x, v[1].y});
    };
    ASSERT_EQ(session.snapshot().vehicles.size(), 2u);
    EXPECT_GT(apart(), 0.6f);
    EXPECT_LT(apart(), 3.0f) << "the nearest free pose";
    const VehicleView restored = session.snapshot().vehicles[1];
    EXPECT_EQ(restored.heading, 0);
    const auto hash = session.hash();
    EXPECT_EQ(World::restore(session.save().checkpoint).hash(), hash);
    session.go_to(before);
    for (int i = 0; i < 3; ++i) session.undo();
    EXPECT_EQ(session.hash(), hash) << "the same pose each time";
}

TEST(Undo, PutsARemovedVehicleBackToItsPoseIfThatIsFree) {
    Session session = open_session(rear_and_front());
    ASSERT_FALSE(session.apply(RemoveVehicle{1}));
    for (int i = 0; i < 60; ++i) session.step();
    session.undo();
    const VehicleView& restored = session.snapshot().vehicles[1];
    EXPECT_EQ(restored.x, 0);
    EXPECT_EQ(restored.y, 0);
    ASSERT_FALSE(session.apply(MoveVehicle{0, -0.3f, 0.1f, 0}));
    ASSERT_FALSE(session.apply(RemoveVehicle{1}));
    session.undo();
    EXPECT_EQ(session.snapshot().vehicles[1].x, 0) << "in the state of the edit the undo is exact, overlap included";
}

TEST(Undo, DoesNotChangeTheDriver) {
    Session session = open_session(tests::crowd(4));
    ASSERT_FALSE(session.apply(ChooseDriver{0, Driver::manual}));
    ASSERT_FALSE(session.apply(TurnDial{{.kind = 0}, Dial::LL, 2}));
    ASSERT_FALSE(session.apply(ChooseDriver{0, Driver::brain}));
    EXPECT_EQ(session.undo_depth(), 1);
    session.undo();
    EXPECT_EQ(dial(session, Dial::LL), 0);
    EXPECT_EQ(session.snapshot().vehicles[0].driver, Driver::brain);
}

TEST(Undo, DoesNotChangeTheTime) {
    Session session = open_session(tests::crowd(4));
    session.apply(TurnDial{{.kind = 0}, Dial::LL, 2});
    for (int i = 0; i < 10; ++i) session.step();
    session.undo();
    EXPECT_EQ(session.snapshot().tick, 10u);
}

TEST(Undo, OfAMoveRestoresThePose) {
    Session session = open_session(tests::alone({}, 1, 2, 0.5f));
    ASSERT_FALSE(session.apply(MoveVehicle{0, 5, 6, 1}));
    session.undo();
    EXPECT_FLOAT_EQ(session.snapshot().vehicles[0].x, 1);
    EXPECT_FLOAT_EQ(session.snapshot().vehicles[0].heading, 0.5f);
}

TEST(Undo, OfAStartMovedInOneGestureRestoresPoseAndStart) {
    Session session = open_session(tests::alone({}, 1, 2, 0.5f));
    const Start before = session.snapshot().scene->starts[0];
    Start after = before;
    after.x = 5, after.y = 6, after.heading = 1;
    for (const float x : {3.0f, 4.0f, 5.0f}) ASSERT_FALSE(session.apply(MoveVehicle{0, x, 6, 1}, 7));
    ASSERT_FALSE(session.apply(EditStart{0, after}, 7));
    EXPECT_EQ(session.undo_depth(), 1);
    session.reset();
    EXPECT_FLOAT_EQ(session.snapshot().vehicles[0].x, 5) << "a new run begins at this position";
    session.undo();
    EXPECT_EQ(session.snapshot().scene->starts[0], before);
    EXPECT_FLOAT_EQ(session.snapshot().vehicles[0].x, 1);
    session.redo();
    EXPECT_EQ(session.snapshot().scene->starts[0], after);
    EXPECT_FLOAT_EQ(session.snapshot().vehicles[0].x, 5);
}

TEST(Undo, DropsRedoStepsOnANewEdit) {
    Session session = open_session(tests::crowd(2));
    session.apply(TurnDial{{.kind = 0}, Dial::LL, 1});
    session.undo();
    session.apply(TurnDial{{.kind = 0}, Dial::LL, 2});
    EXPECT_EQ(session.redo_depth(), 0);
}

// The edited state of the scene and the poses, without the values that only time changes.
void expect_same(const Session& session, const Scene& scene, const Snapshot& then) {
    EXPECT_EQ(session.edited_scene(), scene);
    const Snapshot& now = session.snapshot();
    ASSERT_EQ(now.vehicles.size(), then.vehicles.size());
    for (std::size_t i = 0; i < then.vehicles.size(); ++i) {
        const VehicleView &a = now.vehicles[i], &b = then.vehicles[i];
        EXPECT_EQ(a.id, b.id);
        EXPECT_EQ(a.kind, b.kind);
        EXPECT_EQ(a.start, b.start);
        EXPECT_EQ(a.driver, b.driver);
        EXPECT_EQ(a.energy, b.energy);
        EXPECT_NEAR(a.x, b.x, 1e-5);
        EXPECT_NEAR(a.y, b.y, 1e-5);
        EXPECT_NEAR(a.heading, b.heading, 1e-5);
        EXPECT_EQ(*now.brains[static_cast<std::size_t>(a.brain)], *then.brains[static_cast<std::size_t>(b.brain)]);
        EXPECT_EQ(kind_of(now, a).sensors, kind_of(then, b).sensors);
    }
    for (std::size_t i = 0; i < then.obstacles.size(); ++i) EXPECT_EQ(now.obstacles[i], then.obstacles[i]);
}

TEST(Undo, RevertsAndRepeatsEveryCommand) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Session session = open_session(furnished());
        maths::Random chance{seed, 4};
        for (int i = 0; i < 40; ++i) session.step();
        const Scene scene = session.edited_scene();
        const Snapshot before = session.snapshot();
        for (int i = 0; i < 25; ++i) (void)session.apply(any_edit(session, chance));
        ASSERT_GT(session.undo_depth(), 10);
        const Scene edited = session.edited_scene();
        const Snapshot after = session.snapshot();
        while (session.undo()) {
        }
        expect_same(session, scene, before);
        while (session.redo()) {
        }
        expect_same(session, edited, after);
    }
}

TEST(Undo, LeavesOutCommandsForVehiclesThatHaveDiedWithoutAnError) {
    Scene scene = tests::alone({});
    scene.ecology.drain = 1;
    Session session = open_session(scene);
    ASSERT_FALSE(session.apply(TurnDial{{.vehicle = 0}, Dial::LL, 1.5f}));
    for (int i = 0; i < 70; ++i) session.step();
    ASSERT_FALSE(find_vehicle(session.snapshot(), 0));
    const UndoResult undone = session.undo(), redone = session.redo();
    EXPECT_TRUE(undone.done && redone.done);
    EXPECT_FALSE(undone.error) << undone.error->text();
    EXPECT_FALSE(redone.error);
}

TEST(Undo, OfAPopulationRestoresItAfterAResetThatRenumbersItsVehicles) {
    Session session = open_session(tests::crowd(4));
    ASSERT_FALSE(session.apply(AddVehicle{0, Pose{3, -2, 1}}));
    ASSERT_FALSE(session.apply(SetPopulation{0, 5}));
    session.reset();
    ASSERT_EQ(session.snapshot().vehicles.front().start, 0) << "the vehicle with a start has the smallest id now";
    EXPECT_TRUE(session.undo());
    EXPECT_EQ(count_of(session, 0), 3);
    EXPECT_EQ(count_of(session, 1), 2);
}

TEST(Undo, OfMovedObjectsRestoresAllThatAreStillThere) {
    Session session = open_session(furnished());
    const Snapshot before = session.snapshot();
    const VehicleId gone = before.vehicles[2].id, stays = before.vehicles[3].id;
    const MoveObjects drag{{{gone, 3, 1, 0}, {stays, -3, 1, 0}}, {{0, 2, 2}}, {{0, 1, -1, 0}}, {{0, 0, 3, 1}}};
    ASSERT_FALSE(session.apply(drag, 9));
    MoveObjects later = drag;
    later.of_sources[0].x = -2;
    ASSERT_FALSE(session.apply(later, 9));
    EXPECT_EQ(session.undo_depth(), 1);
    const Snapshot& now = session.snapshot();
    EXPECT_EQ(now.sources[0].x, -2);
    EXPECT_EQ(now.obstacles[0].y, -1);
    EXPECT_EQ(now.scene->zones[0].y, 3);
    EXPECT_EQ(find_vehicle(now, stays)->x, -3);
    EXPECT_TRUE(session.apply(MoveObjects{{{stays, 9, 9, 0}}, {{7, 0, 0}}})) << "there is no such source";
    EXPECT_EQ(find_vehicle(now, stays)->x, -3) << "nothing is moved then";
    session.undo();
    EXPECT_EQ(now.sources[0].x, before.sources[0].x);
    EXPECT_EQ(now.obstacles[0].y, before.obstacles[0].y);
    EXPECT_EQ(now.scene->zones[0].y, before.scene->zones[0].y);
    EXPECT_EQ(find_vehicle(now, stays)->x, before.vehicles[3].x);
    ASSERT_TRUE(session.redo());
    ASSERT_FALSE(session.apply(RemoveVehicle{gone}));
    session.undo();
    EXPECT_TRUE(find_vehicle(now, gone));
}

}  // namespace
}  // namespace braitenlab::tests::undo_test
