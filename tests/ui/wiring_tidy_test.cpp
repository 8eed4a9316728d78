#include <gtest/gtest.h>

#include "core/brain/edit.h"
#include "ui/wiring/align.h"

namespace {

using namespace braitenlab;

// Two eyes, two motors and `count` neurons from id 4 on.
BrainGraph with_neurons(int count) {
    BrainGraph graph = make_graph({.LR = 1.5f, .RL = 1.5f});
    for (int i = 0; i < count; ++i) graph = *add_neuron(graph).graph;
    return graph;
}

TEST(PutInOrder, LinesUpAndKeepsCardsApart) {
    const Layout layout = lay_out(with_neurons(3), {{4, {0, 0}}, {5, {90, 10}}, {6, {30, 400}}});
    const Places column = put_in_order(layout, {4, 5, 6}, Order::column);
    EXPECT_EQ(column.at(4).x, 40);
    EXPECT_EQ(column.at(5).x, 40);
    EXPECT_GT(column.at(5).y - column.at(4).y, 80) << "they would have covered each other";
    EXPECT_EQ(column.at(6).y, 400);
    const Places even = put_in_order(layout, {4, 5, 6}, Order::even_down);
    EXPECT_EQ(even.at(5).y, 200);
    EXPECT_EQ(even.at(5).x, 90);
    EXPECT_TRUE(put_in_order(layout, {4}, Order::row).empty());
    EXPECT_TRUE(put_in_order(layout, {4, 5}, Order::even_across).empty());
}

}  // namespace
