#include "tests/ui/hold_shift.h"
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
    hold_shift(true);
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
    hold_shift(true);
    click(middle("wire.LR"));
    EXPECT_EQ(state.selection.nodes, (std::set<NodeId>{SL}));
    EXPECT_EQ(state.selection.wires, (std::set<WireEnds>{{SR, ML}}));
    hold_shift(false);
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

TEST_F(WiringInput, EscCancelsAWireBeingDragged) {
    move(middle("pin.SL.out"));
    button(true);
    move(middle("pin.ML.in"));
    ASSERT_EQ(state.drag.phase, DragPhase::drag_wire);
    key(Action::cancel);
    button(false);
    EXPECT_TRUE(edits.empty());
    EXPECT_EQ(state.drag.phase, DragPhase::idle);
}

TEST_F(WiringInput, EscRestoresADraggedWire) {
    move(on_wire({SR, ML}, 0.8f));
    button(true);
    move({470, 120});
    ASSERT_EQ(state.drag.phase, DragPhase::drag_wire);
    key(Action::cancel);
    button(false);
    EXPECT_TRUE(edits.empty());
}

TEST_F(WiringInput, EscRestoresAMovedNode) {
    const vec2 before = middle("node.ML");
    move(before);
    button(true);
    move(before + vec2{60, 90});
    EXPECT_GT(maths::distance(middle("node.ML"), before), 50);
    key(Action::cancel);
    EXPECT_EQ(middle("node.ML"), before);
    EXPECT_TRUE(edits.empty());
}

