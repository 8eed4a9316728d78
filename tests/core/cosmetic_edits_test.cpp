#include "core/world/cosmetic_edits.h"

#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "tests/core/sessions.h"

namespace braitenlab::tests::cosmetic_edits_test {
namespace {

std::optional<maths::vec2> place_of(const Session& session, NodeId node, std::size_t vehicle = 0) {
    const Snapshot& now = session.snapshot();
    return find_node(*now.brains[static_cast<std::size_t>(now.vehicles[vehicle].brain)], node)->place;
}

TEST(CosmeticEdits, OfNodesAreUndoneLikeOtherEdits) {
    Session session = open_session(tests::crowd(4));
    const int kind = session.snapshot().vehicles[0].kind;
    ASSERT_FALSE(session.apply(PlaceNodes{{.vehicle = session.snapshot().vehicles[0].id}, {{1, maths::vec2{5, 6}}}}));
    ASSERT_FALSE(session.apply(PlaceNodes{{.kind = kind}, {{0, maths::vec2{1, 2}}, {99, maths::vec2{}}}}));
    EXPECT_EQ(session.undo_depth(), 2);
    EXPECT_EQ(place_of(session, 0), (maths::vec2{1, 2}));
    EXPECT_EQ(place_of(session, 1), (maths::vec2{5, 6})) << "the position in the brain of the vehicle is kept";
    EXPECT_EQ(session.edited_scene().kinds[static_cast<std::size_t>(kind)].brain.nodes[0].place, (maths::vec2{1, 2}));
    session.undo();
    EXPECT_EQ(place_of(session, 0), std::nullopt);
    EXPECT_EQ(place_of(session, 1), (maths::vec2{5, 6}));
    session.undo();
    EXPECT_EQ(place_of(session, 1), std::nullopt);
    session.redo(), session.redo();
    EXPECT_EQ(place_of(session, 0), (maths::vec2{1, 2}));
    session.reset();
    EXPECT_EQ(place_of(session, 0), (maths::vec2{1, 2})) << "a reset keeps it like every edit";
}

TEST(CosmeticEdits, OutsideTheCanvasAndForAMissingVehicleAreRefused) {
    Session session = open_session(tests::crowd(2));
    EXPECT_TRUE(session.apply(PlaceNodes{{.kind = 0}, {{0, maths::vec2{0, 100001}}}}));
    EXPECT_TRUE(session.apply(PlaceNodes{{.kind = 0}, {{0, maths::vec2{std::nanf(""), 0}}}}));
    EXPECT_TRUE(session.apply(PlaceNodes{{.kind = 99}, {}}));
    EXPECT_TRUE(session.apply(PlaceNodes{{.vehicle = 99}, {}}));
    EXPECT_EQ(session.undo_depth(), 0);
}

TEST(CosmeticEdits, OfNodesDoNotChangeTheRun) {
    Scene scene = furnished();
    scene.kinds[0].brain.nodes.push_back({.id = 9, .name = "N", .time_constant = 2});
    scene.kinds[0].brain.wires.push_back({.from = 0, .to = 9});
    Session plain = open_session(scene), moved = open_session(scene);
    const auto run = [&](int ticks) {
        for (int i = 0; i < ticks; ++i) plain.step(), moved.step();
    };
    run(140);
    const auto neurons = moved.snapshot().neurons;
    for (std::size_t i = 0; i < 2 * keyframe_commands; ++i)
        ASSERT_FALSE(moved.apply(PlaceNodes{{.kind = 0}, {{9, maths::vec2{static_cast<float>(i), 3}}}}));
    EXPECT_EQ(moved.hash(), plain.hash());
    EXPECT_EQ(moved.snapshot().neurons.size(), neurons.size());
    for (Session* session : {&plain, &moved}) ASSERT_FALSE(session->apply(TurnDial{{.kind = 0}, Dial::LL, 1}));
    EXPECT_EQ(moved.bookmark().checkpoint.keyframe_tick, 0u) << "the edits make no keyframe: the world is not rebuilt";
    run(500);
    EXPECT_EQ(moved.hash(), plain.hash());
    moved.seek(200);
    EXPECT_EQ(place_of(moved, 9), (maths::vec2{2 * keyframe_commands - 1, 3}));
}

TEST(CosmeticEdits, InThePastKeepTheRecordedFuture) {
    Session session = open_session(furnished());
    for (int i = 0; i < 500; ++i) session.step();
    BrainGraph rewired = *session.snapshot().kind_brains[0];
    rewired.wires[0].weight = -1;
    ASSERT_FALSE(session.apply(SetBrain{{.kind = 0}, rewired}));
    for (int i = 500; i < 700; ++i) session.step();
    const auto hash = session.hash();
    session.seek(350);
    const PlaceNodes move{{.kind = 0}, {{2, maths::vec2{70, 80}}}};
    ASSERT_FALSE(session.apply(move));
    EXPECT_EQ(session.latest(), 700u);
    EXPECT_FALSE(session.undo_brings_time_back());
    while (session.snapshot().tick < 700) {
        session.step();
        ASSERT_EQ(place_of(session, 2), (maths::vec2{70, 80})) << session.snapshot().tick;
    }
    EXPECT_EQ(session.hash(), hash);
    EXPECT_EQ(session.undo_depth(), 2);
    session.seek(340);
    EXPECT_EQ(place_of(session, 2), std::nullopt);
    EXPECT_EQ(session.undo_depth(), 0);
    session.seek(650);
    EXPECT_EQ(place_of(session, 2), (maths::vec2{70, 80})) << "later keyframes have it too";
    session.seek(350);
    EXPECT_EQ(session.undo_depth(), 1);
    session.undo();
    EXPECT_EQ(place_of(session, 2), std::nullopt);
    session.seek(700);
    EXPECT_EQ(session.hash(), hash);
    EXPECT_EQ(place_of(session, 2), std::nullopt);
    EXPECT_EQ(session.undo_depth(), 1);
    session.seek(350);
    session.redo();
    session.seek(700);
    EXPECT_EQ(place_of(session, 2), (maths::vec2{70, 80}));
    EXPECT_EQ(session.undo_depth(), 2);
}

TEST(CosmeticEdits, OfATitleInThePastKeepTheRecordedFuture) {
    Session session = open_session(furnished());
    for (int i = 0; i < 650; ++i) session.step();
    const auto hash = session.hash();
    session.seek(310);
    ASSERT_FALSE(session.apply(Retitle{"renamed"}));
    EXPECT_EQ(session.latest(), 650u);
    EXPECT_FALSE(session.undo_brings_time_back());
    while (session.snapshot().tick < 650) {
        session.step();
        ASSERT_EQ(session.snapshot().scene->title, "renamed") << session.snapshot().tick;
    }
    EXPECT_EQ(session.hash(), hash);
    session.seek(620);
    EXPECT_EQ(session.snapshot().scene->title, "renamed");
    EXPECT_TRUE(session.undo());
    EXPECT_NE(session.snapshot().scene->title, "renamed");
    EXPECT_EQ(session.latest(), 650u);
}

TEST(CosmeticEdits, OfATitleInThePastReplaceALaterTitle) {
    Session session = open_session(furnished());
    for (int i = 0; i < 100; ++i) session.step();
    ASSERT_FALSE(session.apply(Retitle{"later"}));
    for (int i = 0; i < 100; ++i) session.step();
    session.seek(50);
    ASSERT_FALSE(session.apply(Retitle{"renamed"}));
    session.seek(200);
    EXPECT_EQ(session.snapshot().scene->title, "renamed");
}

TEST(CosmeticEdits, OfAStoryKeepTheTitleAndTheRecordedFuture) {
    Session session = open_session(furnished());
    const auto texts = [&] { return Retitle{session.snapshot().scene->title, session.snapshot().scene->story}; };
    const Retitle first = texts();
    for (int i = 0; i < 650; ++i) session.step();
    const auto hash = session.hash();
    session.seek(310);
    ASSERT_FALSE(session.apply(Retitle{.story = "It turns."}));
    const Retitle told{first.title, "It turns."};
    EXPECT_EQ(texts(), told);
    EXPECT_EQ(session.latest(), 650u);
    session.seek(650);
    EXPECT_EQ(texts(), told);
    EXPECT_EQ(session.hash(), hash);
    EXPECT_TRUE(session.undo());
    EXPECT_EQ(texts(), first);
    EXPECT_TRUE(session.redo());
    EXPECT_EQ(texts(), told);
}

TEST(CosmeticEdits, OfAStoryInThePastReplaceALaterStoryButNoLaterTitle) {
    Session session = open_session(furnished());
    for (int i = 0; i < 100; ++i) session.step();
    ASSERT_FALSE(session.apply(Retitle{"later", "Later."}));
    for (int i = 0; i < 10; ++i) session.step();
    session.seek(50);
    ASSERT_FALSE(session.apply(Retitle{.story = "It turns."}));
    session.seek(110);
    EXPECT_EQ(session.snapshot().scene->story, "It turns.");
    EXPECT_EQ(session.snapshot().scene->title, "later");
}

TEST(CosmeticEdits, OfTitleAndStoryInOneGestureAreUndoneTogether) {
    Session session = open_session(furnished());
    const Scene before = *session.snapshot().scene;
    ASSERT_FALSE(session.apply(Retitle{"renamed"}, 7));
    ASSERT_FALSE(session.apply(Retitle{.story = "It turns."}, 7));
    EXPECT_TRUE(session.undo());
    EXPECT_EQ(*session.snapshot().scene, before);
    EXPECT_TRUE(session.redo());
    EXPECT_EQ(session.snapshot().scene->title, "renamed");
    EXPECT_EQ(session.snapshot().scene->story, "It turns.");
}

}  // namespace
}  // namespace braitenlab::tests::cosmetic_edits_test
