#include <cmath>

#include "tests/ui/hold_shift.h"
#include "tests/ui/wiring_fixture.h"
#include "ui/wiring/edits.h"

namespace braitenlab::tests::wiring_edits_test {

using namespace ui;
using namespace wiring;

namespace {

using WiringEdits = CanvasFixture;

TEST_F(WiringEdits, DragFromPinToPinTurnsAGhostIntoWeightOne) {
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

TEST_F(WiringEdits, DragBackwardsFromInPinToOutPinMakesTheSameWire) {
    drag(middle("pin.ML.in"), middle("pin.SL.out"));
    EXPECT_EQ(dials().LL, 1);
}

TEST_F(WiringEdits, DropOnACardMeansItsPin) {
    drag(middle("pin.SR.out"), middle("node.MR"));
    EXPECT_EQ(dials().RR, 1);
}

TEST_F(WiringEdits, EditsOnlyTheSelectedVehicleInTheScopeOfOneVehicle) {
    view.settings.selection.whole_kind = false;
    drag(middle("pin.SL.out"), middle("pin.ML.in"));
    ASSERT_EQ(edits.size(), 1u);
    EXPECT_EQ(std::get<TurnDial>(edits[0].command).target.vehicle, 7);
}

TEST_F(WiringEdits, RefusesADuplicateWithAReason) {
    drag(middle("pin.SL.out"), middle("pin.MR.in"));
    EXPECT_TRUE(edits.empty());
    EXPECT_EQ(state.refusal.key, "wiring.refused.duplicate");
    EXPECT_NE(anchors.find("refused.duplicate"), nullptr) << "the reason is shown at the pointer";
}

TEST_F(WiringEdits, RefusesAWireIntoASensorAndBetweenEqualPins) {
    drag(middle("pin.SL.out"), middle("node.SR"));
    EXPECT_EQ(state.refusal.key, "wiring.refused.into_sensor");
    drag(middle("pin.ML.in"), middle("pin.MR.in"));
    EXPECT_EQ(state.refusal.key, "wiring.refused.two_inputs");
    EXPECT_TRUE(edits.empty());
}

TEST_F(WiringEdits, DropOnEmptySpaceOffersNeuronsAndMovesNothingElse) {
    const vec2 eye = middle("node.SL"), motor = middle("node.MR"), place{470, 350};
    drag(middle("pin.SL.out"), place);
    EXPECT_TRUE(edits.empty()) << "no kind of neuron is chosen yet";
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

TEST_F(WiringEdits, ADropFromAnInputMakesANeuronThatFeedsIt) {
    drag(middle("pin.ML.in"), {470, 350});
    choose("leaky");
    EXPECT_EQ(weight_of(brain(), {4, ML}), 1);
    EXPECT_GT(find_node(brain(), 4)->time_constant, 0);
}

TEST_F(WiringEdits, ACancelledDropMenuMakesNothing) {
    drag(middle("pin.SL.out"), {470, 350});
    ASSERT_TRUE(state.menu.open());
    key(Action::cancel);
    EXPECT_FALSE(state.menu.open());
    drag(middle("pin.SL.out"), {470, 350});
    click({60, 600});
    EXPECT_FALSE(state.menu.open());
    EXPECT_TRUE(edits.empty());
}

TEST_F(WiringEdits, AWireDraggedByItsEndMovesWithItsParameters) {
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

TEST_F(WiringEdits, AWireDraggedByItsStartGetsAnotherSource) {
    drag(on_wire({SR, ML}, 0.12f), middle("pin.SL.out"));
    EXPECT_EQ(dials().LR, 0);
    EXPECT_EQ(dials().LL, 1.5f);
}

TEST_F(WiringEdits, AWireDroppedOnEmptySpaceIsRemoved) {
    drag(on_wire({SR, ML}, 0.8f), {470, 120});
    EXPECT_EQ(dials().LR, 0);
    EXPECT_FALSE(state.menu.open());
    EXPECT_EQ(edits.size(), 1u);
}

TEST_F(WiringEdits, ANeuronWithoutWiresIsInsertedIntoTheWireItIsDroppedOn) {
    add_neuron_at({120, 330});
    drag(middle("node.N1"), on_wire({SR, ML}, 0.6f));
    ASSERT_EQ(edits.size(), 2u);
    EXPECT_EQ(weight_of(brain(), {SR, 4}), 1.5f);
    EXPECT_EQ(weight_of(brain(), {4, ML}), 1);
    EXPECT_EQ(dials().LR, 0);
    drag(middle("node.N1"), on_wire({SL, MR}, 0.6f));
    ASSERT_EQ(edits.size(), 3u);
    EXPECT_TRUE(std::holds_alternative<PlaceNodes>(edits[2].command)) << "a neuron with wires is only moved";
}

TEST_F(WiringEdits, ANeuronThatWasAddedIsSelected) {
    right_click({470, 600});
    choose("step");
    frames(5);
    EXPECT_EQ(state.selection.nodes, (std::set<NodeId>{4}));
}

TEST_F(WiringEdits, ANeuronThatIsAddedOnACardOrItsPinGoesToAFreePlace) {
    const vec2 pin = middle("pin.SR.out");
    right_click(pin + vec2{30, 12});
    choose("step");
    frames(5);
    const Rect *added = anchors.find("node.N1"), *eye = anchors.find("node.SR");
    ASSERT_TRUE(added && eye);
    EXPECT_FALSE(added->contains(pin.x, pin.y));
    const bool apart = added->x >= eye->x + eye->w || added->x + added->w <= eye->x || added->y >= eye->y + eye->h ||
                       added->y + added->h <= eye->y;
    EXPECT_TRUE(apart);
}

TEST_F(WiringEdits, DeletedWireReadsZero) {
    click(middle("wire.LR"));
    key(Action::erase);
    EXPECT_EQ(dials().LR, 0);
    EXPECT_EQ(dials().RL, 1.5f);
    ASSERT_EQ(edits.size(), 1u);
    EXPECT_TRUE(is_four_neurons(brain()));
}

TEST_F(WiringEdits, DeleteKeepsSensorsAndMotors) {
    click(middle("node.SL"));
    key(Action::erase);
    EXPECT_TRUE(edits.empty());
    EXPECT_EQ(state.refusal.key, "wiring.refused.fixed");
}

TEST_F(WiringEdits, CopyAndPasteMakeANeuronOfTheSameKindAtTheMouse) {
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

TEST_F(WiringEdits, ANeuronThatIsAddedAtTheRimIsWhollyInSight) {
    add_neuron_at({470, area.y + area.h - 4});
    frames(2);
    const Rect* node = anchors.find("node.N1");
    ASSERT_TRUE(node);
    EXPECT_LE(node->y + node->h, area.y + area.h - 4);
}

TEST_F(WiringEdits, APastedNeuronDoesNotOverlapOtherNodes) {
    add_neuron_at({470, 625});
    click(middle("node.N1"));
    key(Action::copy);
    for (const char* over : {"node.SL", "wire.LR", "node.N1"}) {
        move(middle(over));
        key(Action::paste);
    }
    const Layout& layout = state.layout.get(now.brains[0], {});
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

TEST_F(WiringEdits, WiresToSelectedEyesAreCopied) {
    drag(middle("pin.SL.out"), {470, 330});
    choose("linear");
    click(middle("node.N1"));
    hold_shift(true);
    click(middle("node.SL"));
    hold_shift(false);
    key(Action::copy);
    key(Action::paste);
    EXPECT_EQ(weight_of(brain(), {SL, 5}), 1);
}

TEST_F(WiringEdits, CutRemovesAndPasteRestores) {
    add_neuron_at({470, 625});
    key(Action::cut);
    EXPECT_EQ(find_node(brain(), 4), nullptr);
    key(Action::paste);
    EXPECT_NE(find_node(brain(), 4), nullptr);
}

TEST_F(WiringEdits, DuplicateIsPlacedBesideTheOriginalAndKeepsTheClipboard) {
    add_neuron_at({470, 625});
    key(Action::duplicate);
    ASSERT_NE(anchors.find("node.N2"), nullptr) << "the camera follows when it would not be visible";
    EXPECT_GT(find_node(brain(), 5)->place->y, find_node(brain(), 4)->place->y);
    EXPECT_TRUE(state.clipboard.empty());
}

TEST_F(WiringEdits, SensorsAndMotorsCannotBeCopied) {
    click(middle("node.SL"));
    key(Action::copy);
    EXPECT_EQ(state.refusal.key, "wiring.refused.nothing_to_copy");
    key(Action::paste);
    EXPECT_EQ(state.refusal.key, "wiring.refused.nothing_copied");
    EXPECT_TRUE(edits.empty());
}

TEST_F(WiringEdits, ADragOfNodesIsOneEditSentAtTheRelease) {
    click(middle("node.MR"));
    hold_shift(true);
    click(middle("node.ML"));
    hold_shift(false);
    const vec2 before = middle("node.ML"), other = middle("node.MR"), eye = middle("node.SL");
    move(before);
    button(true);
    for (int i = 1; i <= 5; ++i) move(before + vec2{8, 10} * static_cast<float>(i));
    EXPECT_TRUE(edits.empty());
    EXPECT_LT(maths::distance(middle("node.ML"), before + vec2{40, 50}), 1.5f) << "it follows the pointer";
    button(false);
    EXPECT_LT(maths::distance(middle("node.ML"), before + vec2{40, 50}), 1.5f) << "it does not jump back for a frame";
    frames(2);
    EXPECT_LT(maths::distance(middle("node.ML"), before + vec2{40, 50}), 1.5f);
    EXPECT_LT(maths::distance(middle("node.MR"), other + vec2{40, 50}), 1.5f);
    EXPECT_EQ(middle("node.SL"), eye);
    ASSERT_EQ(edits.size(), 1u);
    const auto& places = std::get<PlaceNodes>(edits[0].command);
    EXPECT_EQ(places.target, (Target{.kind = 0}));
    EXPECT_EQ(places.places.size(), 4u) << "all other nodes get their shown positions";
    EXPECT_TRUE(is_four_neurons(brain()));
    drag(middle("node.ML"), middle("node.ML") + vec2{3, 0});
    EXPECT_EQ(edits.size(), 1u) << "a click does not move a node";
    const vec2 again = middle("node.ML");
    move(again);
    button(true);
    move(again + vec2{30, 0});
    move(again);
    button(false);
    EXPECT_EQ(edits.size(), 1u) << "it is back at its old position";
}

TEST_F(WiringEdits, AnEditMovesNoOtherNode) {
    const BrainGraph crowd = large_brain(9, 24);
    const VehicleId id = view.settings.selection.vehicle;
    now = snapshot_with(crowd);
    now.vehicles[0].id = id;
    frames(3);
    const Layout shown = state.layout.get(now.brains[0], {});
    const auto expect_as_shown = [&] {
        for (const NodeShape& shape : state.layout.get(now.brains[0], {}).nodes)
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

TEST_F(WiringEdits, AFullBrainRefusesAnotherNeuron) {
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

}  // namespace
}  // namespace braitenlab::tests::wiring_edits_test
