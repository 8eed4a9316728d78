#include "core/brain/recogniser.h"

#include <gtest/gtest.h>

#include "core/brain/four_neurons.h"
#include "core/brain/presets.h"

namespace braitenlab {
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

TEST(Recogniser, CallsADeadBrainStillAndABlindOneIndifferent) {
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

TEST(Recogniser, MakesPredatorsOfThoseDrawnAndPreyOfThoseDriven) {
    EXPECT_EQ(attraction(Character::aggressor), 1);
    EXPECT_EQ(attraction(Character::coward), -1);
    EXPECT_EQ(attraction(Character::indifferent), 0);
}

}  // namespace
}  // namespace braitenlab
