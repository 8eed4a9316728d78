#include <limits>

#include <gtest/gtest.h>

#include "ui/wiring/edit.h"

namespace braitenlab::tests::wiring_edit_test {
namespace {

constexpr NodeId SL = 0, SR = 1, ML = 2, MR = 3;

BrainGraph aggressor() {
    FourNeurons four;
    four.LR = four.RL = 1.5f;
    four.LM = four.RM = 0.1f;
    return make_graph(four);
}

// SL and SR feed a hidden neuron N1, which feeds ML.
BrainGraph with_hidden() {
    const Edit added = add_neuron(aggressor());
    const NodeId neuron = fresh_id(aggressor());
    const Edit in = connect(*added.graph, {SL, neuron});
    return *connect(*in.graph, {neuron, ML}).graph;
}

TEST(Connect, TurnsAGhostIntoAWireOfWeightOne) {
    const Edit edit = connect(aggressor(), {SL, ML});
    ASSERT_TRUE(edit);
    EXPECT_EQ(read_dials(*edit.graph).LL, 1);
    EXPECT_TRUE(is_four_neurons(*edit.graph));
}

TEST(Connect, RefusesAWireThatIsThereAlready) {
    const Edit edit = connect(aggressor(), {SL, MR});
    EXPECT_FALSE(edit);
    EXPECT_EQ(edit.refused, "wiring.refused.duplicate");
}

TEST(Connect, RefusesAWireIntoASensor) {
    EXPECT_EQ(connect(aggressor(), {SL, SR}).refused, "wiring.refused.into_sensor");
    EXPECT_EQ(connect(with_hidden(), {4, SL}).refused, "wiring.refused.into_sensor");
}

TEST(Connect, RefusesAnEndThatIsGone) { EXPECT_EQ(connect(aggressor(), {SL, 99}).refused, "wiring.refused.gone"); }

TEST(Connect, LetsANeuronFeedItself) {
    const Edit edit = connect(with_hidden(), {4, 4});
    ASSERT_TRUE(edit);
    EXPECT_EQ(weight_of(*edit.graph, {4, 4}), 1);
}

TEST(SetWeight, ClampsToTheRangeAndIgnoresWhatIsNotFinite) {
    EXPECT_EQ(weight_of(*set_weight(aggressor(), {SL, MR}, 9).graph, {SL, MR}), 2);
    EXPECT_EQ(weight_of(*set_weight(aggressor(), {SL, MR}, -9).graph, {SL, MR}), -2);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(*set_weight(aggressor(), {SL, MR}, nan).graph, aggressor());
}

TEST(AddNeuron, TakesTheNextIdAndAFreeName) {
    const BrainGraph graph = with_hidden();
    const Edit edit = add_neuron(graph);
    ASSERT_TRUE(edit);
    EXPECT_EQ(edit.graph->nodes.back().id, 5);
    EXPECT_EQ(edit.graph->nodes.back().name, "N2");
    EXPECT_EQ(edit.graph->nodes.back().kind, NodeKind::neuron);
}

TEST(Remove, LeavesADirectWiresPlaceReadingZero) {
    BrainGraph graph = aggressor();
    find_wire(graph, SL, MR)->threshold = 0.3f;
    const Edit edit = remove(graph, {}, {{SL, MR}});
    ASSERT_TRUE(edit);
    EXPECT_EQ(read_dials(*edit.graph).RL, 0);
    EXPECT_EQ(read_dials(*edit.graph).threshold_RL, 0);
    EXPECT_EQ(read_dials(*edit.graph).LR, 1.5f);
    EXPECT_TRUE(is_four_neurons(*edit.graph));
}

TEST(Remove, TakesANeuronsWiresWithIt) {
    const Edit edit = remove(with_hidden(), {4}, {});
    ASSERT_TRUE(edit);
    EXPECT_EQ(*edit.graph, aggressor());
}

TEST(Remove, TakesAnyOtherWireOutAltogether) {
    const Edit edit = remove(with_hidden(), {}, {{SL, 4}});
    ASSERT_TRUE(edit);
    EXPECT_EQ(find_wire(*edit.graph, SL, 4), nullptr);
    EXPECT_NE(find_wire(*edit.graph, 4, ML), nullptr);
}

TEST(Remove, RefusesSensorsAndMotorsAndWhatIsNotThere) {
    EXPECT_EQ(remove(aggressor(), {SL, MR}, {}).refused, "wiring.refused.fixed");
    EXPECT_EQ(remove(aggressor(), {}, {{SL, ML}}).refused, "wiring.refused.nothing");
}

TEST(DirectDial, KnowsTheFourWiresOfTheSliders) {
    const BrainGraph graph = with_hidden();
    EXPECT_EQ(direct_dial(graph, {SL, ML}), Dial::LL);
    EXPECT_EQ(direct_dial(graph, {SR, ML}), Dial::LR);
    EXPECT_EQ(direct_dial(graph, {SL, MR}), Dial::RL);
    EXPECT_EQ(direct_dial(graph, {SR, MR}), Dial::RR);
    EXPECT_FALSE(direct_dial(graph, {SL, 4}));
    EXPECT_FALSE(direct_ends(BrainGraph{}, Dial::LL));
}

TEST(WireName, IsTheSlidersOrBothEnds) {
    EXPECT_EQ(wire_name(with_hidden(), {SR, ML}), "LR");
    EXPECT_EQ(wire_name(with_hidden(), {4, ML}), "N1-ML");
}

}  // namespace
}  // namespace braitenlab::tests::wiring_edit_test
