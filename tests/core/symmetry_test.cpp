#include "core/brain/symmetry.h"

#include <string>

#include <gtest/gtest.h>

#include "core/brain/four_neurons.h"
#include "core/brain/recogniser.h"

namespace braitenlab::tests::symmetry_test {

namespace {

Wire* wire(BrainGraph& brain, const char* from, const char* to) {
    return find_wire(brain, find_node(brain, std::string(from))->id, find_node(brain, std::string(to))->id);
}

}  // namespace

TEST(Symmetry, MirroredMakesTheRightSideTheMirrorImageOfTheLeft) {
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

TEST(Symmetry, MirroredDoesNotChangeASymmetricBrain) {
    const BrainGraph brain = make_graph({.LL = 1, .RR = 1, .LM = 0.1f, .RM = 0.1f});
    EXPECT_EQ(mirrored(brain), brain);
}

TEST(Symmetry, MirroredCopiesCurvesAndMissingWires) {
    BrainGraph brain = make_graph({.LL = 1, .LR = 1, .RL = 1, .RR = 1});
    wire(brain, "SL", "ML")->curve = {Response::hump, 0.3f, 0.1f};
    std::erase_if(brain.wires, [](const Wire& w) { return w.from == 1 && w.to == 2; });  // LR
    BrainGraph made = mirrored(brain);
    EXPECT_EQ(wire(made, "SR", "MR")->curve, (Curve{Response::hump, 0.3f, 0.1f}));
    EXPECT_EQ(wire(made, "SL", "MR"), nullptr);
}

TEST(Symmetry, CrossedTurnsACowardIntoAnAggressorAndBack) {
    const BrainGraph coward = make_graph({.LL = 1.5f, .RR = 1.2f, .threshold_RR = 0.2f, .LM = 0.1f, .RM = 0.1f});
    const BrainGraph aggressor = crossed(coward);
    EXPECT_EQ(read_dials(aggressor),
              (FourNeurons{.LR = 1.2f, .RL = 1.5f, .threshold_LR = 0.2f, .LM = 0.1f, .RM = 0.1f}));
    EXPECT_EQ(recognise(aggressor), Character::aggressor);
    EXPECT_EQ(crossed(aggressor), coward);
}

TEST(Symmetry, KeepsLesionsInPlace) {
    BrainGraph brain = make_graph({.LL = 1, .RR = 0.5f});
    wire(brain, "SL", "ML")->cut = true;
    BrainGraph both = mirrored(brain), across = crossed(brain);
    EXPECT_TRUE(wire(both, "SL", "ML")->cut);
    EXPECT_FALSE(wire(both, "SR", "MR")->cut);
    EXPECT_TRUE(wire(across, "SL", "ML")->cut);
    EXPECT_FALSE(wire(across, "SL", "MR")->cut);
}

TEST(Symmetry, DoesNotChangeABrainWithoutTwoEyes) {
    BrainGraph brain = make_graph({.LL = 1});
    std::erase_if(brain.nodes, [](const Node& n) { return n.name == "SR"; });
    std::erase_if(brain.wires, [](const Wire& w) { return w.from == 1; });
    EXPECT_EQ(mirrored(brain), brain);
    EXPECT_EQ(crossed(brain), brain);
}

}  // namespace braitenlab::tests::symmetry_test
