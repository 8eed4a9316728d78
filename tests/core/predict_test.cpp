// Predictions of a vehicle's path on a copy of the run.
#include "core/insight/predict.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "core/scene/scene_file.h"
#include "core/session/session.h"
#include "tests/core/runs.h"
#include "tests/core/scenes.h"
#include "tests/core/sessions.h"

namespace braitenlab::tests::predict_test {
namespace {

using insight::Path;
using insight::Question;

constexpr std::size_t eight_seconds = 480;

Path driven(Session& session, VehicleId vehicle, std::size_t ticks) {
    Path path;
    const auto add = [&] {
        const VehicleView* now = find_vehicle(session.snapshot(), vehicle);
        if (now) path.push_back({now->x, now->y, now->heading});
        return now != nullptr;
    };
    while (add() && path.size() <= ticks) session.step();
    return path;
}

Question now_of(const Session& session, VehicleId vehicle, std::size_t ticks = eight_seconds) {
    return {.from = session.bookmark().checkpoint, .vehicle = vehicle, .ticks = ticks};
}

Scene with_lamp() {
    Scene scene = alone({.LR = 0.8f, .RL = 0.8f, .LM = 0.3f, .RM = 0.3f});
    scene.sources = {{.name = "lamp", .x = 5, .y = 2}};
    return scene;
}

// At a tick between two keyframes, after an edit: contacts since the keyframe must not change a bit.
TEST(Predict, OfEveryShippedSceneIsThePathThatIsDriven) {
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(BRAITENLAB_SOURCE) / "exercises/scenes")) {
        Session session = open_session(*load_scene(entry.path()), 1);
        if (session.snapshot().vehicles.empty()) continue;
        for (int tick = 0; tick < 410; ++tick) session.step();
        const VehicleView first = session.snapshot().vehicles.front();
        EXPECT_FALSE(session.apply(TurnDial{{.vehicle = first.id}, Dial::LM, 0.4f}));
        const Path predicted = insight::predict(now_of(session, first.id));
        EXPECT_EQ(predicted, driven(session, first.id, eight_seconds)) << entry.path();
    }
}

TEST(Predict, HasTheChangesOfTheQuestionAndLeavesTheRunAsItIs) {
    Session session = open_session(with_lamp());
    for (int tick = 0; tick < 100; ++tick) session.step();
    const std::uint64_t hash = session.hash();
    Question question = now_of(session, 0);
    const Path unchanged = insight::predict(question);
    question.changes = {TurnDial{{.vehicle = 0}, Dial::LM, -0.5f}, MoveSource{0, -5, 2}};
    const Path changed = insight::predict(question);
    EXPECT_EQ(session.hash(), hash);
    EXPECT_EQ(changed.front(), unchanged.front());
    EXPECT_NE(changed.back(), unchanged.back());
    for (const Command& change : question.changes) EXPECT_FALSE(session.apply(change));
    EXPECT_EQ(changed, driven(session, 0, eight_seconds));
}

TEST(Predict, IsTheSameInPiecesOfAnySize) {
    Session session = open_session(with_lamp());
    for (int tick = 0; tick < 50; ++tick) session.step();
    EXPECT_FALSE(session.apply(TurnDial{{.vehicle = 0}, Dial::LL, 0.4f}));
    const Question question = now_of(session, 0, 90);
    const Path whole = insight::predict(question);
    ASSERT_EQ(whole.size(), 91u);
    insight::Prediction pieces(question);
    int calls = 1;
    for (float before = -1; !pieces.advance(7); ++calls) {
        EXPECT_GT(pieces.progress(), before);
        before = pieces.progress();
    }
    EXPECT_EQ(pieces.progress(), 1);
    EXPECT_EQ(pieces.path(), whole);
    EXPECT_EQ(calls, 21) << "50 ticks, the edit, the beginning and 90 ticks in pieces of 7";
}

TEST(Predict, EndsWhereTheVehicleLeavesTheWorld) {
    Scene scene = with_lamp();
    Session session = open_session(scene);
    EXPECT_FALSE(session.apply(RemoveVehicle{0}));
    EXPECT_TRUE(insight::predict(now_of(session, 0)).empty());
}

TEST(Predict, WithOtherChanceDiffersOnlyWhereThereIsNoise) {
    for (const float noise : {0.0f, 0.1f}) {
        Scene scene = with_lamp();
        for (Sensor& sensor : scene.kinds[0].sensors) sensor.noise = noise;
        Session session = open_session(scene);
        for (int tick = 0; tick < 30; ++tick) session.step();
        const Question question = now_of(session, 0);
        const Path run = insight::predict(question);
        EXPECT_EQ(insight::depends_on_chance(session.snapshot()), noise > 0);
        EXPECT_EQ(insight::predict(insight::with_other_chance(question, 1)) != run, noise > 0);
        EXPECT_EQ(run, driven(session, 0, eight_seconds));
    }
    Scene scene = with_lamp();
    for (Sensor& sensor : scene.kinds[0].sensors) sensor.channel = Channel::random;
    Session session = open_session(scene);
    const Question question = now_of(session, 0);
    EXPECT_TRUE(insight::depends_on_chance(session.snapshot()));
    EXPECT_NE(insight::predict(insight::with_other_chance(question, 1)), insight::predict(question));
    EXPECT_EQ(insight::predict(question), driven(session, 0, eight_seconds));
}

}  // namespace
}  // namespace braitenlab::tests::predict_test
