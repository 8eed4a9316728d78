#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/brain/four_neurons.h"
#include "ui/wiring/node_text.h"

namespace braitenlab::tests::wiring_node_text_test {

using namespace wiring;

namespace {

using namespace four_neuron_ids;

float seen(NodeId id) { return id == 0 ? 0.42f : id == 1 ? 0.27f : 0.44f; }

TEST(WiringNodeText, SumHasProductsBiasAndValue) {
    FourNeurons four;
    four.LL = 0.8f, four.LM = 0.1f;
    EXPECT_EQ(sum_text(make_graph(four), ML, seen), "0.42·0.80 + 0.10 → 0.44");
}

TEST(WiringNodeText, SumOfAMotorShowsThatItIsLimited) {
    const auto over = [](NodeId id) { return id == SL ? 0.5f : 1.1f; };
    const BrainGraph graph = make_graph({.LL = 2, .LM = 0.1f});
    EXPECT_EQ(sum_text(graph, ML, over), "0.50·2.00 + 0.10 = 1.10 → 1.00");
    EXPECT_EQ(sum_text(graph, ML, over, {}, ','), "0,50·2,00 + 0,10 = 1,10 → 1,00");
    EXPECT_EQ(sum_text(graph, ML, over, {}, '.', [](NodeId id) { return id == SL ? "SL" : "?"; }),
              "SL 0.50·2.00 + 0.10 = 1.10 → 1.00");
    EXPECT_EQ(shown_value(*find_node(graph, "ML"), -1.1f), -1);
    EXPECT_EQ(shown_value(*find_node(graph, "SL"), 1.1f), 1.1f);
}

TEST(WiringNodeText, ASumWhoseRoundedNumbersGiveAnotherIsMarked) {
    const auto with_value = [](float motor) {
        return [motor](NodeId id) { return id == SL ? 0.3551f : motor; };  // 0.3551 × 1.5 + 0.1 = 0.6327
    };
    BrainGraph graph = make_graph({.LL = 1.5f, .LM = 0.1f});
    EXPECT_EQ(sum_text(graph, ML, with_value(0.63265f)), "0.36·1.50 + 0.10 ≈ 0.63");
    EXPECT_EQ(sum_text(graph, ML, with_value(0.5f)), "0.36·1.50 + 0.10 → 0.50") << "with memory";
    find_node(graph, "ML")->curve.response = Response::inverted;
    EXPECT_EQ(sum_text(graph, ML, with_value(0.5f)).substr(0, 27), "0.36·1.50 + 0.10 ≈ 0.63\n");
}

TEST(WiringNodeText, ANegativeWeightIsAFactorAsOnTheBrainCard) {
    FourNeurons four;
    four.RR = -0.5f, four.RL = -1, four.RM = -0.1f;
    EXPECT_EQ(sum_text(make_graph(four), MR, seen), "0.42·(−1.00) + 0.27·(−0.50) − 0.10 → 0.44");
}

TEST(WiringNodeText, SumTellsTheInputThatAThresholdMasks) {
    FourNeurons four;
    four.LL = 1, four.threshold_LL = 0.9f;
    EXPECT_EQ(sum_text(make_graph(four), ML, seen), "(0.42 < θ)·1.00 → 0.44");
}

TEST(WiringNodeText, SumIsZeroWithoutWiresAndEmptyForASensor) {
    EXPECT_EQ(sum_text(make_graph({}), ML, seen), "0.00 → 0.44");
    EXPECT_EQ(sum_text(make_graph({}), SL, seen), "");
}

TEST(WiringNodeText, SumHasTheCurveInASeparateLine) {
    BrainGraph graph = make_graph({.LL = 0.5f, .LM = 0.1f});
    find_node(graph, "ML")->curve.response = Response::inverted;
    EXPECT_EQ(sum_text(graph, ML, seen), "0.42·0.50 + 0.10 = 0.31\nf(0.31) = 0.69 → 0.44");
    EXPECT_NEAR(sum_of(graph, ML, seen), 0.31f, 1e-6f);
}

TEST(WiringNodeText, SumOfAStepIsComparedWithItsThreshold) {
    BrainGraph graph = make_graph({.LL = 0.5f, .LM = 0.1f});
    find_node(graph, "ML")->curve = {Response::step, 1.5f};
    EXPECT_EQ(sum_text(graph, ML, seen), "0.42·0.50 + 0.10 = 0.31 < 1.50 → 0.44");
    find_node(graph, "ML")->curve.peak = 0.25f;
    EXPECT_EQ(sum_text(graph, ML, seen), "0.42·0.50 + 0.10 = 0.31 ≥ 0.25 → 0.44");
}

TEST(WiringNodeText, SumOmitsCutWiresAndAddsTheLearnedPart) {
    BrainGraph graph = make_graph({.LL = 0.5f, .LR = 1});
    find_wire(graph, 1, ML)->cut = true;
    EXPECT_EQ(sum_text(graph, ML, seen), "0.42·0.50 → 0.44");
    find_wire(graph, SL, ML)->learning_rate = 1;
    EXPECT_EQ(sum_text(graph, ML, seen, [](const Wire& w) { return learns(w) ? 0.25f : 0; }), "0.42·0.75 → 0.44");
}

TEST(WiringNodeText, ShortNamesShowTheChannelAndTheSideOfASensorWithACode) {
    const auto sensor = [](std::string name, Channel channel, float y) {
        Sensor made;
        made.name = std::move(name), made.channel = channel, made.y = y, made.angle = 0;
        return made;
    };
    const std::vector<Sensor> sensors{sensor("SL", Channel::light, 0.2f),  sensor("HL", Channel::heat, 0.2f),
                                      sensor("HR2", Channel::heat, -0.2f), sensor("EN", Channel::energy, 0),
                                      sensor("SR", Channel::red, -0.2f),   sensor("nose", Channel::smell, 0),
                                      sensor("HOT", Channel::heat, 0.2f)};
    EXPECT_EQ(short_name(sensors, "SL"), "SL") << "a name of the four wires";
    EXPECT_EQ(short_name(sensors, "HL"), std::string(channel_symbol(Channel::heat)) + "L");
    EXPECT_EQ(short_name(sensors, "HR2"), std::string(channel_symbol(Channel::heat)) + "R2");
    EXPECT_EQ(short_name(sensors, "EN"), channel_symbol(Channel::energy)) << "has no side";
    EXPECT_EQ(short_name(sensors, "SR"), std::string(channel_symbol(Channel::red)) + "R");
    EXPECT_EQ(short_name(sensors, "nose"), "nose") << "a name that a person gave";
    EXPECT_EQ(short_name(sensors, "HOT"), "HOT") << "a word";
    EXPECT_EQ(short_name(sensors, "N1"), "N1") << "a neuron";
}

TEST(WiringNodeText, AWireHasTheNamesThatItsNodesHaveInTheDiagram) {
    std::vector<Sensor> eyes(2);
    eyes[0].name = "SL", eyes[0].channel = Channel::red, eyes[0].y = 0.2f;
    eyes[1].name = "SR", eyes[1].channel = Channel::light, eyes[1].y = -0.2f;
    BrainGraph graph = make_graph({.LL = 1});
    graph.nodes.push_back({.id = 9, .kind = NodeKind::neuron, .name = "N1"});
    EXPECT_EQ(short_wire_name(eyes, graph, {SL, 9}), short_name(eyes, "SL") + "-N1");
    EXPECT_NE(short_wire_name(eyes, graph, {SL, 9}), "SL-N1");
    EXPECT_EQ(short_wire_name(eyes, graph, {SR, 9}), "SR-N1") << "an eye for light keeps the name that is learnt";
    EXPECT_EQ(short_wire_name(eyes, graph, {SL, ML}), "LL");
    EXPECT_EQ(short_wire_name(eyes, graph, {9, MR}), "N1-MR");
}

TEST(WiringNodeText, EachChannelHasASymbolOfItsOwn) {
    std::set<std::string_view> symbols;
    for (const ChannelTraits& row : channel_table) {
        EXPECT_FALSE(channel_symbol(row.value).empty()) << row.word;
        EXPECT_TRUE(symbols.insert(channel_symbol(row.value)).second) << row.word;
    }
}

}  // namespace
}  // namespace braitenlab::tests::wiring_node_text_test
