// The larger gestures: rewiring, inserting, copying, ordering, lesions, and all of it by keys.
#include <algorithm>

#include "tests/ui/large_brain.h"
#include "tests/ui/wiring_hand.h"
#include "ui/wiring/focus.h"
#include "ui/wiring/minimap.h"

namespace braitenlab::tests::wiring_gestures_test {
namespace {

struct WiringGestures : WiringCanvas {
    // A neuron N1 (id 4) without wires, somewhere in the middle.
    void add_neuron_at(vec2 place) {
        right_click(place);
        choose("linear");
        ASSERT_EQ(edits.size(), 1u);
    }
    vec2 on_wire(WireEnds ends, float t) {
        const WireShape* wire = find_shape(state.layout.of(now.brains[0], state.held), ends);
        return view_of(state, area, 1).to_window(bezier_point(wire->bezier, t));
    }
    const Wire* wire(NodeId from, NodeId to) const { return find_wire(brain(), from, to); }
};

TEST_F(WiringGestures, AWireTakenByItsEndIsMovedWithItsNumbers) {
    auto graph = *now.brains[0];
    find_wire(graph, SR, ML)->threshold = 0.25f;
    now.brains[0] = std::make_shared<BrainGraph>(graph);
    frames();
    drag(on_wire({SR, ML}, 0.8f), middle("pin.MR.in"));
    EXPECT_EQ(dials().LR, 0);
    EXPECT_EQ(dials().RR, 1.5f);
    EXPECT_EQ(wire(SR, MR)->threshold, 0.25f);
    EXPECT_EQ(edits.size(), 1u);
}

TEST_F(WiringGestures, LTakesWhatIsUnderThePointerBeforeWhatIsSelected) {
    click(middle("node.SL"));
    move(middle("wire.LR"));
    key(Action::lesion);
    EXPECT_TRUE(wire(SR, ML)->cut);
    EXPECT_FALSE(find_node(brain(), SL)->silenced);
    move({470, 120});  // empty ground
    key(Action::lesion);
    EXPECT_TRUE(find_node(brain(), SL)->silenced) << "with nothing there, it is for what is selected";
}

TEST_F(WiringGestures, AWireTakenByItsStartGetsAnotherSource) {
    drag(on_wire({SR, ML}, 0.12f), middle("pin.SL.out"));
    EXPECT_EQ(dials().LR, 0);
    EXPECT_EQ(dials().LL, 1.5f);
}

TEST_F(WiringGestures, AWireLetGoOverEmptyGroundIsTakenOff) {
    drag(on_wire({SR, ML}, 0.8f), {470, 120});
    EXPECT_EQ(dials().LR, 0);
    EXPECT_FALSE(state.menu.open());
    EXPECT_EQ(edits.size(), 1u);
}

TEST_F(WiringGestures, EscGivesATakenWireBack) {
    move(on_wire({SR, ML}, 0.8f));
    button(true);
    move({470, 120});
    ASSERT_EQ(state.drag.phase, CanvasPhase::drag_wire);
    key(Action::cancel);
    button(false);
    EXPECT_TRUE(edits.empty());
}

TEST_F(WiringGestures, ANeuronWithoutWiresThatIsDroppedOnAWireIsPutIntoIt) {
    add_neuron_at({120, 330});
    drag(middle("node.N1"), on_wire({SR, ML}, 0.6f));
    ASSERT_EQ(edits.size(), 2u);
    EXPECT_EQ(weight_of(brain(), {SR, 4}), 1.5f);
    EXPECT_EQ(weight_of(brain(), {4, ML}), 1);
    EXPECT_EQ(dials().LR, 0);
    drag(middle("node.N1"), on_wire({SL, MR}, 0.6f));
    ASSERT_EQ(edits.size(), 3u);
    EXPECT_TRUE(std::holds_alternative<PlaceNodes>(edits[2].command)) << "one that has wires is only moved";
}

TEST_F(WiringGestures, TheMenuOfAWirePutsANeuronIn) {
    right_click(middle("wire.RL"));
    choose("insert");
    EXPECT_EQ(weight_of(brain(), {SL, 4}), 1.5f);
    EXPECT_EQ(weight_of(brain(), {4, MR}), 1);
    EXPECT_EQ(edits.size(), 1u);
}

TEST_F(WiringGestures, TheMenuTurnsASignAndTakesWiresOff) {
    right_click(middle("wire.RL"));
    choose("flip");
    EXPECT_EQ(dials().RL, -1.5f);
    right_click(middle("node.SL"));
    choose("detach");
    EXPECT_EQ(dials().RL, 0);
    EXPECT_EQ(dials().LR, 1.5f) << "the other eye keeps its wire";
}

TEST_F(WiringGestures, ARightClickThatMovesPansAndOpensNoMenu) {
    move({120, 330});
    button(true, 1);
    move({160, 360});
    button(false, 1);
    EXPECT_FALSE(state.menu.open());
}

TEST_F(WiringGestures, CopyAndPasteMakeANeuronOfTheSameKindAtTheMouse) {
    drag(middle("pin.SL.out"), {470, 330});
    choose("sigmoid");
    click(middle("node.N1"));
    key(Action::copy);
    move({470, 615});
    key(Action::paste);
    const Node* copy = find_node(brain(), 5);
    ASSERT_NE(copy, nullptr);
    EXPECT_EQ(copy->curve.response, Response::sigmoid);
    EXPECT_EQ(copy->name, "N2");
    EXPECT_LT(maths::distance(middle("node.N2"), {470, 615}), 1.5f);
    EXPECT_EQ(wire(SL, 5), nullptr) << "the eye was not selected";
    EXPECT_EQ(state.selection.nodes, (std::set<NodeId>{5}));
    key(Action::paste);
    EXPECT_GT(maths::distance(middle("node.N3"), middle("node.N2")), 20) << "a second copy does not hide the first";
}

TEST_F(WiringGestures, APastedNeuronCoversNothing) {
    add_neuron_at({470, 625});
    click(middle("node.N1"));
    key(Action::copy);
    for (const char* over : {"node.SL", "wire.LR", "node.N1"}) {
        move(middle(over));
        key(Action::paste);
    }
    const Layout& layout = state.layout.of(now.brains[0], {});
    ASSERT_EQ(layout.nodes.size(), 8u);
    const auto covers = [](vec2 a, vec2 a_size, vec2 b, vec2 b_size) {
        return std::abs(a.x - b.x) * 2 < a_size.x + b_size.x && std::abs(a.y - b.y) * 2 < a_size.y + b_size.y;
    };
    for (const NodeShape& a : layout.nodes) {
        for (const NodeShape& b : layout.nodes)
            EXPECT_FALSE(a.id < b.id && covers(a.centre, a.size, b.centre, b.size)) << a.id << " " << b.id;
        for (const WireShape& wire : layout.wires)
            EXPECT_FALSE(covers(a.centre, a.size, wire.label, wire.label_size)) << a.id;
    }
}

TEST_F(WiringGestures, WiresToSelectedEyesAreCopiedAlong) {
    drag(middle("pin.SL.out"), {470, 330});
    choose("linear");
    click(middle("node.N1"));
    ImGui::GetIO().KeyShift = true;
    click(middle("node.SL"));
    ImGui::GetIO().KeyShift = false;
    key(Action::copy);
    key(Action::paste);
    EXPECT_EQ(weight_of(brain(), {SL, 5}), 1);
}

TEST_F(WiringGestures, CutTakesOutAndPasteBringsBack) {
    add_neuron_at({470, 625});
    key(Action::cut);
    EXPECT_EQ(find_node(brain(), 4), nullptr);
    key(Action::paste);
    EXPECT_NE(find_node(brain(), 4), nullptr);
}

TEST_F(WiringGestures, DuplicateStandsBesideAndLeavesTheClipboardAlone) {
    add_neuron_at({470, 625});
    key(Action::duplicate);
    ASSERT_NE(anchors.find("node.N2"), nullptr) << "the view follows it where it would be out of sight";
    EXPECT_GT(find_node(brain(), 5)->place->y, find_node(brain(), 4)->place->y);
    EXPECT_TRUE(state.clipboard.empty());
}

TEST_F(WiringGestures, SensorsAndMotorsCannotBeCopied) {
    click(middle("node.SL"));
    key(Action::copy);
    EXPECT_EQ(state.refusal.key, "wiring.refused.nothing_to_copy");
    key(Action::paste);
    EXPECT_EQ(state.refusal.key, "wiring.refused.nothing_copied");
    EXPECT_TRUE(edits.empty());
}

TEST_F(WiringGestures, LesionsKeepTheNumbersAndAreHealedByTheSameKey) {
    click(middle("wire.LR"));
    key(Action::lesion);
    EXPECT_TRUE(wire(SR, ML)->cut);
    EXPECT_EQ(wire(SR, ML)->weight, 1.5f);
    key(Action::lesion);
    EXPECT_FALSE(wire(SR, ML)->cut);
    key(Action::cancel);
    move(middle("node.SL"));  // nothing is selected: what is under the cursor
    key(Action::lesion);
    EXPECT_TRUE(find_node(brain(), SL)->silenced);
    click({60, 600});
    key(Action::lesion);
    EXPECT_EQ(edits.size(), 3u) << "empty ground has nothing to cut";
}

TEST_F(WiringGestures, AFreePlaceHasNothingToCut) {
    auto graph = *now.brains[0];
    std::erase_if(graph.wires, [](const Wire& w) { return w.from == SL && w.to == ML; });
    now.brains[0] = std::make_shared<BrainGraph>(graph);
    frames();
    click(middle("wire.LL"));
    key(Action::lesion);
    EXPECT_EQ(state.refusal.key, "wiring.refused.nothing_to_cut");
}

TEST_F(WiringGestures, ADragOfNodesIsOneEditOfTheBrainAskedForWhenLetGo) {
    click(middle("node.MR"));
    ImGui::GetIO().KeyShift = true;
    click(middle("node.ML"));
    ImGui::GetIO().KeyShift = false;
    const vec2 before = middle("node.ML"), other = middle("node.MR"), eye = middle("node.SL");
    move(before);
    button(true);
    for (int i = 1; i <= 5; ++i) move(before + vec2{8, 10} * static_cast<float>(i));
    EXPECT_TRUE(edits.empty());
    EXPECT_LT(maths::distance(middle("node.ML"), before + vec2{40, 50}), 1.5f) << "it goes along with the hand";
    button(false);
    EXPECT_LT(maths::distance(middle("node.ML"), before + vec2{40, 50}), 1.5f) << "nor does it jump back for a frame";
    frames(2);
    EXPECT_LT(maths::distance(middle("node.ML"), before + vec2{40, 50}), 1.5f);
    EXPECT_LT(maths::distance(middle("node.MR"), other + vec2{40, 50}), 1.5f);
    EXPECT_EQ(middle("node.SL"), eye);
    ASSERT_EQ(edits.size(), 1u);
    const auto& places = std::get<PlaceNodes>(edits[0].command);
    EXPECT_EQ(places.target, (Target{.kind = 0}));
    EXPECT_EQ(places.places.size(), 4u) << "all stay where they are from now on";
    EXPECT_TRUE(is_four_neurons(brain()));
    drag(middle("node.ML"), middle("node.ML") + vec2{3, 0});
    EXPECT_EQ(edits.size(), 1u) << "a click moves nothing";
    const vec2 again = middle("node.ML");
    move(again);
    button(true);
    move(again + vec2{30, 0});
    move(again);
    button(false);
    EXPECT_EQ(edits.size(), 1u) << "back where it stood";
}

TEST_F(WiringGestures, UndoAndRedoAreTheLabsAlone) {
    drag(middle("node.ML"), middle("node.ML") + vec2{40, 50});
    EXPECT_FALSE(press_key(state, Action::undo));
    EXPECT_FALSE(press_key(state, Action::redo));
}

TEST_F(WiringGestures, AlignmentAndTidyingAreEditsToo) {
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
    EXPECT_EQ(brain(), without_places(brain())) << "tidied brains need no places";
    key(Action::tidy);
    EXPECT_EQ(edits.size(), 3u) << "there is nothing left to tidy";
}

TEST_F(WiringGestures, AnEditMovesNobodyElse) {
    const BrainGraph crowd = large_brain(9, 24);
    const VehicleId id = view.selected;
    now = moment_with(crowd);
    now.vehicles[0].id = id;
    frames(3);
    const Layout shown = state.layout.of(now.brains[0], {});
    const auto expect_as_shown = [&] {
        for (const NodeShape& shape : state.layout.of(now.brains[0], {}).nodes)
            if (const NodeShape* before = find_shape(shown, shape.id)) {
                EXPECT_EQ(shape.centre, before->centre) << shape.id;
            }
    };
    for (const char* name : {"N1", "N2", "N3"}) {
        state.selection = {{find_node(brain(), std::string(name))->id}, {}};
        key(Action::erase);
        expect_as_shown();
    }
    EXPECT_EQ(edits.size(), 3u);
    EXPECT_NE(tidy(brain()), tidy(crowd)) << "tidying would have moved some";
}

TEST_F(WiringGestures, ArrowsSelectOneThingAfterTheOtherAndDelRemovesIt) {
    key(Action::step_down);
    EXPECT_EQ(state.selection.nodes, (std::set<NodeId>{SL})) << "from nothing, the first card";
    key(Action::step_right);
    ASSERT_EQ(state.selection.wires.size(), 1u);
    state.focus = {Part::label, 0, {SR, ML}};
    key(Action::step_down);
    key(Action::step_up);
    state.selection = {{}, {{SR, ML}}};
    key(Action::erase);
    EXPECT_EQ(dials().LR, 0);
}

// Everything that arrows lead to from the first card on.
std::size_t reached(const Layout& layout) {
    std::vector<Hit> seen{next_towards(layout, {}, Towards::right)};
    for (std::size_t i = 0; i < seen.size(); ++i)
        for (const Towards to : {Towards::left, Towards::right, Towards::up, Towards::down}) {
            const Hit next = next_towards(layout, seen[i], to);
            if (std::find(seen.begin(), seen.end(), next) == seen.end()) seen.push_back(next);
        }
    return seen.size();
}

TEST_F(WiringGestures, ArrowsLeadToEverything) {
    for (const BrainGraph& graph : {make_graph({.LR = 1, .RL = 1}), large_brain(12, 24), large_brain(30, 60)}) {
        const Layout layout = lay_out(graph, {});
        EXPECT_EQ(reached(layout), layout.nodes.size() + layout.wires.size());
    }
}

TEST_F(WiringGestures, KeysAloneMakeANeuronAndAWire) {
    key(Action::menu);  // nothing is selected: the canvas's own
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

TEST_F(WiringGestures, KeysWalkAMenuRound) {
    key(Action::menu);
    key(Action::step_up);
    EXPECT_EQ(state.menu.current, static_cast<int>(state.menu.rows.size()) - 1);
    key(Action::step_down);
    EXPECT_EQ(state.menu.current, 0);
}

TEST_F(WiringGestures, AFullBrainSaysHowMuchItHolds) {
    BrainGraph graph = *now.brains[0];
    for (int i = 0; i < limits::neurons; ++i) {
        Node node;
        node.id = 4 + i, node.name = "N" + std::to_string(i + 1);
        graph.nodes.push_back(node);
    }
    now.brains[0] = std::make_shared<BrainGraph>(graph);
    now.neurons.resize(graph.nodes.size());
    now.vehicles[0].neuron_count = static_cast<int>(graph.nodes.size()) - 2;
    frames(2);
    key(Action::menu);
    key(Action::menu);
    EXPECT_EQ(state.refusal.key, "wiring.refused.neurons");
    EXPECT_TRUE(edits.empty());
}

TEST_F(WiringGestures, AMinimapStandsFromTwentyOneNodesOnAndMovesTheView) {
    EXPECT_EQ(anchors.find("canvas.minimap"), nullptr);
    const auto show = [&](int nodes, float zoom) {
        const VehicleId id = view.selected;
        now = moment_with(large_brain(nodes, 40));
        now.vehicles[0].id = id;
        state.own_view = true;
        state.zoom = zoom;
        frames(3);
    };
    show(20, 1);
    EXPECT_EQ(anchors.find("canvas.minimap"), nullptr);
    show(21, 0.2f);
    EXPECT_EQ(anchors.find("canvas.minimap"), nullptr) << "everything is in sight";
    show(21, 1);
    const Rect* map = anchors.find("canvas.minimap");
    ASSERT_NE(map, nullptr);
    const Rect r = *map;
    drag({r.x + r.w * 0.5f, r.y + r.h / 2}, {r.x + r.w * 0.25f, r.y + r.h * 0.6f});
    const auto shown = minimap_of(state.layout.of(now.brains[0], state.held), view_of(state, area, 1), area, 1);
    EXPECT_LT(maths::distance(shown->view.to_window(state.middle), {r.x + r.w * 0.25f, r.y + r.h * 0.6f}), 0.6f);
    EXPECT_TRUE(state.selection.nodes.empty());
}

}  // namespace
}  // namespace braitenlab::tests::wiring_gestures_test
