#include "ui/wiring/make.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/wiring/actions.h"

namespace braitenlab {

using maths::vec2;

namespace {

// Room for the piece and a little around it.
vec2 room_of(const BrainFragment& piece) {
    constexpr float clear = 10;
    vec2 reach;
    for (const Node& neuron : piece.neurons)
        reach = {std::max(reach.x, std::abs(neuron.place->x)), std::max(reach.y, std::abs(neuron.place->y))};
    return reach * 2 + card_size(NodeKind::neuron) + vec2{2 * clear, 2 * clear};
}

// Near the wanted place, where it covers nothing.
void paste_at(CanvasState& state, const CanvasFrame& frame, const BrainFragment& piece, vec2 wanted, Outbox& outbox) {
    const vec2 middle = free_place(frame.layout, wanted, room_of(piece));
    const Pasted pasted = paste_fragment(frame.graph, piece, middle);
    if (!pasted.edit) return refuse(state, frame, pasted.edit.refusal);
    state.selection = {pasted.added, {}};
    const vec2 pixel = view_of(state, frame).to_window(middle);
    if (!frame.area.contains(pixel.x, pixel.y)) reveal(state, frame.area, frame.ui_scale, middle);
    ask(state, frame, pasted.edit, state.next_gesture++, outbox);
}

// The brain with a neuron more, which is selected and stands there.
void ask_with_new(CanvasState& state, const CanvasFrame& frame, BrainGraph edited, NodeId fresh, vec2 place,
                  Outbox& outbox) {
    const auto made =
        std::find_if(edited.nodes.begin(), edited.nodes.end(), [&](const Node& node) { return node.id == fresh; });
    made->place = rounded_position(place);
    ask(state, frame, std::move(edited), state.next_gesture++, outbox);
    state.selection = {{fresh}, {}};
    state.focus = {Part::node, fresh, {}};
}

}  // namespace

void erase_selected(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    if (nothing_selected(state)) return;
    const Edit edit = remove(frame.graph, state.selection.nodes, state.selection.wires);
    if (!edit) return refuse(state, frame, edit.refusal);
    ask(state, frame, edit, state.next_gesture++, outbox);
    state.selection = {};
    if (!find_node(*edit.graph, state.focus.node)) state.focus = {};
}

bool copy_selected(CanvasState& state, const CanvasFrame& frame) {
    BrainFragment piece = copy_fragment(placed(frame.graph, frame.layout), state.selection.nodes);
    if (piece.empty()) {
        refuse(state, frame, "wiring.refused.nothing_to_copy");
        return false;
    }
    state.clipboard = std::move(piece);
    return true;
}

// Where the mouse points; in the middle of the canvas when it points elsewhere.
void paste_copied(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    const Pointer& pointer = frame.pointer;
    const vec2 place = pointer.valid && pointer.over ? view_of(state, frame).to_canvas(pointer.at) : state.middle;
    paste_at(state, frame, state.clipboard, place, outbox);
}

void duplicate(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    const BrainFragment piece = copy_fragment(placed(frame.graph, frame.layout), state.selection.nodes);
    if (piece.empty()) return refuse(state, frame, "wiring.refused.nothing_to_copy");
    vec2 middle;
    for (const Node& node : piece.neurons) middle += find_shape(frame.layout, node.id)->centre;
    const vec2 beside{36, 104};  // clear of the card it is like
    paste_at(state, frame, piece, middle / static_cast<float>(piece.neurons.size()) + beside, outbox);
}

// A neuron where the menu was opened; at the end of the wire that was dropped there, if one was.
void add_chosen(CanvasState& state, const CanvasFrame& frame, const CanvasMenu& menu, std::size_t kind,
                Outbox& outbox) {
    Edit edit = add_neuron(frame.graph, make_neuron(neuron_kinds[kind]));
    const NodeId fresh = fresh_id(frame.graph);
    const bool outwards = menu.loose.part == Part::out_pin, loose = menu.loose.part != Part::nothing;
    if (edit && loose)
        edit = connect(*edit.graph, outwards ? WireEnds{menu.loose.node, fresh} : WireEnds{fresh, menu.loose.node});
    if (!edit) return refuse(state, frame, edit.refusal);
    // The end of the wire stays where it was dropped: the new neuron's pin comes to lie there.
    const float aside = !loose ? 0.0f : outwards ? 75.0f : -75.0f;
    ask_with_new(state, frame, std::move(*edit.graph), fresh, menu.place + vec2{aside, 0}, outbox);
}

void insert_new(CanvasState& state, const CanvasFrame& frame, WireEnds wire, Outbox& outbox) {
    Edit edit = add_neuron(frame.graph, {});
    const NodeId fresh = fresh_id(frame.graph);
    if (edit) edit = insert_neuron(*edit.graph, fresh, wire);
    if (!edit) return refuse(state, frame, edit.refusal);
    const WireShape* shape = find_shape(frame.layout, wire);
    if (shape == nullptr) return;
    ask_with_new(state, frame, std::move(*edit.graph), fresh, bezier_point(shape->bezier, 0.5f), outbox);
}

}  // namespace braitenlab
