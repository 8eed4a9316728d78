// What the mouse and the keys do to the canvas.
#include <algorithm>
#include <cmath>
#include <optional>

#include "tests/ui/large_brain.h"
#include "tests/ui/wiring_hand.h"

namespace braitenlab::tests::wiring_canvas_test {
namespace {

TEST_F(WiringCanvas, RecordsPinsAndLabelsInsideItsArea) {
    for (const char* id : {"pin.SL.out", "pin.SR.out", "pin.ML.in", "pin.MR.in", "wire.LL", "wire.LR", "wire.RL",
                           "wire.RR", "node.SL", "canvas.fit", "canvas.arrange"}) {
        const Rect* r = anchors.find(id);
        ASSERT_NE(r, nullptr) << id;
        EXPECT_TRUE(area.contains(r->x, r->y) && area.contains(r->x + r->w, r->y + r->h)) << id;
    }
    EXPECT_EQ(*anchors.find("canvas"), area);
    EXPECT_EQ(anchors.find("pin.SL.in"), nullptr);
}

TEST_F(WiringCanvas, DragFromPinToPinTurnsAGhostIntoWeightOne) {
    now.brains[0] = std::make_shared<BrainGraph>(make_graph({}));
    drag(middle("pin.SL.out"), middle("pin.MR.in"));
    ASSERT_EQ(edits.size(), 1u);
    const auto* dial = std::get_if<TurnDial>(&edits[0].command);
    ASSERT_NE(dial, nullptr);
    EXPECT_EQ(dial->dial, Dial::RL);
    EXPECT_EQ(dial->value, 1);
    EXPECT_EQ(dial->target.vehicle, no_vehicle);
    EXPECT_EQ(dial->target.kind, 0);
    EXPECT_GE(edits[0].gesture, 1ULL << 40);
}

TEST_F(WiringCanvas, DragBackwardsFromInPinToOutPinMakesTheSameWire) {
    drag(middle("pin.ML.in"), middle("pin.SL.out"));
    EXPECT_EQ(dials().LL, 1);
}

TEST_F(WiringCanvas, DropOnACardMeansItsPin) {
    drag(middle("pin.SR.out"), middle("node.MR"));
    EXPECT_EQ(dials().RR, 1);
}

TEST_F(WiringCanvas, EditsTheSelectedVehicleAloneWhenAskedTo) {
    view.whole_kind = false;
    drag(middle("pin.SL.out"), middle("pin.ML.in"));
    ASSERT_EQ(edits.size(), 1u);
    EXPECT_EQ(std::get<TurnDial>(edits[0].command).target.vehicle, 7);
}

TEST_F(WiringCanvas, RefusesADuplicateAndSaysWhy) {
    drag(middle("pin.SL.out"), middle("pin.MR.in"));
    EXPECT_TRUE(edits.empty());
    EXPECT_EQ(state.refusal.key, "wiring.refused.duplicate");
    EXPECT_NE(anchors.find("refused.duplicate"), nullptr) << "it stands at the cursor";
}

TEST_F(WiringCanvas, RefusesAWireIntoASensorAndBetweenEqualPins) {
    drag(middle("pin.SL.out"), middle("node.SR"));
    EXPECT_EQ(state.refusal.key, "wiring.refused.into_sensor");
    drag(middle("pin.ML.in"), middle("pin.MR.in"));
    EXPECT_EQ(state.refusal.key, "wiring.refused.two_inputs");
    EXPECT_TRUE(edits.empty());
}

TEST_F(WiringCanvas, DropOnEmptySpaceOffersNeuronsAndMovesNothingElse) {
    const vec2 eye = middle("node.SL"), motor = middle("node.MR"), place{470, 350};
    drag(middle("pin.SL.out"), place);
    EXPECT_TRUE(edits.empty()) << "nothing is made before a kind is chosen";
    choose("hump");
    ASSERT_EQ(edits.size(), 1u);
    EXPECT_EQ(weight_of(brain(), {SL, 4}), 1);
    EXPECT_EQ(find_node(brain(), 4)->curve.response, Response::hump);
    EXPECT_LT(maths::distance(middle("pin.N1.in"), place), 1.5f);
    EXPECT_EQ(middle("node.SL"), eye);
    EXPECT_EQ(middle("node.MR"), motor);
    drag(middle("pin.N1.out"), middle("pin.ML.in"));
    EXPECT_EQ(weight_of(brain(), {4, ML}), 1);
    EXPECT_NE(anchors.find("wire.N1-ML"), nullptr);
}

TEST_F(WiringCanvas, ADropFromAnInputMakesANeuronThatFeedsIt) {
    drag(middle("pin.ML.in"), {470, 350});
    choose("leaky");
    EXPECT_EQ(weight_of(brain(), {4, ML}), 1);
    EXPECT_GT(find_node(brain(), 4)->time_constant, 0);
}

TEST_F(WiringCanvas, ADropMenuThatIsLeftMakesNothing) {
    drag(middle("pin.SL.out"), {470, 350});
    ASSERT_TRUE(state.menu.open());
    key(Action::cancel);
    EXPECT_FALSE(state.menu.open());
    drag(middle("pin.SL.out"), {470, 350});
    click({60, 600});
    EXPECT_FALSE(state.menu.open());
    EXPECT_TRUE(edits.empty());
}

TEST_F(WiringCanvas, EscInMidDragChangesNothing) {
    move(middle("pin.SL.out"));
    button(true);
    move(middle("pin.ML.in"));
    ASSERT_EQ(state.drag.phase, CanvasPhase::drag_wire);
    key(Action::cancel);
    button(false);
    EXPECT_TRUE(edits.empty());
    EXPECT_EQ(state.drag.phase, CanvasPhase::idle);
}

TEST_F(WiringCanvas, EscBringsAMovedNodeBack) {
    const vec2 before = middle("node.ML");
    move(before);
    button(true);
    move(before + vec2{60, 90});
    EXPECT_GT(maths::distance(middle("node.ML"), before), 50);
    key(Action::cancel);
    EXPECT_EQ(middle("node.ML"), before);
    EXPECT_TRUE(edits.empty());
}

TEST_F(WiringCanvas, AMovedNodeStaysWhereItWasPut) {
    const vec2 before = middle("node.ML");
    drag(before, before + vec2{40, 50});
    EXPECT_LT(maths::distance(middle("node.ML"), before + vec2{40, 50}), 1);
    EXPECT_EQ(edits.size(), 1u);
    click(middle("canvas.arrange"));
    frames();
    EXPECT_LT(maths::distance(middle("node.ML"), before), 1);
}

TEST_F(WiringCanvas, DragOnALabelTurnsItsWeightInTenthsAsOneGesture) {
    const vec2 label = middle("wire.RL");
    drag(label, label + vec2{-24, 0});
    EXPECT_NEAR(dials().RL, 1.2f, 1e-5f);
    ASSERT_GE(edits.size(), 2u);
    for (const EditRequest& edit : edits) EXPECT_EQ(edit.gesture, edits[0].gesture);
}

TEST_F(WiringCanvas, EscRestoresADraggedWeight) {
    const vec2 label = middle("wire.RL");
    move(label);
    button(true);
    move(label + vec2{0, 40});
    EXPECT_NEAR(dials().RL, 1.0f, 1e-5f);
    key(Action::cancel);
    button(false);
    EXPECT_EQ(dials().RL, 1.5f);
    EXPECT_EQ(edits.front().gesture, edits.back().gesture);
}

TEST_F(WiringCanvas, AWeightStopsAtItsRangeAndComesBackAtOnce) {
    const vec2 label = middle("wire.RL");
    move(label);
    button(true);
    move(label + vec2{0, -300});
    EXPECT_EQ(dials().RL, 2);
    move(label + vec2{0, -292});
    EXPECT_NEAR(dials().RL, 1.9f, 1e-5f);
}

TEST_F(WiringCanvas, WheelOverALabelTurnsItsWeightAndElsewhereZooms) {
    move(middle("wire.LL"));
    wheel(1);
    EXPECT_NEAR(dials().LL, 0.1f, 1e-6f);
    ImGui::GetIO().KeyShift = true;
    wheel(-1);
    EXPECT_NEAR(dials().LL, 0.09f, 1e-6f);
    EXPECT_EQ(edits[0].gesture, edits[1].gesture);
    const float zoom = state.zoom;
    move({60, 600});
    wheel(1);
    EXPECT_GT(state.zoom, zoom);
    EXPECT_EQ(edits.size(), 2u);
}

TEST_F(WiringCanvas, ZoomKeepsThePointUnderTheCursor) {
    const vec2 pin = middle("pin.MR.in");
    const vec2 cursor = pin + vec2{-60, 90};
    move(cursor);
    const vec2 unit = view_of(state, area, 1).to_canvas(cursor);
    for (const float notches : {3.0f, -7.0f, 30.0f, -60.0f}) {
        zoom_at(state, area, 1, cursor, std::pow(1.15f, notches));
        EXPECT_LT(maths::distance(view_of(state, area, 1).to_window(unit), cursor), 0.01f);
        EXPECT_GE(state.zoom, least_zoom);
        EXPECT_LE(state.zoom, most_zoom);
    }
}

TEST_F(WiringCanvas, RightDragPansAndHomeFitsAgain) {
    const vec2 before = middle("node.SL");
    move({60, 600});
    button(true, 1);
    move({100, 560});
    button(false, 1);
    EXPECT_LT(maths::distance(middle("node.SL"), before + vec2{40, -40}), 0.1f);
    key(Action::fit);
    EXPECT_LT(maths::distance(middle("node.SL"), before), 0.1f);
}

TEST_F(WiringCanvas, StaysUnderTheMouseWhileABrainIsEditedAndACardOpensBelow) {
    const vec2 eye = middle("node.SL"), motor = middle("node.MR");
    const auto expect_still = [&](const char* after) {
        EXPECT_LT(maths::distance(middle("node.SL"), eye), 0.1f) << after;
        EXPECT_LT(maths::distance(middle("node.MR"), motor), 0.1f) << after;
    };
    right_click({470, 600});
    choose("step");
    expect_still("adding");
    drag(middle("pin.SL.out"), middle("pin.N1.in"));
    expect_still("joining");
    area.h -= 200;  // a card opens below, over the lower half
    frames(2);
    EXPECT_LT(maths::distance(middle("node.SL"), eye), 0.1f);
    EXPECT_EQ(anchors.find("node.MR"), nullptr);
    click(middle("wire.RL"));
    key(Action::erase);
    EXPECT_LT(maths::distance(middle("node.SL"), eye), 0.1f) << "even then an edit moves nothing";
    area.h += 200;
    frames(2);
    expect_still("a card that folds");
    now.brains[0] = std::make_shared<BrainGraph>(make_graph({.LR = 1.5f, .RL = 1.5f}));
    frames(2);
    EXPECT_LT(maths::distance(middle("node.SL"), eye), 0.1f) << "an undo";
}

TEST_F(WiringCanvas, BringsABrainThatComesFromElsewhereIntoViewUnlessTheViewIsOnesOwn) {
    const auto give = [&](int nodes) {
        const VehicleId id = view.selected;
        now = moment_with(large_brain(nodes, 90));
        now.vehicles[0].id = id;
        frames(2);
        return std::all_of(brain().nodes.begin(), brain().nodes.end(),
                           [&](const Node& node) { return anchors.find("node." + node.name) != nullptr; });
    };
    EXPECT_TRUE(give(40));
    state.own_view = true;
    EXPECT_FALSE(give(200));
    now.vehicles[0].kind = 0;
    ++view.sitting;  // another scene
    frames(2);
    EXPECT_FALSE(state.own_view);
    EXPECT_NE(anchors.find("node.MR"), nullptr);
}

TEST_F(WiringCanvas, FitsAgainInAnotherWindow) {
    area.w = 700;
    ImGui::GetIO().DisplaySize = {800, 700};
    frames(2);
    const Rect motor = *anchors.find("node.MR"), eye = *anchors.find("node.SL");
    EXPECT_LE(motor.x + motor.w, area.x + area.w);
    EXPECT_GE(eye.x, area.x);
}

TEST_F(WiringCanvas, ANeuronThatWasAddedIsSelected) {
    right_click({470, 600});
    choose("step");
    frames(5);
    EXPECT_EQ(state.selection.nodes, (std::set<NodeId>{4}));
}

TEST_F(WiringCanvas, TheMenuOfEmptyGroundSaysThatItAddsNeurons) {
    right_click({470, 600});
    EXPECT_EQ(state.menu.heading, "wiring.add_neuron");
    EXPECT_EQ(state.menu.note, "wiring.add_how");
    const Rect first = row_rect(state.menu, 0), last = row_rect(state.menu, state.menu.rows.size() - 1);
    EXPECT_GE(first.y, state.menu.rect.y + head_height(state.menu));
    EXPECT_GT(head_height(state.menu), 40);
    EXPECT_LE(last.y + last.h, state.menu.rect.y + state.menu.rect.h);
    key(Action::cancel);
    right_click(middle("wire.LR"));
    EXPECT_EQ(state.menu.heading, "") << "what is done to a wire needs no heading";
}

TEST_F(WiringCanvas, ACardTooSmallForItsWordsSaysThemToAPointerThatRests) {
    state.zoom = 0.5f;
    state.own_view = true;
    frames();
    move(middle("node.SR"));
    EXPECT_EQ(anchors.find("says.SR"), nullptr) << "not in passing";
    frames(30);
    EXPECT_NE(anchors.find("says.SR"), nullptr);
    state.zoom = 1;
    frames();
    move(middle("node.SR"));
    frames(30);
    EXPECT_EQ(anchors.find("says.SR"), nullptr) << "the card itself says it";
}

TEST_F(WiringCanvas, FitKeepsEveryCardClearOfTheButtonsAtAnySize) {
    const Layout layout = lay_out(brain(), {});
    for (const Rect room : {Rect{0, 0, 900, 640}, Rect{40, 90, 1200, 300}, Rect{10, 10, 300, 900}})
        for (const float ui_scale : {1.0f, 2.0f}) {
            fit(state, layout, room, ui_scale);
            const View drawn = view_of(state, room, ui_scale);
            for (const NodeShape& node : layout.nodes) {
                const Rect card = node_rect(drawn, node);
                const bool below = card.y >= room.y + 44 * ui_scale;
                const bool beside = card.x + card.w <= room.x + room.w - 200 * ui_scale && card.y >= room.y;
                EXPECT_TRUE(below || beside) << room.w << " x " << room.h << " at " << ui_scale;
                if (state.zoom <= least_zoom) continue;  // as small as it gets
                EXPECT_LE(card.y + card.h, room.y + room.h);
                EXPECT_GE(card.x, room.x);
                EXPECT_LE(card.x + card.w, room.x + room.w);
            }
        }
}

TEST_F(WiringCanvas, ClickSelectsAndShiftAdds) {
    click(middle("node.SL"));
    EXPECT_EQ(state.selection.nodes, (std::set<NodeId>{SL}));
    ImGui::GetIO().KeyShift = true;
    click(middle("wire.LR"));
    EXPECT_EQ(state.selection.nodes, (std::set<NodeId>{SL}));
    EXPECT_EQ(state.selection.wires, (std::set<WireEnds>{{SR, ML}}));
    ImGui::GetIO().KeyShift = false;
    click({60, 600});
    EXPECT_TRUE(state.selection.nodes.empty() && state.selection.wires.empty());
}

TEST_F(WiringCanvas, DeletedWireReadsZero) {
    click(middle("wire.LR"));
    key(Action::erase);
    EXPECT_EQ(dials().LR, 0);
    EXPECT_EQ(dials().RL, 1.5f);
    ASSERT_EQ(edits.size(), 1u);
    EXPECT_TRUE(is_four_neurons(brain()));
}

TEST_F(WiringCanvas, DeleteLeavesSensorsAndMotors) {
    click(middle("node.SL"));
    key(Action::erase);
    EXPECT_TRUE(edits.empty());
    EXPECT_EQ(state.refusal.key, "wiring.refused.fixed");
}

TEST_F(WiringCanvas, BoxSelectTakesInTheLeftColumn) {
    const Rect* top = anchors.find("node.SL");
    const Rect* bottom = anchors.find("node.SR");
    drag({top->x - 12, top->y - 12}, {top->x + top->w / 2, bottom->y + bottom->h + 12});
    EXPECT_EQ(state.selection.nodes, (std::set<NodeId>{SL, SR}));
    EXPECT_TRUE(edits.empty());
}

TEST_F(WiringCanvas, DropsADragWhenTheCanvasWasAway) {
    move(middle("pin.SL.out"));
    button(true);
    move(middle("pin.ML.in"));
    ImGui::NewFrame();
    ImGui::Render();
    frames(2);
    button(false);
    EXPECT_TRUE(edits.empty());
}

TEST_F(WiringCanvas, EscIsFreeForOthersWhenThereIsNothingToCancel) {
    EXPECT_FALSE(press_key(state, Action::cancel));
    click(middle("node.SL"));
    EXPECT_TRUE(press_key(state, Action::cancel));
    frames();
    EXPECT_TRUE(state.selection.nodes.empty());
}

TEST_F(WiringCanvas, SurvivesNobodySelectedAndABrainWithoutNodes) {
    view.selected = no_vehicle;
    frames(2);
    view.selected = 7;
    now.brains[0] = std::make_shared<BrainGraph>();
    frames(2);
    click({400, 300});
    EXPECT_TRUE(edits.empty());
}

}  // namespace
}  // namespace braitenlab::tests::wiring_canvas_test
