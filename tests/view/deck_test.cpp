#include "render/view/deck.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/view/hand_made.h"

namespace braitenlab::tests::deck_test {
namespace {

using namespace render;

Kind two_eyed() {
    Kind kind;
    kind.sensors = hand_made::two_eyes(Channel::light);
    return kind;
}

NodeId add_neuron(BrainGraph& brain) {
    Node node;
    node.id = static_cast<NodeId>(brain.nodes.size()) + 1;
    node.name = "N" + std::to_string(node.id);
    brain.nodes.push_back(node);
    return node.id;
}

void join(BrainGraph& brain, NodeId from, NodeId to, float weight = 1) {
    Wire wire;
    wire.from = from, wire.to = to, wire.weight = weight;
    brain.wires.push_back(wire);
}

const DeckNeuron& neuron(const DeckPlan& plan, NodeId id) {
    return *std::find_if(plan.neurons.begin(), plan.neurons.end(), [&](auto& n) { return n.id == id; });
}

// Sensors 1 and 2, motors 3 and 4.
TEST(Deck, PlacesNeuronsBetweenSensorsAndWheelsInSignalOrder) {
    BrainGraph brain = hand_made::wired(0, 0, 0, 0);
    const NodeId near = add_neuron(brain), far = add_neuron(brain);
    join(brain, 1, near), join(brain, near, far), join(brain, far, 4);
    const DeckPlan plan = plan_deck(brain, two_eyed());
    ASSERT_EQ(plan.neurons.size(), 2U);
    EXPECT_EQ(plan.wires.size(), 3U);
    EXPECT_LT(neuron(plan, near).place.x, 0.30f);
    EXPECT_LT(neuron(plan, far).place.x, neuron(plan, near).place.x);
    EXPECT_GT(neuron(plan, far).place.x, -0.2f);
}

TEST(Deck, ReportsSilencedSensorsAndMotors) {
    BrainGraph brain = hand_made::wired(1, 0, 0, 1);
    EXPECT_EQ(plan_deck(brain, two_eyed()).covered, (std::vector<bool>{false, false}));
    brain.nodes[1].silenced = true, brain.nodes[2].silenced = true;  // SR, ML
    const DeckPlan plan = plan_deck(brain, two_eyed());
    EXPECT_EQ(plan.covered, (std::vector<bool>{false, true}));
    EXPECT_EQ(plan.stopped, (std::array{true, false}));
}

TEST(Deck, KeepsNeuronsOnTheSideOfTheirInputs) {
    BrainGraph brain = hand_made::wired(0, 0, 0, 0);
    const NodeId left = add_neuron(brain), right = add_neuron(brain);
    join(brain, 2, right), join(brain, 1, left), join(brain, left, 3), join(brain, right, 4);
    const DeckPlan plan = plan_deck(brain, two_eyed());
    EXPECT_GT(neuron(plan, left).place.y, 0.02f);
    EXPECT_LT(neuron(plan, right).place.y, -0.02f);
}

TEST(Deck, KeepsNeuronsApartAndOnTheDeck) {
    BrainGraph brain = hand_made::wired(0, 0, 0, 0);
    for (int i = 0; i < 9; ++i) join(brain, 1 + i % 2, add_neuron(brain));
    const DeckPlan plan = plan_deck(brain, two_eyed());
    ASSERT_EQ(plan.neurons.size(), 9U);
    for (const DeckNeuron& a : plan.neurons) {
        EXPECT_LT(std::fabs(a.place.y), 0.3f);
        for (const DeckNeuron& b : plan.neurons) {
            if (a.id == b.id) continue;
            EXPECT_GT(maths::distance(a.place, b.place), 2 * plan.neuron_radius);
        }
    }
}

TEST(Deck, AcceptsCyclesSelfLoopsAndNeuronsWithoutInput) {
    BrainGraph brain = hand_made::wired(0, 0, 0, 0);
    const NodeId a = add_neuron(brain), b = add_neuron(brain), alone = add_neuron(brain);
    join(brain, a, b), join(brain, b, a), join(brain, a, a), join(brain, alone, 3);
    const DeckPlan plan = plan_deck(brain, two_eyed());
    EXPECT_EQ(plan.neurons.size(), 3U);
    ASSERT_EQ(plan.wires.size(), 4U);
    for (const DeckWire& wire : plan.wires) {
        EXPECT_TRUE(std::isfinite(wire.bend.x + wire.bend.y + wire.to.x + wire.to.y));
        EXPECT_GT(maths::distance(wire.from, wire.to) + maths::distance(wire.from, wire.bend), 0.01f);
    }
}

TEST(Deck, OmitsWiresOfWeightZeroUnlessTheyLearn) {
    BrainGraph brain = hand_made::wired(0, 1, 0, 0);  // leaves weights of 0 in
    EXPECT_EQ(plan_deck(brain, two_eyed()).wires.size(), 1U);
    brain.wires[0].learning_rate = 1;
    EXPECT_EQ(plan_deck(brain, two_eyed()).wires.size(), 2U);
}

TEST(Deck, KeepsTheStrongestWiresOfALargeBrain) {
    BrainGraph brain = hand_made::wired(0, 0, 0, 0);
    for (int i = 0; i < 30; ++i) add_neuron(brain);
    for (NodeId from = 5; from < 35; ++from)
        for (NodeId to = 5; to < 35; ++to) join(brain, from, to, from == 7 ? 2.0f : 0.1f);
    const DeckPlan plan = plan_deck(brain, two_eyed());
    EXPECT_EQ(plan.wires.size(), most_deck_wires);
    const auto strong = std::count_if(plan.wires.begin(), plan.wires.end(),
                                      [&](const DeckWire& w) { return brain.wires[w.wire].from == 7; });
    EXPECT_EQ(strong, 30);
}

TEST(Deck, PlacesTheLargestBrain) {
    BrainGraph brain = hand_made::wired(1, 1, 1, 1);
    NodeId last = 1;
    for (int i = 0; i < 1000; ++i) {
        const NodeId next = add_neuron(brain);
        join(brain, last, next);
        last = next;
    }
    const DeckPlan plan = plan_deck(brain, two_eyed());
    EXPECT_EQ(plan.neurons.size(), most_deck_neurons);
    EXPECT_LE(plan.wires.size(), most_deck_wires);
}

}  // namespace
}  // namespace braitenlab::tests::deck_test
