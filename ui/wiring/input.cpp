#include "ui/wiring/input.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/wiring/edits.h"
#include "ui/wiring/menu.h"

namespace braitenlab::wiring {

using namespace ui;

using maths::vec2;

namespace {

constexpr float drag_begins = 4;      // layout pixels
constexpr float pixels_per_step = 8;  // of weight
constexpr float coarse = 0.1f, fine = 0.01f;

float rounded(float weight) { return std::clamp(std::round(weight * 100) / 100, -limits::weight, limits::weight); }

float zoom_of(float wheel) { return std::pow(1.15f, wheel); }

void use_wheel(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    const Pointer& pointer = frame.pointer;
    const bool over_label = state.hovered.part == Part::label;
    if (!over_label || state.hovered.wire != state.wheel.wire) state.wheel.gesture = 0;
    if (pointer.wheel == 0) return;
    if (!over_label) return zoom_at(state.camera, frame.area, frame.ui_scale, pointer.at, zoom_of(pointer.wheel));
    state.wheel.wire = state.hovered.wire;
    if (state.wheel.gesture == 0) state.wheel.gesture = state.next_gesture++;
    const float now = weight_of(frame.graph, state.wheel.wire);
    const float then = rounded(now + pointer.wheel * (pointer.shift ? fine : coarse));
    if (then != now) send_weight(frame, frame.graph, state.wheel.wire, then, state.wheel.gesture, outbox);
}

std::optional<Minimap> minimap_now(const CanvasState& state, const CanvasFrame& frame) {
    return minimap_of(frame.layout, view_of(state, frame), frame.area, frame.ui_scale);
}

bool on_minimap(const CanvasState& state, const CanvasFrame& frame) {
    const auto map = minimap_now(state, frame);
    return map && map->rect.contains(frame.pointer.at);
}

void press(CanvasState& state, const CanvasFrame& frame) {
    const Pointer& pointer = frame.pointer;
    if (!pointer.over || (!pointer.left_pressed && !pointer.right_pressed && !pointer.middle_pressed)) return;
    Drag& drag = state.drag;
    drag = {};
    drag.phase = pointer.left_pressed && on_minimap(state, frame) ? DragPhase::map : DragPhase::pending;
    drag.left = pointer.left_pressed;
    drag.right = !pointer.left_pressed && pointer.right_pressed;
    drag.pressed = state.hovered;
    drag.press = drag.last = pointer.at;
    drag.graph = frame.graph;
    drag.selection = state.selection;
    drag.gesture = state.next_gesture++;
    state.refusal = {};
    state.joining.reset();
    state.wheel.gesture = 0;
}

// A new wire from a pin, or the end of a wire that is nearer to the press.
void begin_wire(Drag& drag, const CanvasFrame& frame, const View& view) {
    drag.fixed = drag.pressed.node;
    drag.outwards = drag.pressed.part == Part::out_pin;
    if (drag.pressed.part != Part::wire) return;
    const WireShape* shape = find_shape(frame.layout, drag.pressed.wire);
    const vec2 at = view.to_canvas(drag.press);
    drag.outwards = maths::distance(at, shape->bezier[3]) < maths::distance(at, shape->bezier[0]);
    drag.fixed = drag.outwards ? shape->ends.from : shape->ends.to;
    drag.taken = shape->ends;
}

DragPhase phase_for(const Drag& drag, const CanvasFrame& frame) {
    if (!drag.left) return DragPhase::pan;
    const WireShape* wire = drag.pressed.part == Part::wire ? find_shape(frame.layout, drag.pressed.wire) : nullptr;
    switch (drag.pressed.part) {
        case Part::in_pin:
        case Part::out_pin:
            return DragPhase::drag_wire;
        case Part::node:
            return DragPhase::move_nodes;
        case Part::label:
            return DragPhase::drag_weight;
        case Part::wire:
            return wire != nullptr && !wire->ghost ? DragPhase::drag_wire : DragPhase::box;
        default:
            return DragPhase::box;
    }
}

void hold_selected(CanvasState& state, const Layout& layout) {
    for (const NodeId id : state.selection.nodes)
        if (const NodeShape* node = find_shape(layout, id)) state.held[id] = node->centre;
    state.drag.positions = state.held;
}

void move_held(CanvasState& state, vec2 by) {
    for (auto& [id, position] : state.held) position = rounded_position(state.drag.positions.at(id) + by);
}

void begin_drag(CanvasState& state, const CanvasFrame& frame) {
    Drag& drag = state.drag;
    drag.phase = phase_for(drag, frame);
    if (drag.phase == DragPhase::drag_wire) begin_wire(drag, frame, view_of(state, frame));
    if (drag.phase == DragPhase::move_nodes && state.selection.nodes.count(drag.pressed.node) == 0)
        select(state, drag.pressed, frame.pointer.shift);
    if (drag.phase == DragPhase::move_nodes) hold_selected(state, frame.layout);
    if (drag.phase == DragPhase::drag_weight) {
        drag.weight = drag.sent = weight_of(drag.graph, drag.pressed.wire);
        select(state, drag.pressed, false);
    }
}

void drag_weight(CanvasState& state, const CanvasFrame& frame, vec2 moved, Outbox& outbox) {
    Drag& drag = state.drag;
    const float step = frame.pointer.shift ? fine : coarse;
    drag.travel += (moved.x - moved.y) / (pixels_per_step * frame.ui_scale) * step;
    // Travel beyond the range is dropped: the weight changes at once when the pointer turns back.
    drag.travel = std::clamp(drag.travel, -limits::weight - drag.weight, limits::weight - drag.weight);
    const float weight = rounded(drag.weight + std::round(drag.travel / step) * step);
    if (weight == drag.sent) return;
    drag.sent = weight;
    send_weight(frame, drag.graph, drag.pressed.wire, weight, drag.gesture, outbox);
}

void select_box(CanvasState& state, const CanvasFrame& frame) {
    const CanvasSelection boxed = in_box(frame.layout, view_of(state, frame), state.drag.press, frame.pointer.at);
    state.selection = frame.pointer.shift ? state.drag.selection : CanvasSelection{};
    state.selection.nodes.insert(boxed.nodes.begin(), boxed.nodes.end());
    state.selection.wires.insert(boxed.wires.begin(), boxed.wires.end());
}

void move_along(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    Drag& drag = state.drag;
    const vec2 moved = frame.pointer.at - drag.last;
    drag.last = frame.pointer.at;
    const float scale = view_of(state, frame).scale;
    if (drag.phase == DragPhase::pan) {
        state.camera.middle -= moved / scale;
        state.camera.by_user = true;
    } else if (drag.phase == DragPhase::map) {
        const auto map = minimap_now(state, frame);
        if (map) state.camera.middle = map->view.to_canvas(frame.pointer.at), state.camera.by_user = true;
    } else if (drag.phase == DragPhase::box) {
        select_box(state, frame);
    } else if (drag.phase == DragPhase::move_nodes) {
        move_held(state, (frame.pointer.at - drag.press) / scale);
    } else if (drag.phase == DragPhase::drag_weight) {
        drag_weight(state, frame, moved, outbox);
    }
}

// Selects; the right button also opens the menu of the selection.
void click(CanvasState& state, const CanvasFrame& frame) {
    const Drag& drag = state.drag;
    if (drag.left) return select(state, drag.pressed, frame.pointer.shift);
    if (!drag.right) return;
    if (!state.selection.contains(drag.pressed)) select(state, drag.pressed, false);
    open_menu(state, frame, frame.pointer.at);
}

void release(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    if (state.drag.phase == DragPhase::pending) click(state, frame);
    if (state.drag.phase == DragPhase::drag_wire) drop_wire(state, frame, outbox);
    if (state.drag.phase == DragPhase::move_nodes) drop_nodes(state, frame, outbox);
    state.drag = {};
}

// True while a menu is open: a press on a row chooses it, a press elsewhere closes the menu.
bool menu_takes(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    if (!state.menu.open()) return false;
    const Pointer& pointer = frame.pointer;
    const int row = pointer.over ? row_at(state.menu, pointer.at) : -1;
    if (pointer.at != state.last_pointer) state.menu.current = row;
    if (pointer.left_pressed || pointer.right_pressed) choose(state, frame, row, outbox);
    return true;
}

bool is_down(const Drag& drag, const Pointer& pointer) {
    return drag.left ? pointer.left_down : drag.right ? pointer.right_down : pointer.middle_down;
}

}  // namespace

void handle_input(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    for (const Action action : std::exchange(state.actions, {})) execute(state, frame, action, outbox);
    if (const auto row = std::exchange(state.chosen_row, {})) execute(state, frame, *row, {}, outbox);
    Drag& drag = state.drag;
    if (!frame.pointer.valid) cancel_drag(state, frame, outbox);
    state.hovered = {};
    const bool menu = menu_takes(state, frame, outbox);
    state.last_pointer = frame.pointer.at;
    if (menu) return;
    // While a box is drawn or the camera moves, no part is hovered.
    const bool sweeps = drag.phase == DragPhase::box || drag.phase == DragPhase::pan || drag.phase == DragPhase::map;
    if (frame.pointer.over && frame.pointer.valid && !sweeps && !on_minimap(state, frame))
        state.hovered = hit(state, frame);
    if (drag.phase == DragPhase::idle) {
        use_wheel(state, frame, outbox);
        press(state, frame);
        return;
    }
    // Two fingers move and zoom at once: they hold the middle button.
    if (!drag.left && !drag.right && frame.pointer.wheel != 0)
        zoom_at(state.camera, frame.area, frame.ui_scale, frame.pointer.at, zoom_of(frame.pointer.wheel));
    if (drag.phase == DragPhase::pending &&
        maths::distance(frame.pointer.at, drag.press) >= drag_begins * frame.ui_scale)
        begin_drag(state, frame);
    if (drag.phase != DragPhase::pending) move_along(state, frame, outbox);
    if (!is_down(drag, frame.pointer)) release(state, frame, outbox);
}

bool press_key(CanvasState& state, Action action) {
    const bool ends_a_part =
        state.drag.phase != DragPhase::idle || !state.selection.empty() || state.menu.open() || state.joining;
    // Others also with nothing selected: Del must not remove the vehicle.
    const bool wanted = action == Action::cancel ? ends_a_part : is_of_canvas(action);
    if (wanted) state.actions.push_back(action);
    return wanted;
}

}  // namespace braitenlab::wiring
