// Two brains from the same start.
#include "core/insight/compare.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/session/session.h"
#include "tests/core/scenes.h"
#include "tests/core/sessions.h"

namespace braitenlab::tests::compare_test {
namespace {

using insight::CompareMeasure;
using insight::Design;

constexpr FourNeurons seeks{.LR = 0.8f, .RL = 0.8f, .LM = 0.3f, .RM = 0.3f};
constexpr FourNeurons flees{.LL = 0.8f, .RR = 0.8f, .LM = 0.3f, .RM = 0.3f};

// A noisy vehicle that sees a lamp.
Scene with_lamp(float lamp_x = 5, float lamp_y = 2) {
    Scene scene = alone(seeks);
    scene.sources = {{.name = "lamp", .x = lamp_x, .y = lamp_y}};
    for (Sensor& sensor : scene.kinds[0].sensors) sensor.noise = 0.05f;
    return scene;
}

insight::CompareQuestion start_of(const Session& session, std::size_t ticks = 600) {
    return {session.bookmark().checkpoint, session.snapshot().vehicles.front().id, {.kind = 0}, ticks};
}

Design with_brain(const Session& session, const FourNeurons& brain) {
    Design design = insight::design_of(session.snapshot(), session.snapshot().vehicles.front());
    design.brain = make_graph(brain);
    return design;
}

insight::Path driven(Session& session, std::size_t ticks) {
    insight::Path path;
    for (std::size_t i = 0; i <= ticks; ++i) {
        if (i > 0) session.step();
        const VehicleView& now = session.snapshot().vehicles.front();
        path.push_back({now.x, now.y, now.heading});
    }
    return path;
}

float number(const insight::ComparedRun& run, CompareMeasure measure) {
    return run.numbers[static_cast<std::size_t>(measure)];
}

TEST(Compare, TheRunOfADesignIsTheOneThatTheVehicleDrivesWithIt) {
    Session session = open_session(with_lamp());
    const insight::CompareQuestion question = start_of(session);
    Design design = with_brain(session, flees);
    design.sensors[0].range = 6;
    const insight::ComparedRun predicted = insight::run_design(question, design);
    EXPECT_NE(predicted.path, insight::run_design(question, with_brain(session, flees)).path) << "its sensors count";
    for (const Command& command :
         insight::commands_for(design, session.snapshot(), session.snapshot().vehicles.front(), question.target))
        EXPECT_FALSE(session.apply(command));
    EXPECT_EQ(predicted.path, driven(session, 600));
}

TEST(Compare, BothRunsHaveTheSameStartAndNoise) {
    Session session = open_session(with_lamp());
    const auto a = insight::run_design(start_of(session), with_brain(session, seeks));
    const auto again = insight::run_design(start_of(session), with_brain(session, seeks));
    const auto b = insight::run_design(start_of(session), with_brain(session, flees));
    EXPECT_EQ(a.path, again.path);
    EXPECT_EQ(a.numbers, again.numbers);
    EXPECT_EQ(a.path.front(), b.path.front());
    EXPECT_NE(a.path.back(), b.path.back());
}

TEST(Compare, APieceAtATimeGivesTheSameRun) {
    Session session = open_session(with_lamp());
    insight::DesignRun run(start_of(session), with_brain(session, flees));
    EXPECT_FALSE(run.advance(7));
    EXPECT_NEAR(run.progress(), 8.0f / 601, 1e-6f);
    while (!run.advance(7)) {
    }
    EXPECT_EQ(run.progress(), 1);
    EXPECT_EQ(run.run().path, insight::run_design(start_of(session), with_brain(session, flees)).path);
}

TEST(Compare, NumbersTellWhoComesNearerAndStaysInTheLight) {
    Session session = open_session(with_lamp());
    const auto a = insight::run_design(start_of(session), with_brain(session, seeks));
    const auto b = insight::run_design(start_of(session), with_brain(session, flees));
    EXPECT_LT(number(a, CompareMeasure::closest), 0.7f);
    EXPECT_TRUE(std::isfinite(number(a, CompareMeasure::touch)));
    EXPECT_TRUE(std::isinf(number(b, CompareMeasure::touch)));
    EXPECT_GT(number(b, CompareMeasure::final_distance), number(b, CompareMeasure::closest));
    EXPECT_GT(*insight::difference(a.numbers, b.numbers, CompareMeasure::closest), 1);
    EXPECT_FALSE(insight::difference(a.numbers, b.numbers, CompareMeasure::touch)) << "B never touches";
    EXPECT_GT(number(a, CompareMeasure::in_light), 0);
}

TEST(Compare, AStraightDriveHasItsLengthAndItsSecondsInTheLight) {
    // A lamp of strength 1 reads 0.25 at 1/(1+(d/3)²)·(1−(d/12)²)² = 0.25, d ≈ 4.03 m with the standard eye.
    Scene scene = alone({.LM = 0.5f, .RM = 0.5f}, -8);
    scene.sources = {{.name = "lamp", .x = 0, .y = 0}};
    Session session = open_session(scene);
    const Design design = insight::design_of(session.snapshot(), session.snapshot().vehicles.front());
    const auto run = insight::run_design(start_of(session, 640), design);
    const float length = run.path.back().x - run.path.front().x;
    EXPECT_NEAR(number(run, CompareMeasure::driven), length, 0.01f);
    std::size_t lit = 0;
    for (std::size_t i = 1; i < run.path.size(); ++i) {
        const float d2 = run.path[i].x * run.path[i].x, range = design.sensors[0].range;
        const float edge = 1 - d2 / (range * range);
        lit += d2 < range * range && edge * edge / (1 + d2 / 9) >= 0.25f;
    }
    EXPECT_GT(lit, 100u);
    EXPECT_LT(lit, 600u);
    EXPECT_NEAR(number(run, CompareMeasure::in_light), static_cast<float>(lit) / 60, 0.05f);
}

TEST(Compare, ASceneWithoutLightAndObjectsHasNoSuchNumbers) {
    Session session = open_session(alone(seeks));
    const auto run = insight::run_design(start_of(session, 60), with_brain(session, seeks));
    EXPECT_TRUE(std::isnan(number(run, CompareMeasure::in_light)));
    EXPECT_TRUE(std::isnan(number(run, CompareMeasure::closest)));
    EXPECT_GT(number(run, CompareMeasure::driven), 0);
}

TEST(Compare, ADesignIsTheSameWhereverItsNodesStand) {
    Session session = open_session(with_lamp());
    Design one = with_brain(session, seeks), other = one;
    other.brain.nodes[0].place = maths::vec2{3, 4};
    EXPECT_TRUE(insight::is_same(one, other));
    EXPECT_TRUE(insight::commands_for(other, session.snapshot(), session.snapshot().vehicles.front(), {}).empty());
    other.sensors[0].range += 1;
    EXPECT_FALSE(insight::is_same(one, other));
}

}  // namespace
}  // namespace braitenlab::tests::compare_test
