#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "core/brain/edit.h"
#include "core/brain/four_neurons.h"
#include "core/scene/scene_file.h"
#include "ui/panels/brain/brain_layout.h"
#include "ui/wiring/layout.h"

namespace braitenlab::tests::wiring_layout_test {

using namespace wiring;

namespace {

using maths::vec2;

using namespace four_neuron_ids;

// Two eyes, two motors and `count` neurons from id 4 on.
BrainGraph with_neurons(int count) {
    BrainGraph graph = make_graph({.LR = 1.5f, .RL = 1.5f});
    for (int i = 0; i < count; ++i) graph = *add_neuron(graph).graph;
    return graph;
}

BrainGraph aggressor() { return make_graph({.LR = 1.5f, .RL = 1.5f}); }

// Two sensors and two motors with `count` hidden neurons in a chain.
BrainGraph chain(int count) {
    BrainGraph graph = aggressor();
    NodeId before = SL;
    for (int i = 0; i < count; ++i) {
        const NodeId neuron = fresh_id(graph);
        graph = *add_neuron(graph).graph;
        graph = *connect(graph, {before, neuron}).graph;
        before = neuron;
    }
    return *connect(graph, {before, ML}).graph;
}

bool overlap(vec2 a, vec2 a_size, vec2 b, vec2 b_size) {
    return std::abs(a.x - b.x) * 2 < a_size.x + b_size.x && std::abs(a.y - b.y) * 2 < a_size.y + b_size.y;
}

// Names of the neurons of the first kind that stand in one line in both pictures, and are in another order there.
std::string mirrored(const std::string& scene_name) {
    const auto scene =
        load_scene(std::filesystem::path(BRAITENLAB_SOURCE) / "exercises/scenes" / (scene_name + ".toml"));
    if (!scene) return scene.error().text();
    const Kind& kind = scene->kinds.front();
    const Positions places = tidy(kind.brain);
    std::string found;
    for (const bool is_sideways : {false, true}) {
        const Rect area{0, 0, 400, 200};
        const auto parts = is_sideways ? ui::sketch::lay_out_sideways(kind.brain, kind, {}, area, 1)
                                       : ui::sketch::lay_out_graph(kind.brain, kind, {}, area, 1);
        for (const auto& a : parts.neurons)
            for (const auto& b : parts.neurons) {
                const vec2 one = places.at(a.node->id), next = places.at(b.node->id);
                const float along = is_sideways ? a.at.x - b.at.x : a.at.y - b.at.y;
                const float across = is_sideways ? a.at.y - b.at.y : a.at.x - b.at.x;
                if (one.x == next.x && std::fabs(along) < 1 && (one.y < next.y) != (across < 0) && a.node != b.node)
                    found += a.name + " and " + b.name + ", ";
            }
    }
    return found;
}

TEST(WiringLayout, ThePictureOfABrainHasTheLeftSideWhereTheDiagramHasItAbove) {
    for (const char* scene : {"5-logic", "7-mnemotrix", "tortoise"}) EXPECT_EQ(mirrored(scene), "") << scene;
}

TEST(WiringLayout, HasEyesLeftMotorsRightAndLeftAboveRight) {
    const Layout layout = lay_out(aggressor(), {});
    EXPECT_LT(find_shape(layout, SL)->centre.x, find_shape(layout, ML)->centre.x);
    EXPECT_LT(find_shape(layout, SL)->centre.y, find_shape(layout, SR)->centre.y);
    EXPECT_LT(find_shape(layout, ML)->centre.y, find_shape(layout, MR)->centre.y);
}

TEST(WiringLayout, PutsHiddenNeuronsBetweenInTheOrderOfTheSignal) {
    const Layout layout = lay_out(chain(3), {});
    float before = find_shape(layout, SL)->centre.x;
    for (const NodeId id : {4, 5, 6, ML}) {
        EXPECT_GT(find_shape(layout, id)->centre.x, before) << id;
        before = find_shape(layout, id)->centre.x;
    }
}

TEST(WiringLayout, HasNoCardsThatOverlap) {
    BrainGraph graph = chain(4);
    for (int i = 0; i < 8; ++i) graph = *add_neuron(graph).graph;
    const Layout layout = lay_out(graph, {});
    for (const NodeShape& a : layout.nodes)
        for (const NodeShape& b : layout.nodes)
            EXPECT_FALSE(a.id < b.id && overlap(a.centre, a.size, b.centre, b.size)) << a.id << " " << b.id;
}

TEST(WiringLayout, DoesNotDependOnTheOrderOfTheGraph) {
    BrainGraph graph = chain(3), turned = graph;
    std::reverse(turned.nodes.begin(), turned.nodes.end());
    std::reverse(turned.wires.begin(), turned.wires.end());
    const Layout a = lay_out(graph, {}), b = lay_out(turned, {});
    for (const NodeShape& node : a.nodes) EXPECT_EQ(node.centre, find_shape(b, node.id)->centre);
    ASSERT_EQ(a.wires.size(), b.wires.size());
    for (std::size_t i = 0; i < a.wires.size(); ++i) {
        EXPECT_EQ(a.wires[i].ends, b.wires[i].ends);  // a label avoids earlier ones: the order matters
        EXPECT_EQ(a.wires[i].label, b.wires[i].label);
    }
}

TEST(WiringLayout, KeepsThePositionOfAMovedNode) {
    const Layout layout = lay_out(chain(1), {{4, {17, -230}}});
    EXPECT_EQ(find_shape(layout, 4)->centre, (vec2{17, -230}));
}

TEST(WiringLayout, HasAPlaceForAllFourDirectWires) {
    BrainGraph bare = aggressor();
    bare.wires.clear();
    const Layout layout = lay_out(bare, {});
    ASSERT_EQ(layout.wires.size(), 4u);
    for (const WireShape& wire : layout.wires) EXPECT_TRUE(wire.ghost && wire.direct);
    EXPECT_FALSE(find_shape(lay_out(aggressor(), {}), WireEnds{SL, MR})->ghost);
}

TEST(WiringLayout, HasNoLabelsOfDirectWiresThatOverlap) {
    const Layout layout = lay_out(aggressor(), {});
    for (const WireShape& a : layout.wires)
        for (const WireShape& b : layout.wires)
            EXPECT_FALSE(a.ends < b.ends && overlap(a.label, a.label_size, b.label, b.label_size));
}

TEST(WiringLayout, HasTheLabelsOfCrossingWiresSideBySideAsMirrorImages) {
    const Layout layout = lay_out(aggressor(), {});
    const vec2 down = find_shape(layout, WireEnds{SL, MR})->label, up = find_shape(layout, WireEnds{SR, ML})->label;
    EXPECT_NEAR(down.x, up.x, 0.5f);
    EXPECT_NEAR(down.y, -up.y, 0.5f);
}

TEST(WiringLayout, HasWiderLabelsForLearningWires) {
    BrainGraph graph = chain(2);
    const Layout before = lay_out(graph, {});
    const WireEnds ends{graph.wires.back().from, graph.wires.back().to};
    graph.wires.back().learning_rate = 0.1f;
    const Layout after = lay_out(graph, {});
    EXPECT_GT(find_shape(after, ends)->label_size.x, find_shape(before, ends)->label_size.x + 40);
}

TEST(WiringLayout, KeepsLabelsClearOfCards) {
    const vec2 in_the_way = find_shape(lay_out(chain(1), {}), WireEnds{SL, ML})->label;
    const Layout layout = lay_out(chain(1), {{4, in_the_way + vec2{70, 0}}});
    const NodeShape& card = *find_shape(layout, 4);
    const WireShape& wire = *find_shape(layout, WireEnds{SL, ML});
    EXPECT_FALSE(overlap(wire.label, wire.label_size, card.centre, card.size));
}

// The box around the curve of a wire.
std::pair<vec2, vec2> extent(const WireShape& wire) {
    std::pair<vec2, vec2> box{wire.bezier[0], wire.bezier[0]};
    for (int i = 0; i <= 50; ++i) {
        const vec2 at = bezier_point(wire.bezier, static_cast<float>(i) / 50);
        box.first = {std::min(box.first.x, at.x), std::min(box.first.y, at.y)};
        box.second = {std::max(box.second.x, at.x), std::max(box.second.y, at.y)};
    }
    return box;
}

TEST(WiringLayout, LeadsAWireToANodeBelowDownwardsBetweenTheCards) {
    BrainGraph graph = chain(2);
    graph = *connect(graph, {5, 4}).graph;
    for (const vec2 below : {vec2{0, 150}, vec2{-40, 150}, vec2{0, 300}, vec2{-200, 150}}) {
        const vec2 above{300, -60};
        for (const bool upwards : {false, true}) {
            const vec2 from = upwards ? above + below : above, to = upwards ? above : above + below;
            const Layout layout = lay_out(graph, {{5, from}, {4, to}});
            const WireShape& wire = *find_shape(layout, WireEnds{5, 4});
            const auto [low, high] = extent(wire);
            EXPECT_GE(low.y, above.y - 20) << below.x << " " << below.y;
            EXPECT_LE(high.y, above.y + below.y + 20) << below.x << " " << below.y;
            const vec2 middle = bezier_point(wire.bezier, 0.5f);
            EXPECT_NEAR(middle.y, above.y + below.y / 2, 20) << "between the two rows";
        }
    }
}

TEST(WiringLayout, HasNoLabelsThatOverlapInASmallBrain) {
    BrainGraph graph = chain(3);
    for (const WireEnds ends : {WireEnds{5, 4}, WireEnds{6, 5}, WireEnds{6, 4}, WireEnds{4, 4}, WireEnds{5, 5},
                                WireEnds{6, 6}, WireEnds{SR, 4}, WireEnds{SR, 5}})
        graph = *connect(graph, ends).graph;
    for (const float apart : {90.0f, 110.0f, 150.0f, 240.0f})
        for (const float aside : {-160.0f, 0.0f, 60.0f}) {
            const Layout layout =
                lay_out(graph, {{4, {400, -apart}}, {5, {400 + aside, 0}}, {6, {400 + 2 * aside, apart}}});
            for (const WireShape& a : layout.wires)
                for (const WireShape& b : layout.wires)
                    EXPECT_FALSE(a.ends < b.ends && overlap(a.label, a.label_size, b.label, b.label_size))
                        << apart << " " << aside << ": " << a.ends.from << "-" << a.ends.to << " and " << b.ends.from
                        << "-" << b.ends.to;
        }
}

TEST(WiringLayout, EndsTheWiresOfAPinBelowEachOther) {
    const Layout layout = lay_out(aggressor(), {});
    EXPECT_LT(find_shape(layout, WireEnds{SL, ML})->bezier[3].y, find_shape(layout, WireEnds{SR, ML})->bezier[3].y);
}

TEST(WiringLayout, IsWideForManySensorsSoThatWiresAreNotSteep) {
    BrainGraph graph = aggressor();
    for (const char* name : {"OL", "OR", "KL", "KR"}) {
        Node sensor;
        sensor.id = fresh_id(graph), sensor.name = name, sensor.kind = NodeKind::sensor;
        graph.nodes.push_back(sensor);
    }
    const Layout layout = lay_out(graph, {});
    const vec2 across = find_shape(layout, MR)->centre - find_shape(layout, SL)->centre;
    EXPECT_GE(across.x, across.y);
}

TEST(WiringLayout, UsesThePositionOfANodeUnlessItIsDragged) {
    BrainGraph graph = chain(1);
    graph.nodes.back().place = {17, -230};
    const NodeId id = graph.nodes.back().id;
    EXPECT_EQ(find_shape(lay_out(graph, {}), id)->centre, (vec2{17, -230}));
    EXPECT_EQ(find_shape(lay_out(graph, {{id, {1, 2}}}), id)->centre, (vec2{1, 2}));
}

TEST(WiringLayout, KeepPositionsWritesThemOnlyWhereTidyWouldMoveANode) {
    const BrainGraph graph = aggressor();
    const Layout shown = lay_out(graph, {});
    EXPECT_EQ(keep_positions(graph, shown), graph);
    const BrainGraph longer = chain(3);
    const Layout still = lay_out(keep_positions(longer, shown), {});
    for (const NodeShape& node : shown.nodes) EXPECT_EQ(find_shape(still, node.id)->centre, node.centre);
}

TEST(WiringLayout, FreePositionIsTheGivenOneOrTheNearestWithoutOverlap) {
    const Layout layout = lay_out(aggressor(), {});
    const vec2 size{150, 80}, far{2000, 2000};
    EXPECT_EQ(free_position(layout, far, size), far);
    for (const NodeShape& node : layout.nodes) {
        const vec2 at = free_position(layout, node.centre, size);
        EXPECT_FALSE(overlap(at, size, node.centre, node.size));
        EXPECT_LT(maths::distance(at, node.centre), 180);
    }
}

TEST(WiringLayout, CacheIsRebuiltOnlyForAnotherGraphOrOtherPositions) {
    LayoutCache kept;
    const auto graph = std::make_shared<BrainGraph>(chain(2)), longer = std::make_shared<BrainGraph>(chain(3));
    const NodeShape* first = kept.get(graph, {}).nodes.data();
    EXPECT_EQ(kept.get(graph, {}).nodes.data(), first);
    EXPECT_EQ(find_shape(kept.get(graph, {{4, {9, 9}}}), 4)->centre, (vec2{9, 9}));
    EXPECT_EQ(kept.get(longer, {}).nodes.size(), longer->nodes.size());
}

TEST(WiringLayout, WireCurveRunsFromPinToPin) {
    for (const vec2 to : {vec2{300, 80}, vec2{-200, 40}, vec2{0, 0}}) {
        const auto curve = wire_curve({10, 20}, to);
        EXPECT_EQ(bezier_point(curve, 0), (vec2{10, 20}));
        EXPECT_EQ(bezier_point(curve, 1), to);
    }
}

TEST(WiringLayout, OccupiedBoxesAgreeWithASearchOfEveryBox) {
    std::vector<std::pair<vec2, vec2>> boxes;
    OccupiedBoxes taken;
    for (int i = 0; i < 40; ++i) {
        const vec2 at{static_cast<float>(i * 197 % 900) - 450, static_cast<float>(i * 331 % 700) - 350};
        boxes.emplace_back(at, vec2{static_cast<float>(20 + i * 13 % 180), 30});
        taken.add(boxes.back().first, boxes.back().second);
    }
    for (int i = 0; i < 400; ++i) {
        const vec2 at{static_cast<float>(i * 83 % 1000) - 500, static_cast<float>(i * 59 % 800) - 400}, size{72, 28};
        const bool any = std::any_of(boxes.begin(), boxes.end(),
                                     [&](const auto& box) { return overlap(at, size, box.first, box.second); });
        EXPECT_EQ(taken.overlaps(at, size), any) << at.x << " " << at.y;
    }
}

TEST(WiringLayout, ArrangedNodesAreAlignedAndDoNotOverlap) {
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
}  // namespace braitenlab::tests::wiring_layout_test
