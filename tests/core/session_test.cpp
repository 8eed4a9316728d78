#include "core/session/session.h"

#include <gtest/gtest.h>

#include "tests/core/scenes.h"

namespace braitenlab {
namespace {

Session open(const Scene& scene) {
    auto session = Session::open(scene, 3);
    EXPECT_TRUE(session);
    return std::move(*session);
}

float dial(const Session& session, Dial which, std::size_t vehicle = 0) {
    const Snapshot& now = session.snapshot();
    return at(read_dials(*now.brains[static_cast<std::size_t>(now.vehicles[vehicle].brain)]), which);
}

TEST(Undo, TakesAWholeDragBackInOneStep) {
    Session session = open(tests::crowd(4));
    for (const float value : {0.1f, 0.4f, 0.9f}) ASSERT_FALSE(session.apply(TurnDial{{.kind = 0}, Dial::LL, value}, 5));
    EXPECT_EQ(session.undo_depth(), 1);
    EXPECT_TRUE(session.undo());
    EXPECT_EQ(dial(session, Dial::LL), 0);
    EXPECT_TRUE(session.redo());
    EXPECT_EQ(dial(session, Dial::LL), 0.9f);
    EXPECT_FALSE(session.redo());
}

TEST(Undo, KnowsNoStepForADragThatEndedWhereItBegan) {
    Session session = open(tests::crowd(4));
    for (const float value : {0.5f, 1.0f, 0.0f}) ASSERT_FALSE(session.apply(TurnDial{{.kind = 0}, Dial::LL, value}, 5));
    EXPECT_EQ(session.undo_depth(), 0);
    ASSERT_FALSE(session.apply(TurnDial{{.kind = 0}, Dial::LL, 0.25f}, 5)) << "and it may go on";
    EXPECT_EQ(session.undo_depth(), 1);
    session.undo();
    EXPECT_EQ(dial(session, Dial::LL), 0);
}

TEST(Undo, RestoresEachVehiclesOwnBrain) {
    Session session = open(tests::crowd(4));
    const VehicleId own = session.snapshot().vehicles[0].id;
    ASSERT_FALSE(session.apply(TurnDial{{.vehicle = own}, Dial::LL, -1}));
    ASSERT_FALSE(session.apply(TurnDial{{.kind = 0}, Dial::LL, 2}));
    EXPECT_EQ(dial(session, Dial::LL, 0), 2);
    session.undo();
    EXPECT_EQ(dial(session, Dial::LL, 0), -1);
    EXPECT_EQ(dial(session, Dial::LL, 2), 0);
}

TEST(Undo, LeavesTimeAlone) {
    Session session = open(tests::crowd(4));
    session.apply(TurnDial{{.kind = 0}, Dial::LL, 2});
    for (int i = 0; i < 10; ++i) session.step();
    session.undo();
    EXPECT_EQ(session.snapshot().tick, 10u);
}

TEST(Undo, OfAMoveBringsThePoseBack) {
    Session session = open(tests::alone({}, 1, 2, 0.5f));
    ASSERT_FALSE(session.apply(MoveVehicle{0, 5, 6, 1}));
    session.undo();
    EXPECT_FLOAT_EQ(session.snapshot().vehicles[0].x, 1);
    EXPECT_FLOAT_EQ(session.snapshot().vehicles[0].heading, 0.5f);
}

TEST(Undo, ForgetsTheFutureOnANewEdit) {
    Session session = open(tests::crowd(2));
    session.apply(TurnDial{{.kind = 0}, Dial::LL, 1});
    session.undo();
    session.apply(TurnDial{{.kind = 0}, Dial::LL, 2});
    EXPECT_EQ(session.redo_depth(), 0);
}

TEST(Reset, GivesTheVerySameStartAndKeepsTheEditedBrains) {
    Session session = open(tests::crowd(6)), fresh = open(tests::crowd(6));
    for (int i = 0; i < 300; ++i) session.step();
    session.reset();
    EXPECT_EQ(session.hash(), fresh.hash());

    session.apply(TurnDial{{.kind = 0}, Dial::LL, 1});
    session.apply(TurnDial{{.vehicle = 1}, Dial::RR, -1});
    const auto edited = session.hash();
    for (int i = 0; i < 300; ++i) session.step();
    session.reset();
    EXPECT_EQ(session.hash(), edited);
    EXPECT_EQ(dial(session, Dial::LL), 1);
}

}  // namespace
}  // namespace braitenlab
