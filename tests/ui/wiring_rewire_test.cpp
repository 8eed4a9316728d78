#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/brain/brain.h"
#include "ui/wiring/align.h"
#include "ui/wiring/piece.h"
#include "ui/wiring/rewire.h"

namespace braitenlab::tests::wiring_rewire_test {
namespace {

using maths::vec2;

constexpr NodeId SL = 0, SR = 1, ML = 2, MR = 3;

BrainGraph crossed() { return make_graph({.LR = 1.5f, .RL = 1.5f}); }

// crossed() with `count` neurons from id 4 on.
BrainGraph with_neurons(int count) {
    BrainGraph graph = crossed();
    for (int i = 0; i < count; ++i) graph = *add_neuron(graph).graph;
    return graph;
}

TEST(Reconnect, MovesAWireWithAllItsNumbers) {
    BrainGraph graph = with_neurons(1);
    Wire& wire = *find_wire(graph, SL, MR);
    wire.threshold = 0.3f, wire.learning_rate = 2, wire.cut = true;
    const Edit moved = reconnect(graph, {SL, MR}, {SL, 4});
    ASSERT_TRUE(moved);
    const Wire& there = *find_wire(*moved.graph, SL, 4);
    EXPECT_EQ(there.weight, 1.5f);
    EXPECT_EQ(there.threshold, 0.3f);
    EXPECT_EQ(there.learning_rate, 2);
    EXPECT_TRUE(there.cut);
    EXPECT_EQ(weight_of(*moved.graph, {SL, MR}), 0);
}

TEST(Reconnect, RefusesWhatConnectRefuses) {
    EXPECT_EQ(reconnect(crossed(), {SL, MR}, {SR, ML}).refused, "wiring.refused.duplicate");
    EXPECT_EQ(reconnect(crossed(), {SL, MR}, {SL, SR}).refused, "wiring.refused.into_sensor");
    EXPECT_EQ(reconnect(crossed(), {SL, ML}, {SL, MR}).refused, "wiring.refused.gone");
}

TEST(Insert, KeepsTheWiresNumbersBeforeTheNeuronAndGoesOnWithOne) {
    const Edit edit = insert(with_neurons(1), 4, {SL, MR});
    ASSERT_TRUE(edit);
    EXPECT_EQ(weight_of(*edit.graph, {SL, 4}), 1.5f);
    EXPECT_EQ(weight_of(*edit.graph, {4, MR}), 1);
    EXPECT_EQ(weight_of(*edit.graph, {SL, MR}), 0);
    EXPECT_EQ(insert(*edit.graph, 4, {SL, 4}).refused, "wiring.refused.own_wire");
}

TEST(Detach, TakesEveryWireOffANode) {
    const Edit edit = detach(*insert(with_neurons(1), 4, {SL, MR}).graph, {4});
    ASSERT_TRUE(edit);
    EXPECT_FALSE(is_wired(*edit.graph, 4));
    EXPECT_EQ(weight_of(*edit.graph, {SR, ML}), 1.5f);
    EXPECT_EQ(detach(with_neurons(1), {4}).refused, "wiring.refused.no_wires");
}

TEST(Lesion, HurtsAndHealsAndLosesNoNumber) {
    const Edit hurt = lesion(crossed(), {SL}, {{SR, ML}}, true);
    ASSERT_TRUE(hurt);
    EXPECT_TRUE(all_hurt(*hurt.graph, {SL}, {{SR, ML}}));
    EXPECT_FALSE(all_hurt(*hurt.graph, {SL, SR}, {}));
    EXPECT_EQ(*lesion(*hurt.graph, {SL}, {{SR, ML}}, false).graph, crossed());
    EXPECT_EQ(lesion(crossed(), {}, {}, true).refused, "wiring.refused.nothing_to_cut");
    EXPECT_FALSE(all_hurt(crossed(), {}, {}));
}

TEST(Replace, BringsNumbersIntoTheirRangesAndKeepsWhatIsNotFinite) {
    BrainGraph graph = with_neurons(1);
    Node node = *find_node(graph, 4);
    node.bias = 7, node.time_constant = -1, node.curve.width = 0, node.name = "other";
    node.curve.peak = std::numeric_limits<float>::quiet_NaN();
    const Node made = *find_node(*replace(graph, node).graph, 4);
    EXPECT_EQ(made.bias, limits::bias);
    EXPECT_EQ(made.time_constant, 0);
    EXPECT_GT(made.curve.width, 0);
    EXPECT_EQ(made.curve.peak, 0.5f);
    EXPECT_EQ(made.name, "N1");
    Wire wire = *find_wire(graph, SL, MR);
    wire.weight = 9, wire.learning_rate = -3, wire.decay = std::numeric_limits<float>::infinity();
    const Wire set = *find_wire(*replace(graph, wire).graph, SL, MR);
    EXPECT_EQ(set.weight, limits::weight);
    EXPECT_EQ(set.learning_rate, 0);
    EXPECT_EQ(set.decay, 0);
    wire.from = MR;
    EXPECT_EQ(replace(graph, wire).refused, "wiring.refused.gone");
}

TEST(NeuronKinds, AllCompileAndAreAllResponsesAndAMemory) {
    std::set<Response> responses;
    bool leaky = false;
    for (const NeuronKind& kind : neuron_kinds()) {
        const std::array<std::string, 2> eyes{"SL", "SR"};
        EXPECT_TRUE(compile(*add_neuron(crossed(), kind.made).graph, eyes)) << kind.words;
        responses.insert(kind.made.curve.response);
        leaky |= kind.made.time_constant > 0;
    }
    EXPECT_EQ(responses.size(), 6u);
    EXPECT_TRUE(leaky);
}

TEST(Paste, GivesNewIdsAndFreeNamesAndKeepsTheWiresAmongThem) {
    BrainGraph graph = with_neurons(2);
    graph = *connect(graph, {4, 5}).graph;
    graph = *connect(graph, {SL, 4}).graph;
    graph = *connect(graph, {5, ML}).graph;
    find_node(graph, "N2")->name = "AND";
    const BrainPiece piece = copy(graph, lay_out(graph, {}), {4, 5, ML});
    const Pasted pasted = paste(graph, piece, {100, 50});
    ASSERT_TRUE(pasted.edit);
    const BrainGraph& made = *pasted.edit.graph;
    EXPECT_EQ(pasted.nodes, (std::set<NodeId>{6, 7}));
    EXPECT_EQ(weight_of(made, {6, 7}), 1);
    EXPECT_EQ(weight_of(made, {7, ML}), 1) << "the motor was selected too";
    EXPECT_EQ(weight_of(made, {SL, 6}), 0) << "the eye was not";
    EXPECT_NE(find_node(made, 6)->name, find_node(made, 7)->name);
    const std::array<std::string, 2> eyes{"SL", "SR"};
    EXPECT_TRUE(compile(made, eyes));
    const vec2 middle = (*find_node(made, 6)->place + *find_node(made, 7)->place) / 2;
    EXPECT_LT(maths::distance(middle, {100, 50}), 1);
}

TEST(Paste, LeavesOutWiresToWhatTheOtherBrainLacks) {
    BrainGraph graph = *connect(with_neurons(1), {SL, 4}).graph;
    const BrainPiece piece = copy(graph, lay_out(graph, {}), {4, SL});
    const Pasted pasted = paste(BrainGraph{}, piece, {});
    ASSERT_TRUE(pasted.edit);
    EXPECT_EQ(pasted.edit.graph->nodes.size(), 1u);
    EXPECT_TRUE(pasted.edit.graph->wires.empty());
}

TEST(Paste, RefusesAnEmptyPieceAndAFullBrain) {
    EXPECT_EQ(paste(crossed(), {}, {}).edit.refused, "wiring.refused.nothing_copied");
    const BrainGraph graph = with_neurons(1);
    const BrainPiece piece = copy(graph, lay_out(graph, {}), {4});
    BrainGraph full = crossed();
    for (int i = 0; i < limits::neurons; ++i) {
        Node node;
        node.id = 4 + i, node.name = "X" + std::to_string(i);
        full.nodes.push_back(node);
    }
    EXPECT_EQ(paste(full, piece, {}).edit.refused, "wiring.refused.neurons");
}

TEST(PutInOrder, LinesUpAndKeepsCardsApart) {
    const Layout layout = lay_out(with_neurons(3), {{4, {0, 0}}, {5, {90, 10}}, {6, {30, 400}}});
    const Places column = put_in_order(layout, {4, 5, 6}, Order::column);
    EXPECT_EQ(column.at(4).x, 40);
    EXPECT_EQ(column.at(5).x, 40);
    EXPECT_GT(column.at(5).y - column.at(4).y, 80) << "they would have covered each other";
    EXPECT_EQ(column.at(6).y, 400);
    const Places even = put_in_order(layout, {4, 5, 6}, Order::even_down);
    EXPECT_EQ(even.at(5).y, 200);
    EXPECT_EQ(even.at(5).x, 90);
    EXPECT_TRUE(put_in_order(layout, {4}, Order::row).empty());
    EXPECT_TRUE(put_in_order(layout, {4, 5}, Order::even_across).empty());
}

}  // namespace
}  // namespace braitenlab::tests::wiring_rewire_test
