#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/brain/four_neurons.h"
#include "tests/ui/large_brain.h"
#include "ui/wiring/view.h"

namespace braitenlab::tests::wiring_view_test {

using namespace wiring;

namespace {

using maths::vec2;

using namespace four_neuron_ids;

// The layout of an aggressor, seen through a view.
struct WiringView : testing::Test {
    Hit at(vec2 unit, float least_type = 0) const {
        return hit(layout, view, view.to_window(unit), 1, is_map(view, 1, least_type));
    }
    vec2 out(NodeId id) const { return find_shape(layout, id)->out_pin(); }

    Layout layout = lay_out(make_graph({.LR = 1.5f, .RL = 1.5f}), {});
    View view{{200, 300}, 0.8f};
};

TEST_F(WiringView, ConvertsPixelsToUnitsAndBack) {
    view = {{120, 40}, 1.5f};
    EXPECT_EQ(view.to_canvas(view.to_window({8, -6})), (vec2{8, -6}));
}

TEST_F(WiringView, AMapOfLargeLettersHasNoLabelUnderThePointer) {
    const vec2 label = find_shape(layout, {SL, MR})->label;
    EXPECT_EQ(at(label, 20).part, Part::label);
    EXPECT_EQ(at(label, 40).part, Part::wire) << "the letters are too large for the cards at this zoom";
}

TEST_F(WiringView, ZoomKeepsThePointUnderThePointer) {
    const Rect area{20, 30, 900, 640};
    const vec2 cursor{830, 520};
    CanvasCamera camera;
    const vec2 unit = view_of(camera, area, 1).to_canvas(cursor);
    for (const float notches : {3.0f, -7.0f, 30.0f, -60.0f}) {
        zoom_at(camera, area, 1, cursor, std::pow(1.15f, notches));
        EXPECT_LT(maths::distance(view_of(camera, area, 1).to_window(unit), cursor), 0.01f);
        EXPECT_GE(camera.zoom, least_zoom);
        EXPECT_LE(camera.zoom, most_zoom);
    }
}

TEST_F(WiringView, FitKeepsEveryCardClearOfTheButtonsAtAnySize) {
    CanvasCamera camera;
    for (const Rect room : {Rect{0, 0, 900, 640}, Rect{40, 90, 1200, 300}, Rect{10, 10, 300, 900}})
        for (const float ui_scale : {1.0f, 2.0f}) {
            fit(camera, layout, room, ui_scale);
            const View drawn = view_of(camera, room, ui_scale);
            for (const NodeShape& node : layout.nodes) {
                const Rect card = node_rect(drawn, node);
                const bool below = card.y >= room.y + 44 * ui_scale;
                const bool beside = card.x + card.w <= room.x + room.w - 200 * ui_scale && card.y >= room.y;
                EXPECT_TRUE(below || beside) << room.w << " x " << room.h << " at " << ui_scale;
                if (camera.zoom <= least_zoom) continue;  // as small as it gets
                EXPECT_LE(card.y + card.h, room.y + room.h);
                EXPECT_GE(card.x, room.x);
                EXPECT_LE(card.x + card.w, room.x + room.w);
            }
        }
}

TEST_F(WiringView, PrefersPinsToTheirCards) {
    EXPECT_EQ(at(out(SL)), (Hit{Part::out_pin, SL, {}}));
    EXPECT_EQ(at(out(SL) - vec2{10, 0}).part, Part::out_pin);
    EXPECT_EQ(at(find_shape(layout, MR)->in_pin()), (Hit{Part::in_pin, MR, {}}));
}

TEST_F(WiringView, FindsPinsWithinFourteenPixelsAtAnyZoom) {
    for (const float zoom : {0.3f, 1.0f, 3.0f})
        for (const float ui_scale : {1.0f, 2.0f}) {
            view.scale = zoom * ui_scale;
            const vec2 pin = view.to_window(out(SL));
            EXPECT_EQ(hit(layout, view, pin + vec2{0, 13.5f * ui_scale}, ui_scale, is_map(view, ui_scale, 0)).part,
                      Part::out_pin);
            EXPECT_NE(hit(layout, view, pin + vec2{0, 14.5f * ui_scale}, ui_scale, is_map(view, ui_scale, 0)).part,
                      Part::out_pin);
        }
}

TEST_F(WiringView, KeepsTheMiddleOfASmallCardFreeOfItsPins) {
    view.scale = 0.15f;
    EXPECT_EQ(at(find_shape(layout, SL)->centre).part, Part::node);
}

TEST_F(WiringView, FindsCardsAndTheTopOneFirst) {
    EXPECT_EQ(at(find_shape(layout, SR)->centre), (Hit{Part::node, SR, {}}));
    const vec2 same = find_shape(layout, SL)->centre;
    FourNeurons four;
    layout = lay_out(make_graph(four), {{ML, same}});
    EXPECT_EQ(at(same).node, ML);
}

TEST_F(WiringView, FindsTheNumberOfAShortWireBesideAPin) {
    view.scale = 1;
    const vec2 motor = find_shape(layout, MR)->in_pin(), to_pin = out(SL) - find_shape(layout, SL)->centre;
    int found = 0;
    for (float length = 20; length < 160; length += 2) {
        layout = lay_out(make_graph({.LR = 1.5f, .RL = 1.5f}), {{SL, motor - to_pin - vec2{length, 0}}});
        const Rect number = label_rect(view, *find_shape(layout, WireEnds{SL, MR}));
        const vec2 pin = view.to_window(out(SL));
        const vec2 nearest{std::clamp(pin.x, number.x + 1, number.x + number.w - 1),
                           std::clamp(pin.y, number.y + 1, number.y + number.h - 1)};
        const float away = maths::distance(pin, nearest);
        const Rect card = node_rect(view, *find_shape(layout, SL));
        if (away < pin_size / 2 + 1 || away > pin_reach || card.contains(nearest.x, nearest.y)) continue;
        ++found;
        EXPECT_EQ(hit(layout, view, nearest, 1, false), (Hit{Part::label, 0, {SL, MR}})) << length;
        EXPECT_EQ(at(out(SL)).part, Part::out_pin) << length;
    }
    EXPECT_GT(found, 0);
}

TEST_F(WiringView, FindsLabelsAndThenWiresWithinEightPixels) {
    const WireShape& wire = *find_shape(layout, WireEnds{SL, MR});
    EXPECT_EQ(at(wire.label), (Hit{Part::label, 0, {SL, MR}}));
    const vec2 on = view.to_window(bezier_point(wire.bezier, 0.75f));
    EXPECT_EQ(hit(layout, view, on + vec2{4, 0}, 1, is_map(view, 1, 0)), (Hit{Part::wire, 0, {SL, MR}}));
    EXPECT_EQ(hit(layout, view, on + vec2{40, 0}, 1, is_map(view, 1, 0)).part, Part::nothing);
}

TEST_F(WiringView, BoxSelectsWhatItTouchesExceptGhosts) {
    const vec2 low = view.to_window(layout.low - vec2{5, 5}), high = view.to_window(layout.high + vec2{5, 5});
    const CanvasSelection all = in_box(layout, view, high, low);
    EXPECT_EQ(all.nodes, (std::set<NodeId>{SL, SR, ML, MR}));
    EXPECT_EQ(all.wires, (std::set<WireEnds>{{SL, MR}, {SR, ML}}));
    const vec2 eye = view.to_window(find_shape(layout, SL)->centre);
    EXPECT_EQ(in_box(layout, view, eye, eye + vec2{2, 2}).nodes, (std::set<NodeId>{SL}));
}

// The number of parts that arrow keys reach from the first card.
std::size_t reached(const Layout& layout) {
    std::vector<Hit> seen{next_in(Direction::right, layout, {})};
    for (std::size_t i = 0; i < seen.size(); ++i)
        for (const Direction to : {Direction::left, Direction::right, Direction::up, Direction::down}) {
            const Hit next = next_in(to, layout, seen[i]);
            if (std::find(seen.begin(), seen.end(), next) == seen.end()) seen.push_back(next);
        }
    return seen.size();
}

TEST_F(WiringView, ArrowsReachEveryNodeAndLabel) {
    for (const BrainGraph& graph : {make_graph({.LR = 1, .RL = 1}), large_brain(12, 24), large_brain(30, 60)}) {
        const Layout shown = lay_out(graph, {});
        EXPECT_EQ(reached(shown), shown.nodes.size() + shown.wires.size());
    }
}

}  // namespace
}  // namespace braitenlab::tests::wiring_view_test
