#include "tests/ui/wiring_fixture.h"
#include "ui/wiring/actions.h"

namespace braitenlab::tests::wiring_actions_test {

using namespace ui;
using namespace wiring;

namespace {

using WiringActions = CanvasFixture;

TEST_F(WiringActions, EscCancelsAWireBeingDragged) {
    move(middle("pin.SL.out"));
    button(true);
    move(middle("pin.ML.in"));
    ASSERT_EQ(state.drag.phase, DragPhase::drag_wire);
    key(Action::cancel);
    button(false);
    EXPECT_TRUE(edits.empty());
    EXPECT_EQ(state.drag.phase, DragPhase::idle);
}

TEST_F(WiringActions, EscRestoresADraggedWire) {
    move(on_wire({SR, ML}, 0.8f));
    button(true);
    move({470, 120});
    ASSERT_EQ(state.drag.phase, DragPhase::drag_wire);
    key(Action::cancel);
    button(false);
    EXPECT_TRUE(edits.empty());
}

TEST_F(WiringActions, EscRestoresAMovedNode) {
    const vec2 before = middle("node.ML");
    move(before);
    button(true);
    move(before + vec2{60, 90});
    EXPECT_GT(maths::distance(middle("node.ML"), before), 50);
    key(Action::cancel);
    EXPECT_EQ(middle("node.ML"), before);
    EXPECT_TRUE(edits.empty());
}

TEST_F(WiringActions, EscRestoresADraggedWeight) {
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

TEST_F(WiringActions, LesionPrefersThePartUnderThePointerToTheSelection) {
    click(middle("node.SL"));
    move(middle("wire.LR"));
    key(Action::lesion);
    EXPECT_TRUE(wire(SR, ML)->cut);
    EXPECT_FALSE(find_node(brain(), SL)->silenced);
    move({470, 120});  // empty space
    key(Action::lesion);
    EXPECT_TRUE(find_node(brain(), SL)->silenced) << "no part is under the pointer: the selection is lesioned";
}

TEST_F(WiringActions, LesionsKeepTheParametersAndAreHealedByTheSameKey) {
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

TEST_F(WiringActions, EmptySpaceHasNothingToCut) {
    auto graph = *now.brains[0];
    std::erase_if(graph.wires, [](const Wire& w) { return w.from == SL && w.to == ML; });
    now.brains[0] = std::make_shared<BrainGraph>(graph);
    frames();
    click(middle("wire.LL"));
    key(Action::lesion);
    EXPECT_EQ(state.refusal.key, "wiring.refused.nothing_to_cut");
}

TEST_F(WiringActions, TheMenuOfAWireInsertsANeuron) {
    right_click(middle("wire.RL"));
    choose("insert");
    EXPECT_EQ(weight_of(brain(), {SL, 4}), 1.5f);
    EXPECT_EQ(weight_of(brain(), {4, MR}), 1);
    EXPECT_EQ(edits.size(), 1u);
}

TEST_F(WiringActions, TheMenuFlipsASignAndDetachesWires) {
    right_click(middle("wire.RL"));
    choose("flip");
    EXPECT_EQ(dials().RL, -1.5f);
    right_click(middle("node.SL"));
    choose("detach");
    EXPECT_EQ(dials().RL, 0);
    EXPECT_EQ(dials().LR, 1.5f) << "the other eye keeps its wire";
}

TEST_F(WiringActions, AlignmentAndTidyingAreEdits) {
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

TEST_F(WiringActions, ArrowKeysMoveTheSelectionAndDelRemovesIt) {
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

TEST_F(WiringActions, ANeuronAndAWireCanBeMadeByKeysAlone) {
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

TEST_F(WiringActions, ArrowKeysWrapAroundInAMenu) {
    key(Action::menu);
    key(Action::step_up);
    EXPECT_EQ(state.menu.current, static_cast<int>(state.menu.rows.size()) - 1);
    key(Action::step_down);
    EXPECT_EQ(state.menu.current, 0);
}

}  // namespace
}  // namespace braitenlab::tests::wiring_actions_test
