#include <gtest/gtest.h>

#include "ui/wiring/hit.h"

namespace braitenlab::tests::wiring_hit_test {
namespace {

using maths::vec2;

constexpr NodeId SL = 0, SR = 1, ML = 2, MR = 3;

struct WiringHit : testing::Test {
    WiringHit() {
        FourNeurons four;
        four.LR = four.RL = 1.5f;
        layout = lay_out(make_graph(four), {});
    }
    Hit at(vec2 unit) const { return hit(layout, view, view.to_window(unit), 1); }
    vec2 out(NodeId id) const { return find_shape(layout, id)->out_pin(); }

    Layout layout;
    View view{{200, 300}, 0.8f};
};

TEST_F(WiringHit, FindsPinsBeforeTheCardsTheyStandOn) {
    EXPECT_EQ(at(out(SL)), (Hit{Part::out_pin, SL, {}}));
    EXPECT_EQ(at(out(SL) - vec2{10, 0}).part, Part::out_pin);
    EXPECT_EQ(at(find_shape(layout, MR)->in_pin()), (Hit{Part::in_pin, MR, {}}));
}

TEST_F(WiringHit, ReachesPinsFourteenPixelsFarAtAnyZoom) {
    for (const float zoom : {0.3f, 1.0f, 3.0f})
        for (const float ui_scale : {1.0f, 2.0f}) {
            view.scale = zoom * ui_scale;
            const vec2 pin = view.to_window(out(SL));
            EXPECT_EQ(hit(layout, view, pin + vec2{0, 13.5f * ui_scale}, ui_scale).part, Part::out_pin);
            EXPECT_NE(hit(layout, view, pin + vec2{0, 14.5f * ui_scale}, ui_scale).part, Part::out_pin);
        }
}

TEST_F(WiringHit, LeavesACardSeenFromFarAwayMoreThanItsPins) {
    view.scale = 0.15f;
    EXPECT_EQ(at(find_shape(layout, SL)->centre).part, Part::node);
}

TEST_F(WiringHit, FindsCardsAndTheTopOneFirst) {
    EXPECT_EQ(at(find_shape(layout, SR)->centre), (Hit{Part::node, SR, {}}));
    const vec2 same = find_shape(layout, SL)->centre;
    FourNeurons four;
    layout = lay_out(make_graph(four), {{ML, same}});
    EXPECT_EQ(at(same).node, ML);
}

TEST_F(WiringHit, FindsLabelsAndThenWiresWithinEightPixels) {
    const WireShape& wire = *find_shape(layout, WireEnds{SL, MR});
    EXPECT_EQ(at(wire.label), (Hit{Part::label, 0, {SL, MR}}));
    const vec2 on = view.to_window(bezier_point(wire.bezier, 0.75f));
    EXPECT_EQ(hit(layout, view, on + vec2{4, 0}, 1), (Hit{Part::wire, 0, {SL, MR}}));
    EXPECT_EQ(hit(layout, view, on + vec2{40, 0}, 1).part, Part::nothing);
}

TEST_F(WiringHit, BoxTakesInWhatItTouchesAndNoGhosts) {
    const vec2 low = view.to_window(layout.low - vec2{5, 5}), high = view.to_window(layout.high + vec2{5, 5});
    const Caught all = inside(layout, view, high, low);
    EXPECT_EQ(all.nodes, (std::set<NodeId>{SL, SR, ML, MR}));
    EXPECT_EQ(all.wires, (std::set<WireEnds>{{SL, MR}, {SR, ML}}));
    const vec2 eye = view.to_window(find_shape(layout, SL)->centre);
    EXPECT_EQ(inside(layout, view, eye, eye + vec2{2, 2}).nodes, (std::set<NodeId>{SL}));
}

}  // namespace
}  // namespace braitenlab::tests::wiring_hit_test
