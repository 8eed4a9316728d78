#include "ui/wiring/drop.h"

#include "ui/wiring/actions.h"

namespace braitenlab {

namespace {}  // namespace

std::string refusal_key(Refusal refusal) { return "wiring.refused." + std::string(name(refusal)); }

WireDrop drop_of(const CanvasState& state, const CanvasFrame& frame) {
    const CanvasDrag& drag = state.drag;
    const Pointer& pointer = frame.pointer;
    if (!pointer.over) return {};
    const Hit under = hit(frame.layout, view_of(state, frame), pointer.at, frame.ui_scale);
    const bool on_pin = under.part == Part::in_pin || under.part == Part::out_pin;
    if (!on_pin && under.part != Part::node) {
        if (drag.taken && under.wire == *drag.taken && under.part != Part::nothing) return {};  // back where it was
        return {drag.taken ? WireDrop::What::take_off : WireDrop::What::new_neuron, {}, {}};
    }
    const Part own = drag.outwards ? Part::out_pin : Part::in_pin;
    // A card stands for its pin; back on its own card a wire is put away.
    if (under.node == drag.fixed && (!on_pin || under.part == own)) return {};
    // A sensor has no in-pin: its out-pin then means the sensor itself, and the edit says why not.
    const NodeShape* shape = find_shape(frame.layout, under.node);
    const bool lacks_pin = !drag.outwards && !shape->has_out;  // a motor where there is no neuron to feed
    if (lacks_pin || (on_pin && under.part == own && shape->has_in))
        return {
            WireDrop::What::refused, {}, drag.outwards ? "wiring.refused.two_outputs" : "wiring.refused.two_inputs"};
    const WireEnds ends = drag.outwards ? WireEnds{drag.fixed, under.node} : WireEnds{under.node, drag.fixed};
    if (drag.taken && ends == *drag.taken) return {};
    const Edit edit = connect(drag.graph, ends);
    if (!edit) return {WireDrop::What::refused, ends, refusal_key(edit.refusal)};
    return {WireDrop::What::connect, ends, {}};
}

std::optional<WireEnds> insertion_of(const CanvasState& state, const CanvasFrame& frame) {
    const auto& moved = state.selection.nodes;
    if (state.drag.phase != CanvasPhase::move_nodes || moved.size() != 1) return {};
    const NodeShape* shape = find_shape(frame.layout, *moved.begin());
    if (shape == nullptr || shape->kind != NodeKind::neuron || is_wired(state.drag.graph, shape->id)) return {};
    return wire_through(frame.layout, shape->centre, shape->size.y / 2);
}

void drop_wire(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    const CanvasDrag& drag = state.drag;
    const WireDrop drop = drop_of(state, frame);
    switch (drop.what) {
        case WireDrop::What::nothing:
            return;
        case WireDrop::What::refused:
            return refuse(state, frame, drop.reason);
        case WireDrop::What::new_neuron:
            return open_drop_menu(state, frame, drag.pressed);
        case WireDrop::What::take_off:
            ask(state, frame, remove(drag.graph, {}, {*drag.taken}), drag.gesture, outbox);
            state.selection = {};
            return;
        case WireDrop::What::connect:
            break;
    }
    if (drag.taken)
        ask(state, frame, reconnect(drag.graph, *drag.taken, drop.ends), drag.gesture, outbox);
    else if (direct_dial(drag.graph, drop.ends))
        ask_weight(frame, drag.graph, drop.ends, 1, drag.gesture, outbox);
    else
        ask(state, frame, connect(drag.graph, drop.ends), drag.gesture, outbox);
    select(state, {Part::label, 0, drop.ends}, false);
}

void drop_nodes(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    const CanvasDrag& drag = state.drag;
    const auto into = insertion_of(state, frame);
    if (!into && state.held == drag.places) return;  // back where they stood
    if (!into) return ask_places(frame, state.held, drag.gesture, outbox);
    ask(state, frame, insert_neuron(drag.graph, *state.selection.nodes.begin(), *into), drag.gesture, outbox);
}

}  // namespace braitenlab
