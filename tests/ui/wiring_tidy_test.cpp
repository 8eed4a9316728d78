#include <gtest/gtest.h>

#include "core/brain/edit.h"
#include "core/brain/four_neurons.h"
#include "ui/wiring/layout.h"
#include "ui/wiring/tidy.h"

namespace braitenlab::tests::wiring_tidy_test {

using namespace wiring;

namespace {

// Two eyes, two motors and `count` neurons from id 4 on.
BrainGraph with_neurons(int count) {
    BrainGraph graph = make_graph({.LR = 1.5f, .RL = 1.5f});
    for (int i = 0; i < count; ++i) graph = *add_neuron(graph).graph;
    return graph;
}

TEST(WiringTidy, ArrangedNodesAreAlignedAndDoNotOverlap) {
    const Layout layout = lay_out(with_neurons(3), {{4, {0, 0}}, {5, {90, 10}}, {6, {30, 400}}});
    const Positions column = arranged(layout, {4, 5, 6}, Arrangement::column);
    EXPECT_EQ(column.at(4).x, 40);
    EXPECT_EQ(column.at(5).x, 40);
    EXPECT_GT(column.at(5).y - column.at(4).y, 80) << "their cards would overlap";
    EXPECT_EQ(column.at(6).y, 400);
    const Positions even = arranged(layout, {4, 5, 6}, Arrangement::even_down);
    EXPECT_EQ(even.at(5).y, 200);
    EXPECT_EQ(even.at(5).x, 90);
    EXPECT_TRUE(arranged(layout, {4}, Arrangement::row).empty());
    EXPECT_TRUE(arranged(layout, {4, 5}, Arrangement::even_across).empty());
}

}  // namespace
}  // namespace braitenlab::tests::wiring_tidy_test
