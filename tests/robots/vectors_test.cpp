// Golden vectors.
#include "core/export/vectors.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/brain/four_neurons.h"
#include "core/brain/presets.h"

namespace braitenlab::tests::vectors_test {
namespace {

using robots::golden_vectors;
using robots::write_csv;

TEST(Vectors, AreTheSameForTheSameSeed) {
    const BrainGraph& brain = find_preset("5-logic")->brain;
    const auto one = golden_vectors({"", brain, {}}, 60, 200, 3), again = golden_vectors({"", brain, {}}, 60, 200, 3),
               other = golden_vectors({"", brain, {}}, 60, 200, 4);
    ASSERT_TRUE(one && again && other);
    EXPECT_EQ(write_csv(*one), write_csv(*again));
    EXPECT_NE(write_csv(*one), write_csv(*other));
}

TEST(Vectors, AreTheEquationsOfTheFourNeurons) {
    const auto made = golden_vectors({"", make_graph({.LL = 0.5f, .LR = -0.25f, .RR = 2, .LM = 0.1f}), {}}, 60, 300);
    ASSERT_TRUE(made);
    ASSERT_EQ(made->ticks.size(), 300u);
    for (const auto& row : made->ticks) {
        EXPECT_NEAR(row.left, 0.5f * row.sensed[0] - 0.25f * row.sensed[1] + 0.1f, 1e-6);
        EXPECT_NEAR(row.right, std::min(1.0f, 2 * row.sensed[1]), 1e-6);
    }
}

TEST(Vectors, BeginWithEveryCombinationOfZeroAndOne) {
    const auto made = golden_vectors({"", make_graph({.LL = 1, .RR = 1}), {}}, 60, 8);
    ASSERT_TRUE(made);
    EXPECT_EQ(made->ticks[0].sensed, (std::vector<float>{0, 0}));
    EXPECT_EQ(made->ticks[2].sensed, (std::vector<float>{1, 0}));
    EXPECT_EQ(made->ticks[4].sensed, (std::vector<float>{0, 1}));
    EXPECT_EQ(made->ticks[6].sensed, (std::vector<float>{1, 1}));
}

TEST(Vectors, KeepAwayFromThresholdsAndSteps) {
    BrainGraph graph = make_graph({.LL = 1, .RR = 1});
    for (Wire& wire : graph.wires) wire.threshold = 0.5f;
    const auto made = golden_vectors({"", graph, {}}, 60, 2000);
    ASSERT_TRUE(made);
    for (const auto& row : made->ticks) {
        EXPECT_FALSE(row.is_close_call);
        for (const float value : row.sensed) EXPECT_GE(std::fabs(value - 0.5f), robots::close_call_margin);
    }
}

TEST(Vectors, AreWrittenWithTheBitsOfTheirCommands) {
    const auto made = golden_vectors({"", make_graph({.LL = 1, .LM = 1.0f / 3}), {}}, 50, 1);
    ASSERT_TRUE(made);
    EXPECT_EQ(write_csv(*made), "tick,sensor_SL,left,right,close_call\n0,0.000,0.333333343,0,0\n");
}

}  // namespace
}  // namespace braitenlab::tests::vectors_test
