#include <gtest/gtest.h>

#include "core/brain/four_neurons.h"
#include "ui/wiring/sum.h"

namespace {

using namespace braitenlab;

constexpr NodeId SL = 0, ML = 2, MR = 3;

float seen(NodeId id) { return id == 0 ? 0.42f : id == 1 ? 0.27f : 0.44f; }

TEST(SumText, WritesProductsBiasAndValue) {
    FourNeurons four;
    four.LL = 0.8f, four.LM = 0.1f;
    EXPECT_EQ(sum_text(make_graph(four), ML, seen), "0.42·0.80 + 0.10 → 0.44");
}

TEST(SumText, PutsTheSignBetweenTheTerms) {
    FourNeurons four;
    four.RR = -0.5f, four.RL = -1, four.RM = -0.1f;
    EXPECT_EQ(sum_text(make_graph(four), MR, seen), "−0.42·1.00 − 0.27·0.50 − 0.10 → 0.44");
}

TEST(SumText, ShowsWhatTheThresholdLetsThrough) {
    FourNeurons four;
    four.LL = 1, four.threshold_LL = 0.9f;
    EXPECT_EQ(sum_text(make_graph(four), ML, seen), "0.00·1.00 → 0.44");
}

TEST(SumText, IsABareZeroWithoutWiresAndNothingForASensor) {
    EXPECT_EQ(sum_text(make_graph({}), ML, seen), "0.00 → 0.44");
    EXPECT_EQ(sum_text(make_graph({}), SL, seen), "");
}

}  // namespace
