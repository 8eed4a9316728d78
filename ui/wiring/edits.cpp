#include "ui/wiring/edits.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/brain/four_neurons.h"
#include "ui/wiring/input.h"

namespace braitenlab::wiring {

using namespace ui;

using maths::vec2;

namespace {

constexpr double refusal_seconds = 2.5;  // duration of a note

// Size of a box around a neuron's card with a margin, in which no pin of another card is covered.
vec2 room_of_neuron() {
    constexpr float clear = 10;
    return card_size(NodeKind::neuron) + vec2{2 * clear, 2 * clear};
}

// The same around the fragment's cards.
vec2 room_of(const BrainFragment& fragment) {
    vec2 reach;
    for (const Node& neuron : fragment.neurons)
        reach = {std::max(reach.x, std::abs(neuron.place->x)), std::max(reach.y, std::abs(neuron.place->y))};
    return reach * 2 + room_of_neuron();
}

// The centre nearest to `at` with the whole room of a neuron in sight.
vec2 kept_in_sight(const CanvasState& state, const CanvasFrame& frame, vec2 at) {
    const View view = view_of(state, frame);
    const Rect& area = frame.area;
    const vec2 rim = room_of_neuron() / 2, low = view.to_canvas({area.x, area.y}) + rim,
               high = view.to_canvas({area.x + area.w, area.y + area.h}) - rim;
    return {std::clamp(at.x, low.x, std::max(low.x, high.x)), std::clamp(at.y, low.y, std::max(low.y, high.y))};
}

// Pastes the fragment at the free position nearest to `wanted`.
void paste_at(CanvasState& state, const CanvasFrame& frame, const BrainFragment& fragment, vec2 wanted,
              Outbox& outbox) {
    const vec2 middle = free_position(frame.layout, wanted, room_of(fragment));
    const Pasted pasted = paste_fragment(frame.graph, fragment, middle);
    if (!pasted.edit) return show_refusal(state, frame, pasted.edit.refusal);
    state.selection = {pasted.added, {}};
    if (!frame.area.contains(view_of(state, frame).to_window(middle)))
        reveal(state.camera, frame.area, frame.ui_scale, middle);
    send_edit(state, frame, pasted.edit, state.next_gesture++, outbox);
}

// Sends a brain with the added neuron at this position, and selects the neuron.
void send_with_added(CanvasState& state, const CanvasFrame& frame, BrainGraph edited, NodeId fresh, vec2 position,
                     Outbox& outbox) {
    const auto made =
        std::find_if(edited.nodes.begin(), edited.nodes.end(), [&](const Node& node) { return node.id == fresh; });
    made->place = rounded_position(position);
    send_edit(state, frame, std::move(edited), state.next_gesture++, outbox);
    state.selection = {{fresh}, {}};
    state.focus = {Part::node, fresh, {}};
}

}  // namespace

std::string refusal_key(Refusal refusal) { return "wiring.refused." + std::string(name(refusal)); }

void show_refusal(CanvasState& state, const CanvasFrame& frame, const std::string& key) {
    const Rect& area = frame.area;
    const bool inside = frame.pointer.valid && area.contains(frame.pointer.at);
    const vec2 at = inside ? frame.pointer.at : vec2{area.x + area.w / 3, area.y + area.h / 2};
    state.refusal = {key, at, frame.wall_seconds + refusal_seconds};
}

void show_refusal(CanvasState& state, const CanvasFrame& frame, Refusal refusal) {
    show_refusal(state, frame, refusal_key(refusal));
}

bool send_edit(CanvasState& state, const CanvasFrame& frame, const Edit& edit, std::uint64_t gesture, Outbox& outbox) {
    if (edit)
        outbox.push_back(EditRequest{SetBrain{frame.target, keep_positions(*edit.graph, frame.layout)}, gesture});
    else
        show_refusal(state, frame, edit.refusal);
    return static_cast<bool>(edit);
}

void send_weight(const CanvasFrame& frame, const BrainGraph& graph, WireEnds ends, float weight, std::uint64_t gesture,
                 Outbox& outbox) {
    if (const auto dial = direct_dial(graph, ends))
        outbox.push_back(EditRequest{TurnDial{frame.target, *dial, weight}, gesture});
    else if (const Edit edit = set_weight(graph, ends, weight))
        outbox.push_back(EditRequest{SetBrain{frame.target, keep_positions(*edit.graph, frame.layout)}, gesture});
}

void send_positions(const CanvasFrame& frame, const Positions& moved, std::uint64_t gesture, Outbox& outbox) {
    if (moved.empty()) return;
    PlaceNodes all{frame.target, {}};
    for (const NodeShape& shape : frame.layout.nodes) {
        const auto to = moved.find(shape.id);
        all.places.push_back({shape.id, to == moved.end() ? shape.centre : to->second});
    }
    outbox.push_back(EditRequest{std::move(all), gesture});
}

void select(CanvasState& state, const Hit& hit, bool add) {
    if (!add) state.selection = {};
    const auto toggle = [add](auto& set, const auto& item) {
        if (!set.insert(item).second && add) set.erase(item);
    };
    if (hit.is_wire())
        toggle(state.selection.wires, hit.wire);
    else if (hit.part != Part::nothing)
        toggle(state.selection.nodes, hit.node);
    state.focus = hit.part == Part::nothing ? Hit{}
                  : hit.is_wire()           ? Hit{Part::label, 0, hit.wire}
                                            : Hit{Part::node, hit.node, {}};
}

void erase_selected(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    if (state.selection.empty()) return;
    const Edit edit = remove(frame.graph, state.selection.nodes, state.selection.wires);
    if (!edit) return show_refusal(state, frame, edit.refusal);
    send_edit(state, frame, edit, state.next_gesture++, outbox);
    state.selection = {};
    if (!find_node(*edit.graph, state.focus.node)) state.focus = {};
}

bool copy_selected(CanvasState& state, const CanvasFrame& frame) {
    BrainFragment fragment = copy_fragment(with_positions(frame.graph, frame.layout), state.selection.nodes);
    if (fragment.empty()) {
        show_refusal(state, frame, "wiring.refused.nothing_to_copy");
        return false;
    }
    state.clipboard = std::move(fragment);
    return true;
}

void paste_copied(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    const Pointer& pointer = frame.pointer;
    const vec2 position =
        pointer.valid && pointer.over ? view_of(state, frame).to_canvas(pointer.at) : state.camera.middle;
    paste_at(state, frame, state.clipboard, position, outbox);
}

void duplicate_selected(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    const BrainFragment fragment = copy_fragment(with_positions(frame.graph, frame.layout), state.selection.nodes);
    if (fragment.empty()) return show_refusal(state, frame, "wiring.refused.nothing_to_copy");
    vec2 middle;
    for (const Node& node : fragment.neurons) middle += find_shape(frame.layout, node.id)->centre;
    const vec2 beside{36, 104};  // clear of the original card
    paste_at(state, frame, fragment, middle / static_cast<float>(fragment.neurons.size()) + beside, outbox);
}

void add_chosen(CanvasState& state, const CanvasFrame& frame, const CanvasMenu& menu, std::size_t kind,
                Outbox& outbox) {
    Edit edit = add_neuron(frame.graph, make_neuron(neuron_kinds[kind]));
    const NodeId fresh = fresh_id(frame.graph);
    const bool outwards = menu.loose.part == Part::out_pin, loose = menu.loose.part != Part::nothing;
    if (edit && loose)
        edit = connect(*edit.graph, outwards ? WireEnds{menu.loose.node, fresh} : WireEnds{fresh, menu.loose.node});
    if (!edit) return show_refusal(state, frame, edit.refusal);
    // The new neuron's pin is where the wire was dropped, if that place is free.
    const float half = card_size(NodeKind::neuron).x / 2, aside = !loose ? 0.0f : outwards ? half : -half;
    const vec2 wanted = kept_in_sight(state, frame, menu.canvas_at + vec2{aside, 0});
    const vec2 place = free_position(frame.layout, wanted, room_of_neuron());
    send_with_added(state, frame, std::move(*edit.graph), fresh, place, outbox);
}

void insert_new(CanvasState& state, const CanvasFrame& frame, WireEnds wire, Outbox& outbox) {
    Edit edit = add_neuron(frame.graph, {});
    const NodeId fresh = fresh_id(frame.graph);
    if (edit) edit = insert_neuron(*edit.graph, fresh, wire);
    if (!edit) return show_refusal(state, frame, edit.refusal);
    const WireShape* shape = find_shape(frame.layout, wire);
    if (shape == nullptr) return;
    send_with_added(state, frame, std::move(*edit.graph), fresh, bezier_point(shape->bezier, 0.5f), outbox);
}

WireDrop drop_of(const CanvasState& state, const CanvasFrame& frame) {
    const Drag& drag = state.drag;
    const Pointer& pointer = frame.pointer;
    if (!pointer.over) return {};
    const Hit under = hit(state, frame);
    const bool on_pin = under.is_pin();
    if (!on_pin && under.part != Part::node) {
        if (drag.taken && under.wire == *drag.taken && under.part != Part::nothing)
            return {};  // released on the same wire
        return {drag.taken ? WireDrop::What::take_off : WireDrop::What::new_neuron, {}, {}};
    }
    const Part own = drag.outwards ? Part::out_pin : Part::in_pin;
    // A card is treated as its pin. A release on the card at the fixed end cancels.
    if (under.node == drag.fixed && (!on_pin || under.part == own)) return {};
    // A sensor has no in-pin: its out-pin is then treated as the sensor, and connect() gives the reason.
    const NodeShape* shape = find_shape(frame.layout, under.node);
    const bool has_no_pin = !drag.outwards && !shape->has_out;  // a motor in a brain without neurons
    if (has_no_pin || (on_pin && under.part == own && shape->has_in))
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
    if (state.drag.phase != DragPhase::move_nodes || moved.size() != 1) return {};
    const NodeShape* shape = find_shape(frame.layout, *moved.begin());
    if (shape == nullptr || shape->kind != NodeKind::neuron || is_wired(state.drag.graph, shape->id)) return {};
    return wire_through(frame.layout, shape->centre, shape->size.y / 2);
}

void drop_wire(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    const Drag& drag = state.drag;
    const WireDrop drop = drop_of(state, frame);
    switch (drop.what) {
        case WireDrop::What::nothing:
            return;
        case WireDrop::What::refused:
            return show_refusal(state, frame, drop.reason);
        case WireDrop::What::new_neuron:
            return open_drop_menu(state, frame, drag.pressed);
        case WireDrop::What::take_off:
            send_edit(state, frame, remove(drag.graph, {}, {*drag.taken}), drag.gesture, outbox);
            state.selection = {};
            return;
        case WireDrop::What::connect:
            break;
    }
    if (drag.taken)
        send_edit(state, frame, reconnect(drag.graph, *drag.taken, drop.ends), drag.gesture, outbox);
    else if (direct_dial(drag.graph, drop.ends))
        send_weight(frame, drag.graph, drop.ends, 1, drag.gesture, outbox);
    else
        send_edit(state, frame, connect(drag.graph, drop.ends), drag.gesture, outbox);
    select(state, {Part::label, 0, drop.ends}, false);
}

void drop_nodes(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    const Drag& drag = state.drag;
    const auto into = insertion_of(state, frame);
    if (!into && state.held == drag.positions) return;  // back at their old positions
    if (!into) return send_positions(frame, state.held, drag.gesture, outbox);
    send_edit(state, frame, insert_neuron(drag.graph, *state.selection.nodes.begin(), *into), drag.gesture, outbox);
}

}  // namespace braitenlab::wiring
