#include "core/brain/edit.h"

#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "core/brain/brain.h"
#include "core/brain/four_neurons.h"

namespace braitenlab::tests::edit_test {
namespace {

using namespace four_neuron_ids;

BrainGraph aggressor() { return make_graph({.LR = 1.5f, .RL = 1.5f, .LM = 0.1f, .RM = 0.1f}); }

// The aggressor with `count` neurons from id 4 on.
BrainGraph with_neurons(int count) {
    BrainGraph graph = aggressor();
    for (int i = 0; i < count; ++i) graph = *add_neuron(graph).graph;
    return graph;
}

// The aggressor with a neuron N1 (id 4) between SL and ML.
BrainGraph with_hidden() {
    const Edit in = connect(with_neurons(1), {SL, 4});
    return *connect(*in.graph, {4, ML}).graph;
}

TEST(Edit, ConnectGivesAWireOfWeightZeroTheWeightOne) {
    const Edit edit = connect(aggressor(), {SL, ML});
    ASSERT_TRUE(edit);
    EXPECT_EQ(read_dials(*edit.graph).LL, 1);
    EXPECT_TRUE(is_four_neurons(*edit.graph));
}

TEST(Edit, ConnectLetsANeuronFeedItself) {
    const Edit edit = connect(with_hidden(), {4, 4});
    ASSERT_TRUE(edit);
    EXPECT_EQ(weight_of(*edit.graph, {4, 4}), 1);
}

TEST(Edit, ConnectRefusesAnExistingWireAWireIntoASensorAndAMissingNode) {
    EXPECT_EQ(connect(aggressor(), {SL, MR}).refusal, Refusal::duplicate);
    EXPECT_FALSE(connect(aggressor(), {SL, MR}));
    EXPECT_EQ(connect(aggressor(), {SL, SR}).refusal, Refusal::into_sensor);
    EXPECT_EQ(connect(with_hidden(), {4, SL}).refusal, Refusal::into_sensor);
    EXPECT_EQ(connect(aggressor(), {SL, 99}).refusal, Refusal::missing);
}

TEST(Edit, SetWeightClampsToTheRangeAndIgnoresNonFiniteValues) {
    EXPECT_EQ(weight_of(*set_weight(aggressor(), {SL, MR}, 9).graph, {SL, MR}), 2);
    EXPECT_EQ(weight_of(*set_weight(aggressor(), {SL, MR}, -9).graph, {SL, MR}), -2);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(*set_weight(aggressor(), {SL, MR}, nan).graph, aggressor());
}

TEST(Edit, AddNeuronTakesTheNextIdAndAFreeName) {
    const Edit edit = add_neuron(with_hidden());
    ASSERT_TRUE(edit);
    EXPECT_EQ(edit.graph->nodes.back().id, 5);
    EXPECT_EQ(edit.graph->nodes.back().name, "N2");
    EXPECT_EQ(edit.graph->nodes.back().kind, NodeKind::neuron);
}

TEST(Edit, RemoveLeavesADirectWireWithoutParameters) {
    BrainGraph graph = aggressor();
    find_wire(graph, SL, MR)->threshold = 0.3f;
    const Edit edit = remove(graph, {}, {{SL, MR}});
    ASSERT_TRUE(edit);
    EXPECT_EQ(read_dials(*edit.graph).RL, 0);
    EXPECT_EQ(read_dials(*edit.graph).threshold_RL, 0);
    EXPECT_EQ(read_dials(*edit.graph).LR, 1.5f);
    EXPECT_TRUE(is_four_neurons(*edit.graph));
}

TEST(Edit, RemoveErasesANeuronAndItsWires) {
    const Edit edit = remove(with_hidden(), {4}, {});
    ASSERT_TRUE(edit);
    EXPECT_EQ(*edit.graph, aggressor());
}

TEST(Edit, RemoveErasesAWireThatIsNotDirect) {
    const Edit edit = remove(with_hidden(), {}, {{SL, 4}});
    ASSERT_TRUE(edit);
    EXPECT_EQ(find_wire(*edit.graph, SL, 4), nullptr);
    EXPECT_NE(find_wire(*edit.graph, 4, ML), nullptr);
}

TEST(Edit, RemoveRefusesSensorsMotorsAndWiresOfWeightZero) {
    EXPECT_EQ(remove(aggressor(), {SL, MR}, {}).refusal, Refusal::fixed_node);
    EXPECT_EQ(remove(aggressor(), {}, {{SL, ML}}).refusal, Refusal::nothing_to_remove);
}

TEST(Edit, ReconnectMovesAWireWithAllItsParameters) {
    BrainGraph graph = with_neurons(1);
    Wire& wire = *find_wire(graph, SL, MR);
    wire.threshold = 0.3f, wire.learning_rate = 2, wire.cut = true;
    const Edit moved = reconnect(graph, {SL, MR}, {SL, 4});
    ASSERT_TRUE(moved);
    const Wire& made = *find_wire(*moved.graph, SL, 4);
    EXPECT_EQ(made.weight, 1.5f);
    EXPECT_EQ(made.threshold, 0.3f);
    EXPECT_EQ(made.learning_rate, 2);
    EXPECT_TRUE(made.cut);
    EXPECT_EQ(weight_of(*moved.graph, {SL, MR}), 0);
}

TEST(Edit, ReconnectRefusesWhatConnectRefuses) {
    EXPECT_EQ(reconnect(aggressor(), {SL, MR}, {SR, ML}).refusal, Refusal::duplicate);
    EXPECT_EQ(reconnect(aggressor(), {SL, MR}, {SL, SR}).refusal, Refusal::into_sensor);
    EXPECT_EQ(reconnect(aggressor(), {SL, ML}, {SL, MR}).refusal, Refusal::missing);
}

TEST(Edit, InsertNeuronKeepsTheWiresParametersBeforeTheNeuron) {
    const Edit edit = insert_neuron(with_neurons(1), 4, {SL, MR});
    ASSERT_TRUE(edit);
    EXPECT_EQ(weight_of(*edit.graph, {SL, 4}), 1.5f);
    EXPECT_EQ(weight_of(*edit.graph, {4, MR}), 1);
    EXPECT_EQ(weight_of(*edit.graph, {SL, MR}), 0);
    EXPECT_EQ(insert_neuron(*edit.graph, 4, {SL, 4}).refusal, Refusal::own_wire);
}

TEST(Edit, DetachRemovesEveryWireOfANode) {
    const Edit edit = detach(*insert_neuron(with_neurons(1), 4, {SL, MR}).graph, {4});
    ASSERT_TRUE(edit);
    EXPECT_FALSE(is_wired(*edit.graph, 4));
    EXPECT_EQ(weight_of(*edit.graph, {SR, ML}), 1.5f);
    EXPECT_EQ(detach(with_neurons(1), {4}).refusal, Refusal::no_wires);
}

TEST(Edit, SetLesionSilencesCutsAndHealsWithoutLosingParameters) {
    const Edit hurt = set_lesion(aggressor(), {SL}, {{SR, ML}}, true);
    ASSERT_TRUE(hurt);
    EXPECT_TRUE(all_lesioned(*hurt.graph, {SL}, {{SR, ML}}));
    EXPECT_FALSE(all_lesioned(*hurt.graph, {SL, SR}, {}));
    EXPECT_EQ(*set_lesion(*hurt.graph, {SL}, {{SR, ML}}, false).graph, aggressor());
    EXPECT_EQ(set_lesion(aggressor(), {}, {}, true).refusal, Refusal::nothing_to_lesion);
    EXPECT_FALSE(all_lesioned(aggressor(), {}, {}));
}

TEST(Edit, SetParametersClampsANodeAndIgnoresNonFiniteValues) {
    const BrainGraph graph = with_neurons(1);
    Node node = *find_node(graph, 4);
    node.bias = 7, node.time_constant = -1, node.curve.width = 0, node.name = "other";
    node.curve.peak = std::numeric_limits<float>::quiet_NaN();
    const Node made = *find_node(*set_parameters(graph, node).graph, 4);
    EXPECT_EQ(made.bias, limits::bias);
    EXPECT_EQ(made.time_constant, 0);
    EXPECT_EQ(made.curve.width, limits::least_width);
    EXPECT_EQ(made.curve.peak, 0.5f);
    EXPECT_EQ(made.name, "N1");
}

TEST(Edit, SetParametersClampsAWireAndIgnoresNonFiniteValues) {
    const BrainGraph graph = with_neurons(1);
    Wire wire = *find_wire(graph, SL, MR);
    wire.weight = 9, wire.learning_rate = -3, wire.decay = std::numeric_limits<float>::infinity();
    const Edit edit = set_parameters(graph, wire);
    const Wire made = *find_wire(*edit.graph, SL, MR);
    EXPECT_EQ(made.weight, limits::weight);
    EXPECT_EQ(made.learning_rate, 0);
    EXPECT_EQ(made.decay, 0);
    wire.from = MR;
    EXPECT_EQ(set_parameters(graph, wire).refusal, Refusal::missing);
}

TEST(Edit, NeuronKindsCompileAndCoverEveryResponseAndALeakyMemory) {
    std::set<Response> used;
    bool leaky = false;
    for (const NeuronKind& kind : neuron_kinds) {
        const std::array<std::string, 2> eyes{"SL", "SR"};
        EXPECT_TRUE(compile(*add_neuron(aggressor(), make_neuron(kind)).graph, eyes)) << kind.word;
        used.insert(kind.curve.response);
        leaky |= kind.time_constant > 0;
    }
    EXPECT_EQ(used.size(), responses.size());
    EXPECT_TRUE(leaky);
}

TEST(Edit, RefusalsHaveDifferentWords) {
    std::set<std::string_view> words;
    for (const RefusalName& row : refusals) {
        EXPECT_EQ(name(row.value), row.word);
        EXPECT_TRUE(words.insert(row.word).second) << row.word;
    }
}

}  // namespace
}  // namespace braitenlab::tests::edit_test
