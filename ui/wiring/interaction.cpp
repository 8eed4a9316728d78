#include "ui/wiring/interaction.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/wiring/actions.h"
#include "ui/wiring/drop.h"
#include "ui/wiring/minimap.h"

namespace braitenlab {
namespace {

using maths::vec2;

constexpr float drag_begins = 4;      // layout pixels
constexpr float pixels_per_step = 8;  // of weight
constexpr float coarse = 0.1f, fine = 0.01f;

float rounded(float weight) { return std::clamp(std::round(weight * 100) / 100, -limits::weight, limits::weight); }

void turn_wheel(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    const Pointer& pointer = frame.pointer;
    const bool over_label = state.hovered.part == Part::label;
    if (!over_label || state.hovered.wire != state.wheel_wire) state.wheel_gesture = 0;
    if (pointer.wheel == 0) return;
    if (!over_label) return zoom_at(state, frame.area, frame.ui_scale, pointer.at, std::pow(1.15f, pointer.wheel));
    state.wheel_wire = state.hovered.wire;
    if (state.wheel_gesture == 0) state.wheel_gesture = state.next_gesture++;
    const float now = weight_of(frame.graph, state.wheel_wire);
    const float then = rounded(now + pointer.wheel * (pointer.shift ? fine : coarse));
    if (then != now) ask_weight(frame, frame.graph, state.wheel_wire, then, state.wheel_gesture, outbox);
}

std::optional<Minimap> minimap_of(const CanvasState& state, const CanvasFrame& frame) {
    return minimap_of(frame.layout, view_of(state, frame), frame.area, frame.ui_scale);
}

bool on_minimap(const CanvasState& state, const CanvasFrame& frame) {
    const auto map = minimap_of(state, frame);
    return map && map->rect.contains(frame.pointer.at.x, frame.pointer.at.y);
}

void press(CanvasState& state, const CanvasFrame& frame) {
    const Pointer& pointer = frame.pointer;
    if (!pointer.over || (!pointer.left_pressed && !pointer.right_pressed && !pointer.middle_pressed)) return;
    CanvasDrag& drag = state.drag;
    drag = {};
    drag.phase = pointer.left_pressed && on_minimap(state, frame) ? CanvasPhase::map : CanvasPhase::pending;
    drag.left = pointer.left_pressed;
    drag.right = !pointer.left_pressed && pointer.right_pressed;
    drag.pressed = state.hovered;
    drag.press = drag.last = pointer.at;
    drag.graph = frame.graph;
    drag.selection = state.selection;
    drag.gesture = state.next_gesture++;
    state.refusal = {};
    state.joining.reset();
    state.wheel_gesture = 0;
}

// A new wire from a pin, or the end of a wire that was pressed nearer to it.
void begin_wire(CanvasDrag& drag, const CanvasFrame& frame, const View& view) {
    drag.fixed = drag.pressed.node;
    drag.outwards = drag.pressed.part == Part::out_pin;
    if (drag.pressed.part != Part::wire) return;
    const WireShape* shape = find_shape(frame.layout, drag.pressed.wire);
    const vec2 at = view.to_canvas(drag.press);
    drag.outwards = maths::distance(at, shape->bezier[3]) < maths::distance(at, shape->bezier[0]);
    drag.fixed = drag.outwards ? shape->ends.from : shape->ends.to;
    drag.taken = shape->ends;
}

CanvasPhase phase_for(const CanvasDrag& drag, const CanvasFrame& frame) {
    if (!drag.left) return CanvasPhase::pan;
    const WireShape* wire = drag.pressed.part == Part::wire ? find_shape(frame.layout, drag.pressed.wire) : nullptr;
    switch (drag.pressed.part) {
        case Part::in_pin:
        case Part::out_pin:
            return CanvasPhase::drag_wire;
        case Part::node:
            return CanvasPhase::move_nodes;
        case Part::label:
            return CanvasPhase::drag_weight;
        case Part::wire:
            return wire != nullptr && !wire->ghost ? CanvasPhase::drag_wire : CanvasPhase::box;
        default:
            return CanvasPhase::box;
    }
}

void take_up(CanvasState& state, const Layout& layout) {
    for (const NodeId id : state.selection.nodes)
        if (const NodeShape* node = find_shape(layout, id)) state.held[id] = node->centre;
    state.drag.places = state.held;
}

void move_held(CanvasState& state, vec2 by) {
    for (auto& [id, place] : state.held) place = rounded_position(state.drag.places.at(id) + by);
}

void begin_drag(CanvasState& state, const CanvasFrame& frame) {
    CanvasDrag& drag = state.drag;
    drag.phase = phase_for(drag, frame);
    if (drag.phase == CanvasPhase::drag_wire) begin_wire(drag, frame, view_of(state, frame));
    if (drag.phase == CanvasPhase::move_nodes && state.selection.nodes.count(drag.pressed.node) == 0)
        select(state, drag.pressed, frame.pointer.shift);
    if (drag.phase == CanvasPhase::move_nodes) take_up(state, frame.layout);
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
    const float weight = rounded(drag.weight + std::round(drag.travel / step) * step);
    if (weight == drag.sent) return;
    drag.sent = weight;
    ask_weight(frame, drag.graph, drag.pressed.wire, weight, drag.gesture, outbox);
}

void select_box(CanvasState& state, const CanvasFrame& frame) {
    const Caught caught = inside(frame.layout, view_of(state, frame), state.drag.press, frame.pointer.at);
    state.selection = frame.pointer.shift ? state.drag.selection : Caught{};
    state.selection.nodes.insert(caught.nodes.begin(), caught.nodes.end());
    state.selection.wires.insert(caught.wires.begin(), caught.wires.end());
}

void move_along(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    CanvasDrag& drag = state.drag;
    const vec2 moved = frame.pointer.at - drag.last;
    drag.last = frame.pointer.at;
    const float scale = view_of(state, frame).scale;
    if (drag.phase == CanvasPhase::pan) {
        state.middle -= moved / scale;
        state.own_view = true;
    } else if (drag.phase == CanvasPhase::map) {
        const auto map = minimap_of(state, frame);
        if (map) state.middle = map->view.to_canvas(frame.pointer.at), state.own_view = true;
    } else if (drag.phase == CanvasPhase::box) {
        select_box(state, frame);
    } else if (drag.phase == CanvasPhase::move_nodes) {
        move_held(state, (frame.pointer.at - drag.press) / scale);
    } else if (drag.phase == CanvasPhase::drag_weight) {
        drag_weight(state, frame, moved, outbox);
    }
}

// A click: selects, and with the right button opens the menu for what is selected then.
void click(CanvasState& state, const CanvasFrame& frame) {
    const CanvasDrag& drag = state.drag;
    if (drag.left) return select(state, drag.pressed, frame.pointer.shift);
    if (!drag.right) return;
    const Hit& under = drag.pressed;
    const bool wire = under.part == Part::wire || under.part == Part::label;
    const bool chosen =
        wire ? state.selection.wires.count(under.wire) > 0 : state.selection.nodes.count(under.node) > 0;
    if (under.part == Part::nothing || !chosen) select(state, under, false);
    open_menu(state, frame, frame.pointer.at);
}

void release(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    if (state.drag.phase == CanvasPhase::pending) click(state, frame);
    if (state.drag.phase == CanvasPhase::drag_wire) drop_wire(state, frame, outbox);
    if (state.drag.phase == CanvasPhase::move_nodes) drop_nodes(state, frame, outbox);
    state.drag = {};
}

// An open menu has the mouse to itself: a press on a row chooses it, one elsewhere closes it.
bool menu_takes(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    if (!state.menu.open()) return false;
    const Pointer& pointer = frame.pointer;
    const int row = pointer.over ? row_at(state.menu, pointer.at) : -1;
    if (pointer.at != state.pointer) state.menu.current = row;
    if (pointer.left_pressed || pointer.right_pressed) choose(state, frame, row, outbox);
    return true;
}

bool is_down(const CanvasDrag& drag, const Pointer& pointer) {
    return drag.left ? pointer.left_down : drag.right ? pointer.right_down : pointer.middle_down;
}

}  // namespace

void interact(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    for (const Action action : std::exchange(state.keys, {})) obey(state, frame, action, outbox);
    if (const auto row = std::exchange(state.wanted, {})) carry_out(state, frame, *row, {}, outbox);
    CanvasDrag& drag = state.drag;
    if (!frame.pointer.valid) cancel_drag(state, frame, outbox);
    state.hovered = {};
    const bool menu = menu_takes(state, frame, outbox);
    state.pointer = frame.pointer.at;
    if (menu) return;
    // A box and a panned canvas go over things, not at them.
    const bool sweeps =
        drag.phase == CanvasPhase::box || drag.phase == CanvasPhase::pan || drag.phase == CanvasPhase::map;
    if (frame.pointer.over && frame.pointer.valid && !sweeps && !on_minimap(state, frame))
        state.hovered = hit(frame.layout, view_of(state, frame), frame.pointer.at, frame.ui_scale);
    if (drag.phase == CanvasPhase::idle) {
        turn_wheel(state, frame, outbox);
        press(state, frame);
        return;
    }
    if (drag.phase == CanvasPhase::pending &&
        maths::distance(frame.pointer.at, drag.press) >= drag_begins * frame.ui_scale)
        begin_drag(state, frame);
    if (drag.phase != CanvasPhase::pending) move_along(state, frame, outbox);
    if (!is_down(drag, frame.pointer)) release(state, frame, outbox);
}

bool press_key(CanvasState& state, Action action) {
    const bool dragging = state.drag.phase != CanvasPhase::idle;
    const bool anything = !state.selection.nodes.empty() || !state.selection.wires.empty();
    bool wanted = false;
    switch (action) {
        case Action::cancel:
            wanted = dragging || anything || state.menu.open() || state.joining;
            break;
        case Action::erase:  // with nothing selected too: Del must not fall through to the vehicle
        case Action::copy:
        case Action::cut:
        case Action::duplicate:
        case Action::fit:
        case Action::tidy:
        case Action::paste:
        case Action::select_all:
        case Action::lesion:
        case Action::join:
        case Action::menu:
        case Action::step_left:
        case Action::step_right:
        case Action::step_up:
        case Action::step_down:
            wanted = true;
            break;
        default:
            break;
    }
    if (wanted) state.keys.push_back(action);
    return wanted;
}

}  // namespace braitenlab
