#include "core/brain/brain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/brain/four_neurons.h"
#include "core/maths/random.h"

namespace braitenlab::tests::brain_test {
namespace {

const std::array<std::string, 2> eyes{"SL", "SR"};

std::array<float, 2> drive_once(const BrainGraph& graph, float left_eye, float right_eye) {
    const auto brain = compile(graph, eyes);
    EXPECT_TRUE(brain);
    std::vector<float> neurons(static_cast<std::size_t>(brain->state_size()));
    std::array<float, 2> motors{};
    const std::array<float, 2> sensed{left_eye, right_eye};
    think(*brain, sensed, neurons, motors);
    return motors;
}

TEST(Graph, MaskedComparesSizesOfEitherSign) {
    for (const float sign : {1.0f, -1.0f}) {
        EXPECT_EQ(masked(sign * 0.5f, 0.5f), sign * 0.5f);
        EXPECT_EQ(masked(sign * 0.49f, 0.5f), 0);
        EXPECT_EQ(masked(sign * 0.49f, 0), sign * 0.49f);
    }
}

TEST(Brain, ClampsMotorsToFullSpeed) {
    const auto motors = drive_once(make_graph({.LL = 2, .RR = -2}), 1, 1);
    EXPECT_EQ(motors[0], 1);
    EXPECT_EQ(motors[1], -1);
}

TEST(Brain, AThresholdMasksInputsBelowItAndPassesThoseAtIt) {
    const BrainGraph graph = make_graph({.LL = 1, .threshold_LL = 0.5f});
    EXPECT_EQ(drive_once(graph, 0.49f, 0)[0], 0);
    EXPECT_EQ(drive_once(graph, 0.5f, 0)[0], 0.5f);
}

TEST(Brain, GivesTheSameBitsInAnyOrderOfEditing) {
    BrainGraph graph = make_graph({.LL = 0.3f, .LR = 0.1f, .RL = 0.7f, .RR = -0.9f, .LM = 0.05f});
    for (int extra = 0; extra < 6; ++extra) {  // sums of many terms, whose last bit depends on their order
        graph.nodes.push_back(
            {.id = 10 + extra, .kind = NodeKind::neuron, .name = std::string(1, static_cast<char>('a' + extra))});
        graph.wires.push_back({.from = 0, .to = 10 + extra, .weight = 0.1f + 0.17f * static_cast<float>(extra)});
        graph.wires.push_back({.from = 10 + extra, .to = 2, .weight = 0.07f * static_cast<float>(extra) - 0.11f});
    }
    BrainGraph turned = graph;
    std::reverse(turned.wires.begin(), turned.wires.end());
    std::reverse(turned.nodes.begin(), turned.nodes.end());
    for (float input = 0.01f; input < 1; input += 0.037f)
        EXPECT_EQ(drive_once(graph, input, 0.789f), drive_once(turned, input, 0.789f)) << input;
}

TEST(Brain, ANeuronReachesTheMotorInTheSameTick) {
    BrainGraph graph = make_graph({});
    graph.nodes.push_back({.id = 7, .kind = NodeKind::neuron, .name = "N"});
    graph.wires.push_back({.from = 0, .to = 7, .weight = 0.5f});
    graph.wires.push_back({.from = 7, .to = 3, .weight = 1});
    EXPECT_FLOAT_EQ(drive_once(graph, 0.8f, 0)[1], 0.4f);
}

TEST(Brain, ANeuronThatFeedsItselfReadsThePreviousTick) {
    BrainGraph graph = make_graph({});
    graph.nodes.push_back({.id = 7, .kind = NodeKind::neuron, .name = "N"});
    graph.wires.push_back({.from = 0, .to = 7});
    graph.wires.push_back({.from = 7, .to = 7});
    const auto brain = compile(graph, eyes);
    ASSERT_TRUE(brain);
    std::vector<float> neurons(3);
    std::array<float, 2> motors{};
    for (const float input : {0.25f, 0.0f, 0.0f}) think(*brain, std::array{input, 0.0f}, neurons, motors);
    EXPECT_EQ(neurons[0], 0.25f);
}

TEST(Brain, ALeakyNeuronReaches63PercentInItsTimeConstant) {
    BrainGraph graph = make_graph({.LL = 1});
    find_node(graph, "ML")->time_constant = 0.5f;
    const auto brain = compile(graph, eyes);
    ASSERT_TRUE(brain);
    std::vector<float> neurons(2);
    std::array<float, 2> motors{};
    for (int tick = 0; tick < 30; ++tick) think(*brain, std::array{1.0f, 0.0f}, neurons, motors);
    EXPECT_NEAR(motors[0], 1 - std::exp(-1.0f), 1e-3f);
}

TEST(Brain, StaysFiniteForRandomBrainsWithinTheRanges) {
    maths::Random chance{1, 1};
    const auto pick = [&](float low, float high) {  // a third of the values at each end of the range
        const float where = chance.uniform(-1, 2);
        return low + (high - low) * std::clamp(where, 0.0f, 1.0f);
    };
    const auto curve = [&] {
        const auto row = static_cast<std::size_t>(chance.uniform(0, static_cast<float>(responses.size())));
        return Curve{responses.at(row).value, pick(-2, 2), pick(0.001f, 10)};
    };
    for (int trial = 0; trial < 200; ++trial) {
        BrainGraph graph = make_graph({.LL = 2, .RR = -2});
        for (NodeId id = 4; id < 12; ++id)
            graph.nodes.push_back({.id = id,
                                   .kind = NodeKind::neuron,
                                   .name = fmt::format("n{}", id),
                                   .curve = curve(),
                                   .bias = pick(-1, 1),
                                   .time_constant = pick(0, 600)});
        for (NodeId from = 0; from < 12; ++from)
            for (NodeId to = 4; to < 12; ++to)
                graph.wires.push_back({.from = from,
                                       .to = to,
                                       .weight = pick(-2, 2),
                                       .threshold = pick(0, 1),
                                       .curve = curve(),
                                       .learning_rate = pick(0, 10),
                                       .decay = pick(0, 10)});
        const auto brain = compile(graph, eyes);
        ASSERT_TRUE(brain) << brain.error().what;
        std::vector<float> state(static_cast<std::size_t>(brain->state_size()));
        std::array<float, 2> motors{};
        for (int tick = 0; tick < 120; ++tick) {
            think(*brain, std::array{pick(0, 1), pick(0, 1)}, state, motors);
            for (const float x : state) ASSERT_TRUE(std::isfinite(x)) << trial;
            for (const float x : motors) ASSERT_LE(std::fabs(x), 1) << trial;
        }
    }
}

// SL and a neuron N of bias 0.25 both feed the left motor, the neuron through an inverted wire.
BrainGraph with_inverted_wire() {
    BrainGraph graph = make_graph({.LL = 0.5f, .RR = 0.5f, .LM = 0.125f});
    graph.nodes.push_back({.id = 7, .kind = NodeKind::neuron, .name = "N", .bias = 0.25f});
    graph.wires.push_back({.from = 7, .to = 2, .weight = 0.5f, .curve = {.response = Response::inverted}});
    return graph;
}

TEST(Brain, ASilencedSensorReadsZero) {
    BrainGraph graph = with_inverted_wire();
    const auto whole = drive_once(graph, 0, 0.5f);
    find_node(graph, "SL")->silenced = true;
    EXPECT_EQ(drive_once(graph, 1, 0.5f), whole);
}

TEST(Brain, ASilencedNeuronOrMotorGivesZeroForAnyInput) {
    BrainGraph graph = with_inverted_wire();
    EXPECT_FLOAT_EQ(drive_once(graph, 0.5f, 0.5f)[0], 0.5f * 0.5f + 0.5f * (1 - 0.25f) + 0.125f);
    find_node(graph, "N")->silenced = true;  // its reader gets 0, which an inverted wire turns into 1
    EXPECT_FLOAT_EQ(drive_once(graph, 0.5f, 0.5f)[0], 0.5f * 0.5f + 0.5f * 1 + 0.125f);
    find_node(graph, "ML")->silenced = true;
    EXPECT_EQ(drive_once(graph, 0.5f, 0.5f), (std::array{0.0f, 0.25f}));
}

TEST(Brain, ACutWireDeliversNothingEvenWhenItsCurveWould) {
    BrainGraph graph = with_inverted_wire();
    graph.wires.back().cut = true;
    EXPECT_FLOAT_EQ(drive_once(graph, 0.5f, 0.5f)[0], 0.5f * 0.5f + 0.125f);
}

TEST(Brain, AHealedLesionHasNoEffect) {
    BrainGraph graph = with_inverted_wire();
    const auto whole = drive_once(graph, 0.3f, 0.7f);
    graph.nodes[0].silenced = graph.nodes[4].silenced = graph.wires[0].cut = true;
    EXPECT_NE(drive_once(graph, 0.3f, 0.7f), whole);
    graph.nodes[0].silenced = graph.nodes[4].silenced = graph.wires[0].cut = false;
    EXPECT_EQ(drive_once(graph, 0.3f, 0.7f), whole);
}

// A compiled brain and its state.
struct Thinker {
    explicit Thinker(const BrainGraph& graph) : brain(*compile(graph, eyes)) {
        state.resize(static_cast<std::size_t>(brain.state_size()));
    }
    void run(int ticks, float left_eye, float right_eye) {
        for (int t = 0; t < ticks; ++t) think(brain, std::array{left_eye, right_eye}, state, motors);
    }
    float learned() const { return state.back(); }
    Brain brain;
    std::vector<float> state;
    std::array<float, 2> motors{};
};

// A threshold unit: 1 when the sum of its inputs reaches the threshold, else 0.
void add_unit(BrainGraph& graph, const char* name, float threshold) {
    graph.nodes.push_back({.id = static_cast<NodeId>(graph.nodes.size()),
                           .kind = NodeKind::neuron,
                           .name = name,
                           .curve = {.response = Response::step, .peak = threshold}});
}

void feed(BrainGraph& graph, const char* from, const char* to, float weight) {
    graph.wires.push_back({.from = find_node(graph, from)->id, .to = find_node(graph, to)->id, .weight = weight});
}

// The value of the unit OUT after a few ticks with these inputs.
float out(const BrainGraph& graph, bool a, bool b) {
    Thinker thinker(graph);
    thinker.run(4, a ? 1.0f : 0.0f, b ? 1.0f : 0.0f);
    const auto& ids = thinker.brain.unit_ids;
    const auto at = std::find(ids.begin(), ids.end(), find_node(graph, std::string("OUT"))->id) - ids.begin();
    return thinker.state[static_cast<std::size_t>(at)];
}

std::array<float, 4> truth_table(const BrainGraph& graph) {
    return {out(graph, false, false), out(graph, false, true), out(graph, true, false), out(graph, true, true)};
}

BrainGraph gate(float weight, float threshold) {
    BrainGraph graph = make_graph({});
    add_unit(graph, "OUT", threshold);
    feed(graph, "SL", "OUT", weight);
    feed(graph, "SR", "OUT", weight);
    return graph;
}

TEST(Brain, ThresholdUnitsComputeAndOrNotAndExclusiveOr) {
    EXPECT_EQ(truth_table(gate(1, 1.5f)), (std::array{0.0f, 0.0f, 0.0f, 1.0f}));    // AND
    EXPECT_EQ(truth_table(gate(1, 0.5f)), (std::array{0.0f, 1.0f, 1.0f, 1.0f}));    // OR
    EXPECT_EQ(truth_table(gate(-1, -0.5f)), (std::array{1.0f, 0.0f, 0.0f, 0.0f}));  // NOT, of either
    BrainGraph exclusive = make_graph({});
    add_unit(exclusive, "OR", 0.5f);
    add_unit(exclusive, "NAND", -1.5f);
    add_unit(exclusive, "OUT", 1.5f);
    for (const char* eye : {"SL", "SR"}) feed(exclusive, eye, "OR", 1), feed(exclusive, eye, "NAND", -1);
    for (const char* part : {"OR", "NAND"}) feed(exclusive, part, "OUT", 1);
    EXPECT_EQ(truth_table(exclusive), (std::array{0.0f, 1.0f, 1.0f, 0.0f}));
}

TEST(Brain, AThresholdUnitThatFeedsItselfStaysOnUntilItIsReset) {
    BrainGraph latch = make_graph({});
    add_unit(latch, "OUT", 0.5f);
    feed(latch, "OUT", "OUT", 1);
    feed(latch, "SL", "OUT", 1);
    feed(latch, "SR", "OUT", -1);
    Thinker thinker(latch);
    thinker.run(5, 0, 0);
    EXPECT_EQ(thinker.state[0], 0);
    thinker.run(1, 1, 0);
    thinker.run(1000, 0, 0);
    EXPECT_EQ(thinker.state[0], 1);
    thinker.run(1, 0, 1);
    thinker.run(5, 0, 0);
    EXPECT_EQ(thinker.state[0], 0);
}

// SR drives the left motor; the wire from SL learns to.
BrainGraph with_hebbian_wire(float learning_rate, float decay) {
    BrainGraph graph = make_graph({.LR = 1});
    Wire& wire = *find_wire(graph, 0, 2);
    wire.learning_rate = learning_rate;
    wire.decay = decay;
    return graph;
}

TEST(Brain, AHebbianWireGrowsByTheProductOfItsEnds) {
    Thinker learner(with_hebbian_wire(0.6f, 0));
    EXPECT_EQ(learner.brain.learning_wires, (std::vector<std::pair<NodeId, NodeId>>{{0, 2}}));
    learner.run(60, 0, 1);  // no signal at the start of the wire
    EXPECT_EQ(learner.learned(), 0);
    learner.run(60, 1, 0);  // no signal at the end of the wire
    EXPECT_EQ(learner.learned(), 0);
    learner.run(1, 0.5f, 0.8f);
    EXPECT_FLOAT_EQ(learner.learned(), 0.6f * 0.5f * 0.8f / 60);
    learner.run(20, 0.5f, 0.8f);
    const float h = learner.learned();
    learner.run(1, 0.5f, 0);  // only the learned part drives the motor
    EXPECT_NEAR(learner.motors[0], 0.5f * h, 1e-6f);
}

TEST(Brain, AHebbianWireFadesToOneOverEInTheTimeOfItsDecay) {
    Thinker learner(with_hebbian_wire(2, 0.5f));
    learner.run(60, 1, 1);
    const float before = learner.learned();
    EXPECT_GT(before, 0.5f);
    learner.run(120, 0, 1);  // 2 s at 0.5/s
    EXPECT_NEAR(learner.learned() / before, std::exp(-1.0f), 0.01f);
}

TEST(Brain, AHebbianWireStopsAtTheRangeOfWeights) {
    Thinker eager(with_hebbian_wire(10, 0));
    eager.run(600, 1, 1);
    EXPECT_EQ(eager.learned(), 2);
    BrainGraph strong = with_hebbian_wire(10, 0);
    find_wire(strong, 0, 2)->weight = 0.5f;
    Thinker strong_learner(strong);
    strong_learner.run(600, 1, 1);
    EXPECT_EQ(strong_learner.learned(), 1.5f);
    BrainGraph against = with_hebbian_wire(10, 0);
    find_wire(against, 1, 2)->weight = -1;  // the motor runs backwards: the wire is weakened
    find_wire(against, 0, 2)->weight = 0.5f;
    Thinker contrary(against);
    contrary.run(600, 0.5f, 1);
    EXPECT_EQ(contrary.learned(), -2.5f);
}

TEST(Brain, AHebbianWireKeepsItsLearnedPartWhileItIsCut) {
    BrainGraph graph = with_hebbian_wire(2, 0.5f);
    Thinker whole(graph);
    whole.run(60, 1, 1);
    find_wire(graph, 0, 2)->cut = true;
    Thinker hurt(graph);
    hurt.state = whole.state;
    hurt.run(60, 1, 0);
    EXPECT_EQ(hurt.motors[0], 0);
    EXPECT_EQ(hurt.learned(), whole.learned());
}

TEST(Brain, SettlesNeuronsWithoutMemoryThatReadEachOtherAndNoOthers) {
    BrainGraph graph = make_graph({});
    add_unit(graph, "FIRST", 0.5f);
    add_unit(graph, "SECOND", 0.5f);
    add_unit(graph, "THIRD", 0.5f);
    add_unit(graph, "LATCH", 0.5f);
    add_unit(graph, "SLOW", 0.5f);
    find_node(graph, "SLOW")->time_constant = 1;
    feed(graph, "SL", "FIRST", 1), feed(graph, "FIRST", "SECOND", 1), feed(graph, "SECOND", "THIRD", 1);
    feed(graph, "LATCH", "LATCH", 1), feed(graph, "SL", "LATCH", 1), feed(graph, "SL", "SLOW", 1);
    const auto brain = compile(graph, eyes);
    ASSERT_TRUE(brain);
    std::vector<float> state(static_cast<std::size_t>(brain->state_size()));
    settle_forward(*brain, std::array{1.0f, 0.0f}, state);
    const auto value = [&](const char* name) {
        const auto& ids = brain->unit_ids;
        return state[static_cast<std::size_t>(std::find(ids.begin(), ids.end(), find_node(graph, name)->id) -
                                              ids.begin())];
    };
    for (const char* name : {"FIRST", "SECOND", "THIRD"}) EXPECT_EQ(value(name), 1) << name;
    for (const char* name : {"LATCH", "SLOW"}) EXPECT_EQ(value(name), 0) << name << " keeps its memory";
}

}  // namespace
}  // namespace braitenlab::tests::brain_test
