#include "core/brain/mutate.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/brain/brain.h"
#include "core/brain/four_neurons.h"

namespace braitenlab::tests::mutate_test {
namespace {

BrainGraph parent() {
    return make_graph({.LL = 0.5f, .LR = -0.5f, .RL = 1, .RR = 0, .threshold_LL = 0.5f, .LM = 0.2f});
}

BrainGraph copy(const Mutation& mutation, std::uint64_t seed = 1) {
    maths::Random chance(seed, 0);
    return mutated(parent(), mutation, chance);
}

TEST(Mutate, TheSameSeedGivesTheSameCopyAndAnotherSeedAnother) {
    const Mutation all{.strength = 0.3f, .thresholds = true, .biases = true, .rewiring = 1};
    EXPECT_EQ(copy(all), copy(all));
    EXPECT_NE(copy(all, 1), copy(all, 2));
}

TEST(Mutate, ChangesOnlyWhatTheMutationNames) {
    BrainGraph weights = copy({.strength = 0.3f});
    ASSERT_EQ(weights.wires.size(), parent().wires.size());
    for (std::size_t i = 0; i < weights.wires.size(); ++i) {
        EXPECT_NE(weights.wires[i].weight, parent().wires[i].weight);
        weights.wires[i].weight = parent().wires[i].weight;
    }
    EXPECT_EQ(weights, parent());
    const BrainGraph biases = copy({.strength = 0.3f, .weights = false, .biases = true});
    EXPECT_EQ(biases.wires, parent().wires);
    EXPECT_NE(find_node(biases, "ML")->bias, find_node(parent(), "ML")->bias);
    EXPECT_EQ(find_node(biases, "SL")->bias, 0);
    const BrainGraph thresholds = copy({.strength = 0.3f, .weights = false, .thresholds = true});
    EXPECT_NE(thresholds.wires, parent().wires);
    EXPECT_EQ(thresholds.nodes, parent().nodes);
    EXPECT_EQ(copy({.strength = 0, .thresholds = true, .biases = true}), parent());
}

TEST(Mutate, TheErrorOfAWeightHasTheStrengthAsItsStandardDeviation) {
    maths::Random chance(7, 0);
    double squares = 0;
    constexpr int copies = 2000;
    for (int i = 0; i < copies; ++i) {
        const float error = mutated(parent(), {.strength = 0.2f}, chance).wires[3].weight - parent().wires[3].weight;
        squares += static_cast<double>(error * error);
    }
    EXPECT_NEAR(std::sqrt(squares / copies), 0.2, 0.01);
}

TEST(Mutate, AnyNumberOfCopiesOfCopiesCompiles) {
    maths::Random chance(3, 0);
    BrainGraph graph = parent();
    graph.nodes.push_back({.id = 4, .name = "N"});  // further wires can begin or end there
    std::size_t fewest = graph.wires.size(), most = fewest;
    for (int i = 0; i < 200; ++i) {
        graph = mutated(graph, {.strength = 2, .thresholds = true, .biases = true, .rewiring = 1}, chance);
        ASSERT_FALSE(check_graph(graph)) << "generation " << i;
        fewest = std::min(fewest, graph.wires.size()), most = std::max(most, graph.wires.size());
    }
    EXPECT_LT(fewest, 4u) << "wires are lost";
    EXPECT_GT(most, 4u) << "wires are added";
}

TEST(Mutate, TheErrorsOfAThresholdAndABiasAreAQuarterAndHalfAsLarge) {
    maths::Random chance(7, 0);
    const BrainGraph middle = make_graph({.RR = 1, .threshold_RR = 0.5f, .LM = 0.2f});
    const auto wire = [](const BrainGraph& graph) { return *find_wire(graph, 1, find_node(graph, "MR")->id); };
    double thresholds = 0, biases = 0;
    constexpr int copies = 2000;
    for (int i = 0; i < copies; ++i) {
        const BrainGraph child = mutated(middle, {.strength = 0.4f, .thresholds = true, .biases = true}, chance);
        thresholds += std::pow(double{wire(child).threshold} - 0.5, 2);
        biases += std::pow(double{find_node(child, "ML")->bias - 0.2f}, 2);
    }
    EXPECT_NEAR(std::sqrt(thresholds / copies), 0.1, 0.005);
    EXPECT_NEAR(std::sqrt(biases / copies), 0.2, 0.01);
}

}  // namespace
}  // namespace braitenlab::tests::mutate_test
