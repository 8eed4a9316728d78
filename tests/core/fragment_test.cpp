#include "core/brain/fragment.h"

#include <gtest/gtest.h>

#include "core/brain/brain.h"
#include "core/brain/four_neurons.h"

namespace braitenlab::tests::fragment_test {
namespace {

using maths::vec2;

using namespace four_neuron_ids;

// Two eyes, two motors and `count` neurons from id 4 on, side by side.
BrainGraph row_of_neurons(int count) {
    BrainGraph graph = make_graph({.LR = 1.5f, .RL = 1.5f});
    for (int i = 0; i < count; ++i) {
        graph = *add_neuron(graph).graph;
        graph.nodes.back().place = {200.0f * static_cast<float>(i), 7};
    }
    return graph;
}

TEST(Fragment, PasteGivesNewIdsAndFreeNamesAndKeepsTheWiresAmongThem) {
    BrainGraph graph = row_of_neurons(2);
    graph = *connect(graph, {4, 5}).graph;
    graph = *connect(graph, {SL, 4}).graph;
    graph = *connect(graph, {5, ML}).graph;
    find_node(graph, "N2")->name = "AND";
    const Pasted pasted = paste_fragment(graph, copy_fragment(graph, {4, 5, ML}), {100, 50});
    ASSERT_TRUE(pasted.edit);
    const BrainGraph& made = *pasted.edit.graph;
    EXPECT_EQ(pasted.added, (std::set<NodeId>{6, 7}));
    EXPECT_EQ(weight_of(made, {6, 7}), 1);
    EXPECT_EQ(weight_of(made, {7, ML}), 1) << "the motor was selected too";
    EXPECT_EQ(weight_of(made, {SL, 6}), 0) << "the eye was not";
    EXPECT_NE(find_node(made, 6)->name, find_node(made, 7)->name);
    const std::array<std::string, 2> eyes{"SL", "SR"};
    EXPECT_TRUE(compile(made, eyes));
}

TEST(Fragment, PasteKeepsTheArrangementAroundTheGivenCentre) {
    const BrainGraph graph = row_of_neurons(2);
    const Pasted pasted = paste_fragment(graph, copy_fragment(graph, {4, 5}), {100.4f, 50});
    ASSERT_TRUE(pasted.edit);
    EXPECT_EQ(find_node(*pasted.edit.graph, 6)->place, (vec2{0, 50}));
    EXPECT_EQ(find_node(*pasted.edit.graph, 7)->place, (vec2{200, 50}));
}

TEST(Fragment, PasteOmitsWiresToNodesThatTheOtherBrainLacks) {
    const BrainGraph graph = *connect(row_of_neurons(1), {SL, 4}).graph;
    const Pasted pasted = paste_fragment(BrainGraph{}, copy_fragment(graph, {4, SL}), {});
    ASSERT_TRUE(pasted.edit);
    EXPECT_EQ(pasted.edit.graph->nodes.size(), 1u);
    EXPECT_TRUE(pasted.edit.graph->wires.empty());
}

TEST(Fragment, PasteRefusesAnEmptyFragmentAndAFullBrain) {
    const BrainGraph graph = row_of_neurons(1);
    EXPECT_EQ(paste_fragment(graph, {}, {}).edit.refusal, Refusal::empty_fragment);
    BrainGraph full = make_graph({});
    for (int i = 0; i < limits::neurons; ++i)
        full.nodes.push_back({.id = 4 + i, .kind = NodeKind::neuron, .name = "X" + std::to_string(i)});
    EXPECT_EQ(paste_fragment(full, copy_fragment(graph, {4}), {}).edit.refusal, Refusal::too_many_neurons);
}

TEST(Fragment, RoundedPositionIsAWholeUnitOnTheCanvas) {
    EXPECT_EQ(rounded_position({1.4f, -2.6f}), (vec2{1, -3}));
    EXPECT_EQ(rounded_position({2e5f, -2e5f}), (vec2{limits::place, -limits::place}));
}

}  // namespace
}  // namespace braitenlab::tests::fragment_test
