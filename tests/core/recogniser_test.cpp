#include "core/brain/recogniser.h"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/brain/brain.h"
#include "core/brain/four_neurons.h"
#include "core/brain/presets.h"
#include "core/maths/random.h"

namespace braitenlab::tests::recogniser_test {
namespace {

Character of(const FourNeurons& four) { return recognise(make_graph(four)); }

TEST(Recogniser, NamesTheClassicVehicles) {
    const auto preset = [](std::string_view name) {
        const Preset* found = find_preset(name);
        return found ? recognise(found->brain) : Character::mixed;
    };
    EXPECT_EQ(preset("1-alive"), Character::alive);
    EXPECT_EQ(preset("2a-coward"), Character::coward);
    EXPECT_EQ(preset("2b-aggressor"), Character::aggressor);
    EXPECT_EQ(preset("2c"), Character::alive);
    EXPECT_EQ(preset("3a-love"), Character::love);
    EXPECT_EQ(preset("3b-explorer"), Character::explorer);
}

TEST(Recogniser, CallsABrainWithoutDriveStillAndOneWithoutWiresIndifferent) {
    EXPECT_EQ(of({}), Character::still);
    EXPECT_EQ(of({.LM = 0.5f, .RM = 0.5f}), Character::indifferent);
}

TEST(Recogniser, JudgesTheResponseNotTheWires) {
    // A coward whose signals pass through a hidden neuron on each side.
    BrainGraph graph = make_graph({});
    graph.wires.clear();
    graph.nodes.push_back({.id = 10, .kind = NodeKind::neuron, .name = "left"});
    graph.nodes.push_back({.id = 11, .kind = NodeKind::neuron, .name = "right"});
    graph.wires = {{.from = 0, .to = 10, .weight = 0.5f},
                   {.from = 10, .to = 2, .weight = 2},
                   {.from = 1, .to = 11, .weight = 0.5f},
                   {.from = 11, .to = 3, .weight = 2}};
    EXPECT_EQ(recognise(graph), Character::coward);
}

TEST(Recogniser, NamesDrowsyAndOrbitingBrains) {
    EXPECT_EQ(of({.LL = -0.3f, .LR = -0.3f, .RL = -0.3f, .RR = -0.3f, .LM = 0.6f, .RM = 0.6f}), Character::drowsy);
    EXPECT_EQ(recognise(find_preset("4a-orbit")->brain), Character::orbiting);
    EXPECT_EQ(recognise(find_preset("4b-decision")->brain), Character::aggressor);
    EXPECT_EQ(recognise(find_preset("5-logic")->brain), Character::indifferent);
    EXPECT_EQ(of({.LL = 1.5f, .RR = 1.5f, .threshold_LL = 0.7f, .threshold_RR = 0.7f}), Character::coward);
}

TEST(Recogniser, CallsOtherResponsesMixed) {
    EXPECT_EQ(of({.LL = 1, .LM = 0.2f, .RM = 0.2f}), Character::mixed);  // one eye: turns right for every stimulus
    EXPECT_EQ(of({.LL = 0.7f, .LR = 0.7f, .LM = 0.2f, .RM = 0.2f}), Character::mixed);
    EXPECT_EQ(of({.LL = 0.5f, .LR = -0.5f, .RL = -0.5f, .RR = 0.5f}), Character::mixed);  // turns on the spot
    BrainGraph two_sided =
        make_graph({.LR = 1, .RL = 1, .LM = 0.4f, .RM = 0.4f});  // away from weak stimuli, towards strong ones
    for (Wire& wire : two_sided.wires)
        if (wire.weight != 0) wire.curve = {Response::hump, 0, 0.3f};
    find_wire(two_sided, 0, 2)->weight = find_wire(two_sided, 1, 3)->weight = -0.3f;
    EXPECT_EQ(recognise(two_sided), Character::mixed);
}

// A neuron that switches from forwards to backwards leaves no strength at which the vehicle rests.
TEST(Recogniser, CallsAVehicleLoveOnlyIfItCanRest) {
    for (const auto& [response, character] :
         {std::pair{Response::step, Character::mixed}, {Response::rectified, Character::love}}) {
        BrainGraph graph = make_graph({.LR = 1, .RL = 1, .LM = 0.1f, .RM = 0.1f});
        graph.nodes.push_back(
            {.id = 50, .kind = NodeKind::neuron, .name = "N1", .curve = {.response = response, .peak = 0.9f}});
        for (const NodeId eye : {0, 1}) graph.wires.push_back({.from = eye, .to = 50, .weight = 1});
        for (const NodeId motor : {2, 3}) graph.wires.push_back({.from = 50, .to = motor, .weight = -1.4f});
        EXPECT_EQ(recognise(graph), character) << static_cast<int>(response);
    }
}

TEST(Recogniser, IgnoresUnequalBiases) {
    EXPECT_EQ(of({.LL = 0.5f, .RR = 0.5f, .LM = 0.5f, .RM = 0.1f}), Character::coward);
    EXPECT_EQ(of({.LR = 1, .RL = 1, .LM = 0.1f, .RM = 0.3f}), Character::aggressor);
}

TEST(Recogniser, NamesEachSenseSeparately) {
    const BrainGraph& values = find_preset("3c-values")->brain;
    EXPECT_EQ(recognise(values), Character::aggressor);
    EXPECT_EQ(recognise(values, {"HL", "HR"}), Character::coward);
    EXPECT_EQ(recognise(values, {"NL", "NR"}), Character::love);
    EXPECT_EQ(recognise(values, {"AL", "AR"}), Character::explorer);
    EXPECT_EQ(recognise(values, {"XL", "XR"}), Character::indifferent);
}

TEST(Recogniser, ReportsThatLowEnergyChangesATortoise) {
    const BrainGraph& tortoise = find_preset("tortoise")->brain;
    const std::array fed{Reading{"EN", 1}}, hungry{Reading{"EN", 0.2f}};
    const std::array at_home{Reading{"EN", 0.2f}, Reading{"UP", 1}};
    EXPECT_EQ(recognise(tortoise, {}, fed), Character::orbiting);
    EXPECT_EQ(recognise(tortoise, {}, hungry), Character::aggressor);
    EXPECT_NE(recognise(tortoise, {}, at_home), Character::aggressor);
}

// Replaces each wire from a sensor to a motor by two neurons that deliver half of it each.
void split_direct_wires(BrainGraph& graph) {
    const std::vector<Wire> wires = std::move(graph.wires);
    graph.wires.clear();
    for (const Wire& wire : wires) {
        const bool direct = find_node(graph, wire.from)->kind == NodeKind::sensor &&
                            find_node(graph, wire.to)->kind == NodeKind::motor && !learns(wire);
        if (!direct) {
            graph.wires.push_back(wire);
            continue;
        }
        for (int half = 0; half < 2; ++half) {
            const NodeId id = static_cast<NodeId>(graph.nodes.size());
            graph.nodes.push_back({.id = id, .kind = NodeKind::neuron, .name = fmt::format("half{}", id)});
            graph.wires.push_back({.from = wire.from, .to = id, .weight = 1});
            graph.wires.push_back(wire);
            graph.wires.back().from = id;
            graph.wires.back().weight /= 2;
        }
    }
}

// Replaces a neuron by two with the same inputs that deliver half each, also to each other.
void split_neuron(BrainGraph& graph, NodeId original) {
    const NodeId twin = static_cast<NodeId>(graph.nodes.size());
    graph.nodes.push_back(*find_node(graph, original));
    graph.nodes.back().id = twin;
    graph.nodes.back().name += "_twin";
    const auto add = [&](Wire wire, NodeId from, NodeId to, float share) {
        wire.from = from, wire.to = to, wire.weight *= share;
        graph.wires.push_back(wire);
    };
    const std::vector<Wire> wires = std::move(graph.wires);
    graph.wires.clear();
    for (const Wire& wire : wires) {
        const bool out = wire.from == original, in = wire.to == original;
        for (const NodeId from : {wire.from, twin}) {
            if (from == twin && !out) continue;
            add(wire, from, wire.to, out ? 0.5f : 1);
            if (in) add(wire, from, twin, out ? 0.5f : 1);
        }
    }
}

// The same response with other names, ids and order, and some neurons split in two.
BrainGraph redrawn(BrainGraph graph, maths::Random& chance) {
    const auto coin = [&] { return chance.uniform(0, 1) < 0.5f; };
    if (coin()) split_direct_wires(graph);
    std::vector<NodeId> hidden;
    for (const Node& node : graph.nodes) {
        const bool teaches = std::any_of(graph.wires.begin(), graph.wires.end(), [&](const Wire& w) {
            return learns(w) && (w.from == node.id || w.to == node.id);
        });
        if (node.kind == NodeKind::neuron && !teaches && coin()) hidden.push_back(node.id);
    }
    for (const NodeId id : hidden) split_neuron(graph, id);

    const auto shuffle = [&](auto& things) {
        for (std::size_t i = things.size(); i > 1; --i)
            std::swap(things[i - 1], things[static_cast<std::size_t>(chance.uniform(0, static_cast<float>(i)))]);
    };
    std::vector<NodeId> ids(graph.nodes.size());
    for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<NodeId>(3 * i + 5);
    shuffle(ids);
    std::map<NodeId, NodeId> renumbered;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        Node& node = graph.nodes[i];
        renumbered[node.id] = ids[i];
        node.id = ids[i];
        if (node.kind == NodeKind::neuron) node.name = fmt::format("n{}", ids[i]);
    }
    for (Wire& wire : graph.wires) wire.from = renumbered[wire.from], wire.to = renumbered[wire.to];
    shuffle(graph.nodes);
    shuffle(graph.wires);
    return graph;
}

TEST(Recogniser, GivesAPresetTheSameNameInAnyEquivalentWiring) {
    maths::Random chance{7, 7};
    for (const Preset& preset : presets())
        for (const SensorPair& eyes :
             {SensorPair{}, SensorPair{"HL", "HR"}, SensorPair{"NL", "NR"}, SensorPair{"AL", "AR"}}) {
            if (!find_node(preset.brain, eyes.left)) continue;
            const Character original = recognise(preset.brain, eyes);
            for (int trial = 0; trial < 20; ++trial) {
                const BrainGraph other = redrawn(preset.brain, chance);
                ASSERT_FALSE(check_graph(other)) << check_graph(other)->what;
                ASSERT_EQ(recognise(other, eyes), original) << preset.name << ' ' << eyes.left << ' ' << trial;
            }
        }
}

TEST(Recogniser, AttractionIsPositiveForAggressorsAndNegativeForCowards) {
    EXPECT_EQ(attraction(Character::aggressor), 1);
    EXPECT_EQ(attraction(Character::coward), -1);
    EXPECT_EQ(attraction(Character::indifferent), 0);
}

}  // namespace
}  // namespace braitenlab::tests::recogniser_test
