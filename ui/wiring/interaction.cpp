#include "ui/wiring/interaction.h"

#include <algorithm>
#include <cmath>

namespace braitenlab {
namespace {

using maths::vec2;

constexpr float drag_begins = 4;      // layout pixels
constexpr float pixels_per_step = 8;  // of weight
constexpr float coarse = 0.1f, fine = 0.01f;
constexpr double refusal_seconds = 2.5;

void refuse(CanvasState& state, const CanvasFrame& frame, std::string_view key) {
    state.refusal = {std::string(key), frame.pointer.at, frame.wall_seconds + refusal_seconds};
}

void ask(Outbox& outbox, Command command, std::uint64_t gesture) {
    outbox.push_back(EditRequest{std::move(command), gesture});
}

// The slider's number where the wire has one, so that both are the same command.
void ask_weight(const CanvasFrame& frame, const BrainGraph& graph, WireEnds ends, float weight, std::uint64_t gesture,
                Outbox& outbox) {
    if (const auto dial = direct_dial(graph, ends))
        ask(outbox, TurnDial{frame.target, *dial, weight}, gesture);
    else if (const Edit edit = set_weight(graph, ends, weight))
        ask(outbox, SetBrain{frame.target, *edit.graph}, gesture);
}

float tidy(float weight) { return std::clamp(std::round(weight * 100) / 100, -limits::weight, limits::weight); }

// Writes down where everything stands, so that a node more or less moves nothing else.
void keep_places(CanvasState& state, const Layout& layout) {
    for (const NodeShape& node : layout.nodes) state.places[state.kind].try_emplace(node.id, node.centre);
}

void select(CanvasState& state, const Hit& hit, bool add) {
    if (!add) state.selection = {};
    const auto toggle = [add](auto& set, const auto& item) {
        if (!set.insert(item).second && add) set.erase(item);
    };
    if (hit.part == Part::label || hit.part == Part::wire)
        toggle(state.selection.wires, hit.wire);
    else if (hit.part != Part::nothing)
        toggle(state.selection.nodes, hit.node);
}

void erase_selected(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    if (state.selection.nodes.empty() && state.selection.wires.empty()) return;
    const Edit edit = remove(frame.graph, state.selection.nodes, state.selection.wires);
    if (!edit) return refuse(state, frame, edit.refused);
    keep_places(state, frame.layout);
    state.nodes = edit.graph->nodes.size();
    ask(outbox, SetBrain{frame.target, *edit.graph}, state.next_gesture++);
    state.selection = {};
}

// Esc: everything as it was at the press. Edits are asked for at the release, but for a weight, which moves live.
void cancel(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    CanvasDrag& drag = state.drag;
    if (drag.phase == CanvasPhase::drag_weight && drag.sent != drag.weight)
        ask_weight(frame, drag.graph, drag.pressed.wire, drag.weight, drag.gesture, outbox);
    if (drag.phase == CanvasPhase::move_nodes) state.places[state.kind] = drag.places;
    if (drag.phase != CanvasPhase::idle) state.selection = drag.selection;
    drag = {};
}

void obey_keys(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    for (const CanvasKey key : state.keys) {
        const bool idle = state.drag.phase == CanvasPhase::idle;
        if (key == CanvasKey::cancel && !idle) cancel(state, frame, outbox);
        if (key == CanvasKey::cancel && idle) state.selection = {}, state.refusal = {};
        if (key == CanvasKey::erase && idle) erase_selected(state, frame, outbox);
        if (key == CanvasKey::fit && idle) fit(state, frame.layout, frame.area, frame.ui_scale);
    }
    state.keys.clear();
}

void turn_wheel(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    const Pointer& pointer = frame.pointer;
    const bool over_label = state.hovered.part == Part::label;
    if (!over_label || state.hovered.wire != state.wheel_wire) state.wheel_gesture = 0;
    if (pointer.wheel == 0) return;
    if (!over_label) return zoom_at(state, frame.area, frame.ui_scale, pointer.at, std::pow(1.15f, pointer.wheel));
    state.wheel_wire = state.hovered.wire;
    if (state.wheel_gesture == 0) state.wheel_gesture = state.next_gesture++;
    const float now = weight_of(frame.graph, state.wheel_wire);
    const float then = tidy(now + pointer.wheel * (pointer.shift ? fine : coarse));
    if (then != now) ask_weight(frame, frame.graph, state.wheel_wire, then, state.wheel_gesture, outbox);
}

void press(CanvasState& state, const CanvasFrame& frame) {
    const Pointer& pointer = frame.pointer;
    if (!pointer.over || (!pointer.left_pressed && !pointer.pan_pressed)) return;
    CanvasDrag& drag = state.drag;
    drag = {};
    drag.phase = CanvasPhase::pending;
    drag.panning_button = !pointer.left_pressed;
    drag.pressed = state.hovered;
    drag.press = drag.last = pointer.at;
    drag.graph = frame.graph;
    drag.places = state.places[state.kind];
    drag.selection = state.selection;
    drag.gesture = state.next_gesture++;
    state.refusal = {};
    state.wheel_gesture = 0;
}

CanvasPhase phase_for(const CanvasDrag& drag) {
    if (drag.panning_button) return CanvasPhase::pan;
    switch (drag.pressed.part) {
        case Part::in_pin:
        case Part::out_pin:
            return CanvasPhase::drag_wire;
        case Part::node:
            return CanvasPhase::move_nodes;
        case Part::label:
            return CanvasPhase::drag_weight;
        default:
            return CanvasPhase::box;
    }
}

void begin_drag(CanvasState& state, const CanvasFrame& frame) {
    CanvasDrag& drag = state.drag;
    drag.phase = phase_for(drag);
    if (drag.phase == CanvasPhase::move_nodes && state.selection.nodes.count(drag.pressed.node) == 0)
        select(state, drag.pressed, frame.pointer.shift);
    if (drag.phase == CanvasPhase::drag_weight) {
        drag.weight = drag.sent = weight_of(drag.graph, drag.pressed.wire);
        select(state, drag.pressed, false);
    }
}

void drag_weight(CanvasState& state, const CanvasFrame& frame, vec2 moved, Outbox& outbox) {
    CanvasDrag& drag = state.drag;
    const float step = frame.pointer.shift ? fine : coarse;
    drag.travel += (moved.x - moved.y) / (pixels_per_step * frame.ui_scale) * step;
    // Travel beyond the range is not kept, so that the way back begins at once.
    drag.travel = std::clamp(drag.travel, -limits::weight - drag.weight, limits::weight - drag.weight);
    const float weight = tidy(drag.weight + std::round(drag.travel / step) * step);
    if (weight == drag.sent) return;
    drag.sent = weight;
    ask_weight(frame, drag.graph, drag.pressed.wire, weight, drag.gesture, outbox);
}

void select_box(CanvasState& state, const CanvasFrame& frame) {
    const Caught caught =
        inside(frame.layout, view_of(state, frame.area, frame.ui_scale), state.drag.press, frame.pointer.at);
    state.selection = frame.pointer.shift ? state.drag.selection : Caught{};
    state.selection.nodes.insert(caught.nodes.begin(), caught.nodes.end());
    state.selection.wires.insert(caught.wires.begin(), caught.wires.end());
}

void move_along(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    CanvasDrag& drag = state.drag;
    const vec2 moved = frame.pointer.at - drag.last;
    drag.last = frame.pointer.at;
    const float scale = view_of(state, frame.area, frame.ui_scale).scale;
    if (drag.phase == CanvasPhase::pan) {
        state.middle -= moved / scale;
        state.own_view = true;
    } else if (drag.phase == CanvasPhase::box) {
        select_box(state, frame);
    } else if (drag.phase == CanvasPhase::move_nodes) {
        for (const NodeId id : state.selection.nodes)
            if (const NodeShape* node = find_shape(frame.layout, id))
                state.places[state.kind].try_emplace(id, node->centre).first->second += moved / scale;
    } else if (drag.phase == CanvasPhase::drag_weight) {
        drag_weight(state, frame, moved, outbox);
    }
}

void drop_new_neuron(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    const CanvasDrag& drag = state.drag;
    const NodeId fresh = fresh_id(drag.graph);
    const bool outwards = drag.pressed.part == Part::out_pin;
    const WireEnds ends = outwards ? WireEnds{drag.pressed.node, fresh} : WireEnds{fresh, drag.pressed.node};
    const Edit added = add_neuron(drag.graph);
    const Edit joined = added ? connect(*added.graph, ends) : added;
    if (!joined) return refuse(state, frame, joined.refused);
    keep_places(state, frame.layout);
    // The end of the wire stays under the cursor: the new neuron's pin comes to lie there.
    const vec2 pin = view_of(state, frame.area, frame.ui_scale).to_canvas(frame.pointer.at);
    state.places[state.kind][fresh] = pin + vec2{outwards ? 75.0f : -75.0f, 0};
    state.nodes = joined.graph->nodes.size();
    state.selection = {{fresh}, {}};
    ask(outbox, SetBrain{frame.target, *joined.graph}, drag.gesture);
}

void drop_wire(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    const WireDrop drop = drop_of(state, frame);
    if (drop.what == WireDrop::What::refused) return refuse(state, frame, drop.reason);
    if (drop.what == WireDrop::What::new_neuron) return drop_new_neuron(state, frame, outbox);
    if (drop.what != WireDrop::What::connect) return;
    const BrainGraph& graph = state.drag.graph;
    if (direct_dial(graph, drop.ends))
        ask_weight(frame, graph, drop.ends, 1, state.drag.gesture, outbox);
    else if (const Edit edit = connect(graph, drop.ends))
        ask(outbox, SetBrain{frame.target, *edit.graph}, state.drag.gesture);
    state.selection = {{}, {drop.ends}};
}

void release(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    if (state.drag.phase == CanvasPhase::pending && !state.drag.panning_button)
        select(state, state.drag.pressed, frame.pointer.shift);
    if (state.drag.phase == CanvasPhase::drag_wire) drop_wire(state, frame, outbox);
    state.drag = {};
}

}  // namespace

View view_of(const CanvasState& state, Rect area, float ui_scale) {
    const float scale = state.zoom * ui_scale;
    return {vec2{area.x + area.w / 2, area.y + area.h / 2} - state.middle * scale, scale};
}

void zoom_at(CanvasState& state, Rect area, float ui_scale, vec2 pixel, float factor) {
    const vec2 fixed = view_of(state, area, ui_scale).to_canvas(pixel);
    state.zoom = std::clamp(state.zoom * factor, least_zoom, most_zoom);
    state.middle += fixed - view_of(state, area, ui_scale).to_canvas(pixel);
    state.own_view = true;
}

void fit(CanvasState& state, const Layout& layout, Rect area, float ui_scale) {
    const float side = 28 * ui_scale, top = 56 * ui_scale, bottom = 24 * ui_scale;  // above stand the buttons
    const vec2 size = layout.high - layout.low;
    const vec2 room{std::max(area.w - 2 * side, 1.0f), std::max(area.h - top - bottom, 1.0f)};
    state.zoom = std::clamp(std::min(room.x / size.x, room.y / size.y) / ui_scale, least_zoom, 1.4f);
    state.middle = (layout.low + layout.high) / 2;
    const float scale = view_of(state, area, ui_scale).scale, above = (area.h - size.y * scale) / 2;
    if (above < top) state.middle.y -= (top - above) / scale;
    state.own_view = false;
}

WireDrop drop_of(const CanvasState& state, const CanvasFrame& frame) {
    const CanvasDrag& drag = state.drag;
    const Pointer& pointer = frame.pointer;
    if (!pointer.over) return {};
    const Hit under = hit(frame.layout, view_of(state, frame.area, frame.ui_scale), pointer.at, frame.ui_scale);
    const bool outwards = drag.pressed.part == Part::out_pin;
    const bool on_pin = under.part == Part::in_pin || under.part == Part::out_pin;
    if (!on_pin && under.part != Part::node) return {WireDrop::What::new_neuron, {}, {}};
    // A card stands for its pin; back on its own card a wire is put away.
    if (under.node == drag.pressed.node && (!on_pin || under.part == drag.pressed.part)) return {};
    // A sensor has no in-pin: its out-pin then means the sensor itself, and the edit says why not.
    const NodeShape* shape = find_shape(frame.layout, under.node);
    const bool lacks_pin = !outwards && !shape->has_out;  // a motor where there is no neuron to feed
    if (lacks_pin || (on_pin && under.part == drag.pressed.part && shape->has_in))
        return {WireDrop::What::refused, {}, outwards ? "wiring.refused.two_outputs" : "wiring.refused.two_inputs"};
    const WireEnds ends = outwards ? WireEnds{drag.pressed.node, under.node} : WireEnds{under.node, drag.pressed.node};
    const Edit edit = connect(drag.graph, ends);
    if (!edit) return {WireDrop::What::refused, ends, edit.refused};
    return {WireDrop::What::connect, ends, {}};
}

void interact(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    obey_keys(state, frame, outbox);
    CanvasDrag& drag = state.drag;
    if (!frame.pointer.valid) cancel(state, frame, outbox);
    state.hovered = {};
    const bool sweeps = drag.phase == CanvasPhase::box || drag.phase == CanvasPhase::pan;  // over things, not at them
    if (frame.pointer.over && frame.pointer.valid && !sweeps)
        state.hovered = hit(frame.layout, view_of(state, frame.area, frame.ui_scale), frame.pointer.at, frame.ui_scale);
    if (drag.phase == CanvasPhase::idle) {
        turn_wheel(state, frame, outbox);
        press(state, frame);
        return;
    }
    const bool down = drag.panning_button ? frame.pointer.pan_down : frame.pointer.left_down;
    if (drag.phase == CanvasPhase::pending &&
        maths::distance(frame.pointer.at, drag.press) >= drag_begins * frame.ui_scale)
        begin_drag(state, frame);
    if (drag.phase != CanvasPhase::pending) move_along(state, frame, outbox);
    if (!down) release(state, frame, outbox);
}

}  // namespace braitenlab