TEST_F(WiringInput, EscRestoresADraggedWeight) {
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

TEST_F(WiringInput, LesionPrefersThePartUnderThePointerToTheSelection) {
    click(middle("node.SL"));
    move(middle("wire.LR"));
    key(Action::lesion);
    EXPECT_TRUE(wire(SR, ML)->cut);
    EXPECT_FALSE(find_node(brain(), SL)->silenced);
    move({470, 120});  // empty space
    key(Action::lesion);
    EXPECT_TRUE(find_node(brain(), SL)->silenced) << "no part is under the pointer: the selection is lesioned";
}

TEST_F(WiringInput, LesionsKeepTheParametersAndAreHealedByTheSameKey) {
    click(middle("wire.LR"));
    key(Action::lesion);
    EXPECT_TRUE(wire(SR, ML)->cut);
    EXPECT_EQ(wire(SR, ML)->weight, 1.5f);
    key(Action::lesion);
    EXPECT_FALSE(wire(SR, ML)->cut);
    key(Action::cancel);
    move(middle("node.SL"));  // no selection: the part under the pointer
    key(Action::lesion);
    EXPECT_TRUE(find_node(brain(), SL)->silenced);
    click({60, 600});
    key(Action::lesion);
    EXPECT_EQ(edits.size(), 3u) << "no lesion on empty space";
}

TEST_F(WiringInput, EmptySpaceHasNothingToCut) {
    auto graph = *now.brains[0];
    std::erase_if(graph.wires, [](const Wire& w) { return w.from == SL && w.to == ML; });
    now.brains[0] = std::make_shared<BrainGraph>(graph);
    frames();
    click(middle("wire.LL"));
    key(Action::lesion);
    EXPECT_EQ(state.refusal.key, "wiring.refused.nothing_to_cut");
}

TEST_F(WiringInput, TheMenuOfAWireInsertsANeuron) {
    right_click(middle("wire.RL"));
    choose("insert");
    EXPECT_EQ(weight_of(brain(), {SL, 4}), 1.5f);
    EXPECT_EQ(weight_of(brain(), {4, MR}), 1);
    EXPECT_EQ(edits.size(), 1u);
}

TEST_F(WiringInput, TheMenuFlipsASignAndDetachesWires) {
    right_click(middle("wire.RL"));
    choose("flip");
    EXPECT_EQ(dials().RL, -1.5f);
    right_click(middle("node.SL"));
    choose("detach");
    EXPECT_EQ(dials().RL, 0);
    EXPECT_EQ(dials().LR, 1.5f) << "the other eye keeps its wire";
}

TEST_F(WiringInput, AlignmentAndTidyingAreEdits) {
    const vec2 before = middle("node.ML");
    drag(middle("node.ML"), before + vec2{-60, 30});
    key(Action::select_all);
    right_click(middle("node.ML"));
    choose("column");
    EXPECT_NEAR(middle("node.ML").x, middle("node.SL").x, 0.5f);
    ASSERT_EQ(edits.size(), 2u);
    EXPECT_TRUE(std::holds_alternative<PlaceNodes>(edits[1].command));
    key(Action::tidy);
    EXPECT_LT(maths::distance(middle("node.ML"), before), 1);
    EXPECT_EQ(edits.size(), 3u);
    EXPECT_EQ(brain(), without_places(brain())) << "tidied brains have no positions";
    key(Action::tidy);
    EXPECT_EQ(edits.size(), 3u) << "the brain is tidy already";
}

TEST_F(WiringInput, KeysWalkThroughNeuronsAndMotorsWhichShowTheirSums) {
    BrainGraph graph = *now.brains[0];
    for (const NodeId id : {10u, 11u}) {
        Node neuron;
        neuron.id = static_cast<NodeId>(id), neuron.name = "N" + std::to_string(id);
        graph.nodes.push_back(neuron);
        graph.wires.push_back({SL, neuron.id, 0.5f});
        graph.wires.push_back({neuron.id, ML, 0.5f});
    }
    now.brains[0] = std::make_shared<const BrainGraph>(graph);
    now.neurons.resize(4);
    now.vehicles[0].neuron_count = 4;
    frames(2);
    const auto selected = [&] {
        return state.selection.nodes.size() == 1 ? *state.selection.nodes.begin() : NodeId(99);
    };
    for (const NodeId wanted : {NodeId(10), NodeId(11), ML, MR, NodeId(10)}) {
        key(Action::next_node);
        EXPECT_EQ(selected(), wanted);
        EXPECT_TRUE(anchors.find("canvas.sum")) << wanted;
    }
    key(Action::previous_node);
    EXPECT_EQ(selected(), MR);
    state.selection = {{}, {{SL, ML}}};
    key(Action::previous_node);
    EXPECT_EQ(selected(), MR) << "without a node the last one";
}

TEST_F(WiringInput, ArrowKeysMoveTheSelectionAndDelRemovesIt) {
    key(Action::step_down);
    EXPECT_EQ(state.selection.nodes, (std::set<NodeId>{SL})) << "without a focus the first card";
    key(Action::step_right);
    ASSERT_EQ(state.selection.wires.size(), 1u);
    state.focus = {Part::label, 0, {SR, ML}};
    key(Action::step_down);
    key(Action::step_up);
    state.selection = {{}, {{SR, ML}}};
    key(Action::erase);
    EXPECT_EQ(dials().LR, 0);
}

TEST_F(WiringInput, ANeuronAndAWireCanBeMadeByKeysAlone) {
    key(Action::menu);  // no selection: the menu of the canvas
    ASSERT_TRUE(state.menu.open());
    for (int i = 0; i < 4; ++i) key(Action::step_down);
    key(Action::menu);
    ASSERT_EQ(edits.size(), 1u);
    EXPECT_EQ(find_node(brain(), 4)->curve.response, Response::hump);
    EXPECT_EQ(state.selection.nodes, (std::set<NodeId>{4}));
    key(Action::join);
    key(Action::step_right);
    const NodeId goal = state.focus.node;
    ASSERT_TRUE(goal == ML || goal == MR);
    key(Action::menu);
    EXPECT_EQ(weight_of(brain(), {4, goal}), 1);
    EXPECT_FALSE(state.joining);
}

TEST_F(WiringInput, ArrowKeysWrapAroundInAMenu) {
    key(Action::menu);
    key(Action::step_up);
    EXPECT_EQ(state.menu.current, static_cast<int>(state.menu.rows.size()) - 1);
    key(Action::step_down);
    EXPECT_EQ(state.menu.current, 0);
}

TEST_F(WiringInput, APinReachesFartherForAFingerThanForTheMouse) {
    const vec2 beside{0, 19}, from = middle("pin.SL.out") + beside, to = middle("pin.ML.in") + beside;
    move(from);
    EXPECT_FALSE(state.hovered.is_pin());
    view.program.touch = true;
    frames();
    EXPECT_TRUE(state.hovered.is_pin());
    drag(from, to);
    EXPECT_NE(dials().LL, 0) << "joined";
}

}  // namespace
}  // namespace braitenlab::tests::wiring_input_test
