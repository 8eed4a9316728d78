#include "tests/ui/wiring_fixture.h"
#include "ui/wiring/input.h"

namespace braitenlab::tests::wiring_input_test {

using namespace ui;
using namespace wiring;

namespace {

using WiringInput = CanvasFixture;

TEST_F(WiringInput, AMovedNodeKeepsItsPosition) {
    const vec2 before = middle("node.ML");
    drag(before, before + vec2{40, 50});
    EXPECT_LT(maths::distance(middle("node.ML"), before + vec2{40, 50}), 1);
    EXPECT_EQ(edits.size(), 1u);
    click(middle("canvas.arrange"));
    frames();
    EXPECT_LT(maths::distance(middle("node.ML"), before), 1);
}

TEST_F(WiringInput, DragOnALabelChangesItsWeightInTenthsAsOneGesture) {
    const vec2 label = middle("wire.RL");
    drag(label, label + vec2{-24, 0});
    EXPECT_NEAR(dials().RL, 1.2f, 1e-5f);
    ASSERT_GE(edits.size(), 2u);
    for (const EditRequest& edit : edits) EXPECT_EQ(edit.gesture, edits[0].gesture);
}

TEST_F(WiringInput, ADraggedWeightStopsAtItsRangeAndReversesWithoutADelay) {
    const vec2 label = middle("wire.RL");
    move(label);
    button(true);
    move(label + vec2{0, -300});
    EXPECT_EQ(dials().RL, 2);
    move(label + vec2{0, -292});
    EXPECT_NEAR(dials().RL, 1.9f, 1e-5f);
}

TEST_F(WiringInput, WheelOverALabelChangesItsWeightAndElsewhereZooms) {
    move(middle("wire.LL"));
    wheel(1);
    EXPECT_NEAR(dials().LL, 0.1f, 1e-6f);
    ImGui::GetIO().KeyShift = true;
    wheel(-1);
    EXPECT_NEAR(dials().LL, 0.09f, 1e-6f);
    EXPECT_EQ(edits[0].gesture, edits[1].gesture);
    const float zoom = state.camera.zoom;
    move({60, 600});
    wheel(1);
    EXPECT_GT(state.camera.zoom, zoom);
    EXPECT_EQ(edits.size(), 2u);
}

TEST_F(WiringInput, RightDragPansAndHomeFitsAgain) {
    const vec2 before = middle("node.SL");
    move({60, 600});
    button(true, 1);
    move({100, 560});
    button(false, 1);
    EXPECT_LT(maths::distance(middle("node.SL"), before + vec2{40, -40}), 0.1f);
    key(Action::fit);
    EXPECT_LT(maths::distance(middle("node.SL"), before), 0.1f);
}

TEST_F(WiringInput, ARightClickThatMovesPansAndOpensNoMenu) {
    move({120, 330});
    button(true, 1);
    move({160, 360});
    button(false, 1);
    EXPECT_FALSE(state.menu.open());
}

TEST_F(WiringInput, ClickSelectsAndShiftAdds) {
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

TEST_F(WiringInput, BoxSelectSelectsTheLeftColumn) {
    const Rect* top = anchors.find("node.SL");
    const Rect* bottom = anchors.find("node.SR");
    drag({top->x - 12, top->y - 12}, {top->x + top->w / 2, bottom->y + bottom->h + 12});
    EXPECT_EQ(state.selection.nodes, (std::set<NodeId>{SL, SR}));
    EXPECT_TRUE(edits.empty());
}

TEST_F(WiringInput, AMinimapIsShownFromTwentyOneNodesAndMovesTheView) {
    EXPECT_EQ(anchors.find("canvas.minimap"), nullptr);
    const auto show = [&](int nodes, float zoom) {
        const VehicleId id = view.settings.selection.vehicle;
        now = snapshot_with(large_brain(nodes, 40));
        now.vehicles[0].id = id;
        state.camera.by_user = true;
        state.camera.zoom = zoom;
        frames(3);
    };
    show(20, 1);
    EXPECT_EQ(anchors.find("canvas.minimap"), nullptr);
    show(21, 0.2f);
    EXPECT_EQ(anchors.find("canvas.minimap"), nullptr) << "all nodes are visible";
    show(21, 1);
    const Rect* map = anchors.find("canvas.minimap");
    ASSERT_NE(map, nullptr);
    const Rect r = *map;
    drag({r.x + r.w * 0.5f, r.y + r.h / 2}, {r.x + r.w * 0.25f, r.y + r.h * 0.6f});
    const auto shown = minimap_of(state.layout.get(now.brains[0], state.held), view_of(state.camera, area, 1), area, 1);
    EXPECT_LT(maths::distance(shown->view.to_window(state.camera.middle), {r.x + r.w * 0.25f, r.y + r.h * 0.6f}), 0.6f);
    EXPECT_TRUE(state.selection.nodes.empty());
}

TEST_F(WiringInput, PressKeyIgnoresEscWithoutAnActionToCancel) {
    EXPECT_FALSE(press_key(state, Action::cancel));
    click(middle("node.SL"));
    EXPECT_TRUE(press_key(state, Action::cancel));
    frames();
    EXPECT_TRUE(state.selection.nodes.empty());
}

TEST_F(WiringInput, PressKeyIgnoresUndoAndRedo) {
    drag(middle("node.ML"), middle("node.ML") + vec2{40, 50});
    EXPECT_FALSE(press_key(state, Action::undo));
    EXPECT_FALSE(press_key(state, Action::redo));
}

}  // namespace
}  // namespace braitenlab::tests::wiring_input_test
