#include "core/brain/four_neurons.h"

#include <array>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "core/brain/brain.h"
#include "core/brain/recogniser.h"

namespace braitenlab::tests::four_neurons_test {
namespace {

TEST(FourNeurons, ComputeTheTwoMotorEquations) {
    const FourNeurons four{.LL = 0.5f, .LR = -0.25f, .RL = 0.75f, .RR = 0.125f, .LM = 0.1f, .RM = -0.2f};
    const std::array<std::string, 2> sensors{"SL", "SR"};
    const auto brain = compile(make_graph(four), sensors);
    ASSERT_TRUE(brain);
    std::vector<float> state(static_cast<std::size_t>(brain->state_size()));
    std::array<float, 2> motors{};
    think(*brain, std::array{0.4f, 0.8f}, state, motors);
    EXPECT_FLOAT_EQ(motors[0], 0.4f * 0.5f + 0.8f * -0.25f + 0.1f);
    EXPECT_FLOAT_EQ(motors[1], 0.8f * 0.125f + 0.4f * 0.75f - 0.2f);
}

TEST(FourNeurons, DialsReturnTheirValueAndClamp) {
    BrainGraph graph = make_graph({});
    turn(graph, Dial::RL, 1.25f);
    turn(graph, Dial::threshold_RL, 0.5f);
    turn(graph, Dial::RM, 7);
    turn(graph, Dial::LL, std::numeric_limits<float>::infinity());
    const FourNeurons four = read_dials(graph);
    EXPECT_EQ(four, (FourNeurons{.RL = 1.25f, .threshold_RL = 0.5f, .RM = 1}));
    EXPECT_TRUE(is_four_neurons(graph));
}

TEST(FourNeurons, DialsSetTheDirectWiresOfALargerGraph) {
    BrainGraph graph = make_graph({.LL = 1});
    graph.nodes.push_back({.id = 9, .kind = NodeKind::neuron, .name = "N"});
    std::erase_if(graph.wires, [](const Wire& w) { return w.from == 0 && w.to == 3; });
    EXPECT_FALSE(is_four_neurons(graph));
    turn(graph, Dial::RL, -1);
    EXPECT_EQ(read_dials(graph).RL, -1);
    EXPECT_EQ(read_dials(graph).LL, 1);
}

TEST(FourNeurons, DialsGiveAnEmptyGraphTheFourNeurons) {
    BrainGraph graph;
    turn(graph, Dial::LM, 0.3f);
    EXPECT_EQ(read_dials(graph), (FourNeurons{.LM = 0.3f}));
    EXPECT_EQ(graph.nodes.size(), 4u);
}

TEST(FourNeurons, DirectDialReturnsTheDialOfEachOfTheFourWires) {
    using namespace four_neuron_ids;
    BrainGraph graph = make_graph({});
    graph.nodes.push_back({.id = 4, .kind = NodeKind::neuron, .name = "N1"});
    EXPECT_EQ(direct_dial(graph, {SL, ML}), Dial::LL);
    EXPECT_EQ(direct_dial(graph, {SR, ML}), Dial::LR);
    EXPECT_EQ(direct_dial(graph, {SL, MR}), Dial::RL);
    EXPECT_EQ(direct_dial(graph, {SR, MR}), Dial::RR);
    EXPECT_FALSE(direct_dial(graph, {SL, 4}));
    EXPECT_FALSE(direct_ends(BrainGraph{}, Dial::LL));
}

TEST(FourNeurons, TurnsTheDialsOfAnotherPairWithoutTheFirst) {
    BrainGraph graph = make_graph({.LR = 0.5f});
    const SensorPair heat{"HL", "HR"};
    turn(graph, Dial::LR, 1, heat);
    EXPECT_EQ(read_dials(graph, heat), FourNeurons{}) << "the brain has no sensor HR";
    graph.nodes.push_back({.id = 7, .kind = NodeKind::sensor, .name = "HL"});
    graph.nodes.push_back({.id = 8, .kind = NodeKind::sensor, .name = "HR"});
    turn(graph, Dial::LR, 1.5f, heat);
    turn(graph, Dial::threshold_LR, 0.25f, heat);
    EXPECT_EQ(read_dials(graph, heat), (FourNeurons{.LR = 1.5f, .threshold_LR = 0.25f}));
    EXPECT_EQ(read_dials(graph), FourNeurons{.LR = 0.5f});
    EXPECT_EQ(direct_dial(graph, {8, four_neuron_ids::ML}, heat), Dial::LR);
    EXPECT_EQ(read_dials(crossed(graph, heat), heat).RR, 1.5f);
    EXPECT_EQ(read_dials(crossed(graph, heat)), FourNeurons{.LR = 0.5f});
    EXPECT_EQ(read_dials(mirrored(graph, heat), heat).RL, 1.5f);
}

TEST(FourNeurons, AWireHasTheNameOfItsDialOrOfItsEnds) {
    using namespace four_neuron_ids;
    BrainGraph graph = make_graph({});
    graph.nodes.push_back({.id = 4, .kind = NodeKind::neuron, .name = "N1"});
    EXPECT_EQ(wire_name(graph, {SR, ML}), "LR");
    EXPECT_EQ(wire_name(graph, {4, ML}), "N1-ML");
    EXPECT_EQ(wire_name(graph, {4, 99}), "N1-?");
}

Wire* wire(BrainGraph& brain, const char* from, const char* to) {
    return find_wire(brain, find_node(brain, std::string(from))->id, find_node(brain, std::string(to))->id);
}

TEST(FourNeurons, MirroredMakesTheRightSideTheMirrorImageOfTheLeft) {
    const FourNeurons given{.LL = 1.5f,
                            .LR = -0.4f,
                            .RL = 0.9f,
                            .RR = 0.2f,
                            .threshold_LL = 0.3f,
                            .threshold_LR = 0.1f,
                            .LM = 0.25f,
                            .RM = -1};
    const FourNeurons made = read_dials(mirrored(make_graph(given)));
    EXPECT_EQ(made, (FourNeurons{.LL = 1.5f,
                                 .LR = -0.4f,
                                 .RL = -0.4f,
                                 .RR = 1.5f,
                                 .threshold_LL = 0.3f,
                                 .threshold_LR = 0.1f,
                                 .threshold_RL = 0.1f,
                                 .threshold_RR = 0.3f,
                                 .LM = 0.25f,
                                 .RM = 0.25f}));
}

TEST(FourNeurons, MirroredDoesNotChangeASymmetricBrain) {
    const BrainGraph brain = make_graph({.LL = 1, .RR = 1, .LM = 0.1f, .RM = 0.1f});
    EXPECT_EQ(mirrored(brain), brain);
}

TEST(FourNeurons, MirroredCopiesCurvesAndMissingWires) {
    BrainGraph brain = make_graph({.LL = 1, .LR = 1, .RL = 1, .RR = 1});
    wire(brain, "SL", "ML")->curve = {Response::hump, 0.3f, 0.1f};
    std::erase_if(brain.wires, [](const Wire& w) { return w.from == 1 && w.to == 2; });  // LR
    BrainGraph made = mirrored(brain);
    EXPECT_EQ(wire(made, "SR", "MR")->curve, (Curve{Response::hump, 0.3f, 0.1f}));
    EXPECT_EQ(wire(made, "SL", "MR"), nullptr);
}

TEST(FourNeurons, CrossedTurnsACowardIntoAnAggressorAndBack) {
    const BrainGraph coward = make_graph({.LL = 1.5f, .RR = 1.2f, .threshold_RR = 0.2f, .LM = 0.1f, .RM = 0.1f});
    const BrainGraph aggressor = crossed(coward);
    EXPECT_EQ(read_dials(aggressor),
              (FourNeurons{.LR = 1.2f, .RL = 1.5f, .threshold_LR = 0.2f, .LM = 0.1f, .RM = 0.1f}));
    EXPECT_EQ(recognise(aggressor), Character::aggressor);
    EXPECT_EQ(crossed(aggressor), coward);
}

TEST(FourNeurons, MirroredAndCrossedKeepLesionsInPlace) {
    BrainGraph brain = make_graph({.LL = 1, .RR = 0.5f});
    wire(brain, "SL", "ML")->cut = true;
    BrainGraph both = mirrored(brain), across = crossed(brain);
    EXPECT_TRUE(wire(both, "SL", "ML")->cut);
    EXPECT_FALSE(wire(both, "SR", "MR")->cut);
    EXPECT_TRUE(wire(across, "SL", "ML")->cut);
    EXPECT_FALSE(wire(across, "SL", "MR")->cut);
}

TEST(FourNeurons, MirroredAndCrossedDoNotChangeABrainWithoutTwoEyes) {
    BrainGraph brain = make_graph({.LL = 1});
    std::erase_if(brain.nodes, [](const Node& n) { return n.name == "SR"; });
    std::erase_if(brain.wires, [](const Wire& w) { return w.from == 1; });
    EXPECT_EQ(mirrored(brain), brain);
    EXPECT_EQ(crossed(brain), brain);
}

}  // namespace
}  // namespace braitenlab::tests::four_neurons_test
