// What of a brain is exported, and the ranges of its values.
#include "core/export/plan.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/brain/four_neurons.h"
#include "core/brain/presets.h"
#include "tests/robots/random_brain.h"

namespace braitenlab::tests::plan_test {
namespace {

using robots::make_plan;
using robots::Plan;
using robots::Range;

BrainGraph with_neuron(float weight_of_loop, Curve curve = {}) {
    BrainGraph graph = make_graph({.LL = 1, .RR = 1});
    graph.nodes.push_back({.id = 50, .kind = NodeKind::neuron, .name = "N", .curve = curve});
    graph.wires.push_back({.from = find_node(graph, "SL")->id, .to = 50, .weight = 1});
    graph.wires.push_back({.from = 50, .to = 50, .weight = weight_of_loop});
    graph.wires.push_back({.from = 50, .to = find_node(graph, "MR")->id, .weight = 0.5f});
    return graph;
}

const robots::PlanUnit* unit_named(const Plan& plan, const std::string& name) {
    for (const auto& unit : plan.units)
        if (unit.name == name) return &unit;
    return nullptr;
}

TEST(Plan, LeavesOutWhatReachesNoMotor) {
    BrainGraph graph = make_graph({.LL = 1, .RR = 0});
    graph.nodes.push_back({.id = 50, .kind = NodeKind::neuron, .name = "IDLE"});
    graph.wires.push_back({.from = find_node(graph, "SR")->id, .to = 50, .weight = 1});
    const auto plan = make_plan({"", graph, {}}, 60);
    ASSERT_TRUE(plan);
    ASSERT_EQ(plan->inputs.size(), 1u);
    EXPECT_EQ(plan->inputs[0].name, "SL");
    EXPECT_EQ(plan->units.size(), 2u);
    EXPECT_TRUE(plan->units[1].taps.empty());
}

TEST(Plan, AddsWhatACoveredEyeGivesToTheBias) {
    BrainGraph graph = make_graph({.LL = 0.5f, .RR = 1, .LM = 0.25f});
    find_node(graph, "SL")->silenced = true;
    for (Wire& wire : graph.wires)
        if (wire.from == find_node(graph, "SL")->id) wire.curve.response = Response::inverted;
    const auto plan = make_plan({"", graph, {}}, 60);
    ASSERT_TRUE(plan);
    EXPECT_FLOAT_EQ(plan->units[0].bias, 0.75f);
    ASSERT_EQ(plan->inputs.size(), 1u);
    EXPECT_EQ(plan->inputs[0].name, "SR");
}

TEST(Plan, BoundsASumAndItsPartialSums) {
    const auto plan = make_plan({"", make_graph({.LL = -2, .LR = 1.5f, .LM = 0.5f}), {}}, 60);
    ASSERT_TRUE(plan);
    EXPECT_EQ(plan->units[0].sum, (Range{-1.5f, 2.0f}));
    EXPECT_EQ(plan->units[1].sum, (Range{0, 0}));
}

TEST(Plan, BoundsALoopThatSettlesAndOneThatGrows) {
    const auto settles = make_plan({"", with_neuron(0.5f), {}}, 60);
    ASSERT_TRUE(settles);
    EXPECT_NEAR(unit_named(*settles, "N")->value.high, 2, 1e-3);  // 1 + 1/2 + 1/4 + …
    const auto grows = make_plan({"", with_neuron(1.5f), {}}, 60);
    ASSERT_TRUE(grows);
    EXPECT_EQ(unit_named(*grows, "N")->value.high, robots::largest_value);
    const auto held = make_plan({"", with_neuron(1.5f, {.response = Response::step}), {}}, 60);
    ASSERT_TRUE(held);
    EXPECT_EQ(unit_named(*held, "N")->value, (Range{0, 1}));
}

TEST(Plan, BoundsEveryValueOfRandomBrains) {
    maths::Random random(5, 1);
    int bounded = 0, close = 0;  // ranges below the bound of all values; values that come near to the end of one
    for (int i = 0; i < 300; ++i) {
        const BrainGraph graph = random_brain(random, false);
        const std::vector<std::string> eyes{"SL", "SR"};
        const auto plan = make_plan({"", graph, {}}, 10);
        const auto brain = compile(graph, eyes, 0.1f);
        ASSERT_TRUE(plan && brain);
        std::vector<float> state(static_cast<std::size_t>(brain->state_size()));
        for (int tick = 0; tick < 300; ++tick) {
            const auto reading = [&] {
                return random.next() % 2 ? static_cast<float>(random.next() % 2) : random.uniform(0, 1);
            };
            const float sensed[] = {reading(), reading()};
            float motors[2];
            think(*brain, sensed, state, motors);
            for (std::size_t u = 0; u < brain->units.size(); ++u) {
                const bool motor = u + 2 >= brain->units.size();
                const auto* unit = unit_named(*plan, motor ? (u + 2 == brain->units.size() ? "ML" : "MR")
                                                           : find_node(graph, brain->unit_ids[u])->name);
                if (!unit) continue;  // without an effect
                const float slack = 1e-4f * (1 + std::max(-unit->value.low, unit->value.high));
                ASSERT_GE(state[u], unit->value.low - slack) << i << " " << unit->name;
                ASSERT_LE(state[u], unit->value.high + slack) << i << " " << unit->name;
                bounded += unit->value.high < 100;
                close += unit->value.high > 0 && unit->value.high < 100 && state[u] > 0.9f * unit->value.high;
            }
        }
    }
    EXPECT_GT(bounded, 100000);
    EXPECT_GT(close, 1000);
}

TEST(Plan, FollowsTheRateOfTheRobot) {
    const auto* tortoise = find_preset("tortoise");
    const auto fast = make_plan({"", tortoise->brain, {}}, 60), slow = make_plan({"", tortoise->brain, {}}, 10);
    ASSERT_TRUE(fast && slow);
    EXPECT_NEAR(unit_named(*fast, "LAPSE")->follow, 1 - std::exp(-1 / (60 * 0.8)), 1e-6);
    EXPECT_NEAR(unit_named(*slow, "LAPSE")->follow, 1 - std::exp(-1 / (10 * 0.8)), 1e-6);
}

TEST(Plan, GivesEveryPartAnIdentifierOfItsOwn) {
    BrainGraph graph = make_graph({.LL = 1, .RR = 1});
    find_node(graph, "SL")->name = "S-L";
    find_node(graph, "SR")->name = "S L";
    const auto plan = make_plan({"", graph, {}}, 60);
    ASSERT_TRUE(plan);
    EXPECT_EQ(plan->inputs[0].id, "sensor_S_L");
    EXPECT_EQ(plan->inputs[1].id, "sensor_S_L_2");
}

}  // namespace
}  // namespace braitenlab::tests::plan_test
