#include "core/brain/four_neurons.h"

#include <array>
#include <limits>

#include <gtest/gtest.h>

#include "core/brain/brain.h"
#include "core/brain/symmetry.h"

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

}  // namespace
}  // namespace braitenlab::tests::four_neurons_test
