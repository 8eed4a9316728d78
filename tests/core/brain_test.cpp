#include "core/brain/brain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/brain/four_neurons.h"

namespace braitenlab {
namespace {

const std::array<std::string, 2> eyes{"SL", "SR"};

std::array<float, 2> drive_once(const BrainGraph& graph, float left_eye, float right_eye) {
    const auto brain = compile(graph, eyes);
    EXPECT_TRUE(brain);
    std::vector<float> neurons(static_cast<std::size_t>(brain->neuron_count()));
    std::array<float, 2> motors{};
    const std::array<float, 2> sensed{left_eye, right_eye};
    think(*brain, sensed, neurons, motors);
    return motors;
}

TEST(FourNeuronBrain, ComputesTheTwoMotorEquations) {
    const FourNeurons four{.LL = 0.5f, .LR = -0.25f, .RL = 0.75f, .RR = 0.125f, .LM = 0.1f, .RM = -0.2f};
    const auto motors = drive_once(make_graph(four), 0.4f, 0.8f);
    EXPECT_FLOAT_EQ(motors[0], 0.4f * 0.5f + 0.8f * -0.25f + 0.1f);
    EXPECT_FLOAT_EQ(motors[1], 0.8f * 0.125f + 0.4f * 0.75f - 0.2f);
}

TEST(FourNeuronBrain, ClampsTheSumsToFullSpeed) {
    const auto motors = drive_once(make_graph({.LL = 2, .RR = -2}), 1, 1);
    EXPECT_EQ(motors[0], 1);
    EXPECT_EQ(motors[1], -1);
}

TEST(Threshold, MasksInputsBelowItAndPassesThoseAtIt) {
    const BrainGraph graph = make_graph({.LL = 1, .threshold_LL = 0.5f});
    EXPECT_EQ(drive_once(graph, 0.49f, 0)[0], 0);
    EXPECT_EQ(drive_once(graph, 0.5f, 0)[0], 0.5f);
}

TEST(Brain, GivesTheSameBitsWhateverTheOrderOfEditing) {
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

TEST(HiddenNeuron, ReachesTheMotorInTheSameTick) {
    BrainGraph graph = make_graph({});
    graph.nodes.push_back({.id = 7, .kind = NodeKind::neuron, .name = "N"});
    graph.wires.push_back({.from = 0, .to = 7, .weight = 0.5f});
    graph.wires.push_back({.from = 7, .to = 3, .weight = 1});
    EXPECT_FLOAT_EQ(drive_once(graph, 0.8f, 0)[1], 0.4f);
}

TEST(HiddenNeuron, FeedingItselfHoldsWhatItHeldATickAgo) {
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

TEST(LeakyNeuron, ReachesSixtyThreePercentInItsTimeConstant) {
    BrainGraph graph = make_graph({.LL = 1});
    find_node(graph, "ML")->time_constant = 0.5f;
    const auto brain = compile(graph, eyes);
    ASSERT_TRUE(brain);
    std::vector<float> neurons(2);
    std::array<float, 2> motors{};
    for (int tick = 0; tick < 30; ++tick) think(*brain, std::array{1.0f, 0.0f}, neurons, motors);
    EXPECT_NEAR(motors[0], 1 - std::exp(-1.0f), 1e-3f);
}

TEST(Hump, FallsOffOnBothSidesOfItsPeak) {
    const Curve hump{Response::hump, 0.5f, 0.2f};
    EXPECT_EQ(respond(hump, 0.5f), 1);
    EXPECT_NEAR(respond(hump, 0.7f), std::exp(-1.0f), 1e-6f);
    EXPECT_FLOAT_EQ(respond(hump, 0.3f), respond(hump, 0.7f));
}

TEST(Compile, RefusesWhatCannotThinkAndSaysWhy) {
    BrainGraph twice = make_graph({});
    twice.wires.push_back(twice.wires.front());
    EXPECT_NE(compile(twice, eyes).error().what.find("two wires run from 'SL' to 'ML'"), std::string::npos);

    BrainGraph into_eye = make_graph({});
    into_eye.wires.push_back({.from = 2, .to = 0});
    EXPECT_NE(compile(into_eye, eyes).error().what.find("sensors only send"), std::string::npos);

    BrainGraph nowhere = make_graph({});
    nowhere.wires.push_back({.from = 0, .to = 99});
    EXPECT_FALSE(compile(nowhere, eyes));

    BrainGraph not_a_number = make_graph({});
    not_a_number.wires.front().weight = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(compile(not_a_number, eyes));
}

TEST(Dials, ReadBackWhatTheyWereSetToAndClamp) {
    BrainGraph graph = make_graph({});
    turn(graph, Dial::RL, 1.25f);
    turn(graph, Dial::threshold_RL, 0.5f);
    turn(graph, Dial::RM, 7);
    turn(graph, Dial::LL, std::numeric_limits<float>::infinity());
    const FourNeurons four = read_dials(graph);
    EXPECT_EQ(four, (FourNeurons{.RL = 1.25f, .threshold_RL = 0.5f, .RM = 1}));
    EXPECT_TRUE(is_four_neurons(graph));
}

TEST(Dials, ReachTheDirectWiresOfALargerGraph) {
    BrainGraph graph = make_graph({.LL = 1});
    graph.nodes.push_back({.id = 9, .kind = NodeKind::neuron, .name = "N"});
    std::erase_if(graph.wires, [](const Wire& w) { return w.from == 0 && w.to == 3; });
    EXPECT_FALSE(is_four_neurons(graph));
    turn(graph, Dial::RL, -1);
    EXPECT_EQ(read_dials(graph).RL, -1);
    EXPECT_EQ(read_dials(graph).LL, 1);
}

}  // namespace
}  // namespace braitenlab
