#include "ui/wiring/actions.h"

#include <algorithm>
#include <utility>

#include "ui/wiring/make.h"

namespace braitenlab {

using maths::vec2;

namespace {

void tidy_up(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    PlaceNodes tidied{frame.target, {}};
    for (const Node& node : frame.graph.nodes) tidied.places.push_back({node.id, {}});
    const BrainGraph bare = without_places(frame.graph);
    if (bare != frame.graph) outbox.push_back(EditRequest{tidied, state.next_gesture++});
    state.held = tidy(bare);
    fit(state, lay_out(bare, {}), frame.area, frame.ui_scale);
}

void hurt_or_heal(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    // What lies under the pointer goes before what is selected, unless it is a part of that.
    Caught chosen = state.selection;
    const Hit& under = state.hovered;
    const bool wire = under.part == Part::label || under.part == Part::wire;
    if (wire && chosen.wires.count(under.wire) == 0) chosen = {{}, {under.wire}};
    if (!wire && under.part != Part::nothing && chosen.nodes.count(under.node) == 0) chosen = {{under.node}, {}};
    if (chosen.nodes.empty() && chosen.wires.empty()) return;
    const bool hurt = all_lesioned(frame.graph, chosen.nodes, chosen.wires);
    ask(state, frame, set_lesion(frame.graph, chosen.nodes, chosen.wires, !hurt), state.next_gesture++, outbox);
}

void select_all(CanvasState& state, const Layout& layout) {
    state.selection = {};
    for (const NodeShape& node : layout.nodes) state.selection.nodes.insert(node.id);
    for (const WireShape& wire : layout.wires)
        if (!wire.ghost) state.selection.wires.insert(wire.ends);
}

void step_in_menu(CanvasMenu& menu, Towards towards) {
    const int count = static_cast<int>(menu.rows.size());
    if (towards == Towards::down) menu.current = (menu.current + 1) % count;
    if (towards == Towards::up) menu.current = (std::max(menu.current, 0) + count - 1) % count;
}

void move_focus(CanvasState& state, const CanvasFrame& frame, Towards towards) {
    if (state.menu.open()) return step_in_menu(state.menu, towards);
    state.focus = next_towards(frame.layout, state.focus, towards, state.joining.has_value());
    if (!state.joining && state.focus.part != Part::nothing) select(state, state.focus, false);
    if (const auto at = middle_of(frame.layout, state.focus)) reveal(state, frame.area, frame.ui_scale, *at);
}

void begin_joining(CanvasState& state, const CanvasFrame& frame) {
    const NodeShape* shape =
        state.selection.nodes.size() == 1 ? find_shape(frame.layout, *state.selection.nodes.begin()) : nullptr;
    if (shape == nullptr) return refuse(state, frame, "wiring.refused.join_one");
    if (!shape->has_out) return refuse(state, frame, "wiring.refused.no_output");
    state.joining = shape->id;
    state.focus = {Part::node, shape->id, {}};
}

void finish_joining(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    const WireEnds ends{*state.joining, state.focus.node};
    state.joining.reset();
    const Edit edit = connect(frame.graph, ends);
    if (!edit) return refuse(state, frame, edit.refusal);
    if (direct_dial(frame.graph, ends))
        ask_weight(frame, frame.graph, ends, 1, state.next_gesture++, outbox);
    else
        ask(state, frame, edit, state.next_gesture++, outbox);
    select(state, {Part::label, 0, ends}, false);
}

void enter(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    if (state.menu.open()) return choose(state, frame, state.menu.current, outbox);
    if (state.joining) return finish_joining(state, frame, outbox);
    const auto at = nothing_selected(state) ? std::nullopt : middle_of(frame.layout, state.focus);
    open_menu(state, frame, view_of(state, frame).to_window(at ? *at : state.middle));
    state.menu.current = 0;
}

void cancel(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    if (state.menu.open())
        state.menu = {};
    else if (state.joining)
        state.joining.reset();
    else if (state.drag.phase != CanvasPhase::idle)
        cancel_drag(state, frame, outbox);
    else
        state.selection = {}, state.focus = {}, state.refusal = {};
}

void order(CanvasState& state, const CanvasFrame& frame, Order wanted, Outbox& outbox) {
    state.held = put_in_order(frame.layout, state.selection.nodes, wanted);
    std::erase_if(state.held,
                  [&](const auto& put) { return find_shape(frame.layout, put.first)->centre == put.second; });
    ask_places(frame, state.held, state.next_gesture++, outbox);
}

}  // namespace

void open_menu(CanvasState& state, const CanvasFrame& frame, vec2 at) {
    state.menu = {};
    state.menu.rows = menu_rows(frame.graph, state.selection, !state.clipboard.empty());
    state.menu.at = at;
    state.menu.place = view_of(state, frame).to_canvas(at);
    head_menu(state.menu);
}

void open_drop_menu(CanvasState& state, const CanvasFrame& frame, Hit pin) {
    state.menu = {};
    state.menu.rows = drop_rows();
    state.menu.at = frame.pointer.at;
    state.menu.place = view_of(state, frame).to_canvas(frame.pointer.at);
    state.menu.loose = pin;
    head_menu(state.menu);
}

void cancel_drag(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    CanvasDrag& drag = state.drag;
    // Edits are asked for at the release, but for a weight, which moves live.
    if (drag.phase == CanvasPhase::drag_weight && drag.sent != drag.weight)
        ask_weight(frame, drag.graph, drag.pressed.wire, drag.weight, drag.gesture, outbox);
    state.held.clear();
    if (drag.phase != CanvasPhase::idle) state.selection = drag.selection;
    drag = {};
}

void obey(CanvasState& state, const CanvasFrame& frame, Action action, Outbox& outbox) {
    if (action == Action::cancel) return cancel(state, frame, outbox);
    if (state.drag.phase != CanvasPhase::idle) return;  // the hand on the mouse has it
    switch (action) {
        case Action::menu:
            return enter(state, frame, outbox);
        case Action::step_left:
            return move_focus(state, frame, Towards::left);
        case Action::step_right:
            return move_focus(state, frame, Towards::right);
        case Action::step_up:
            return move_focus(state, frame, Towards::up);
        case Action::step_down:
            return move_focus(state, frame, Towards::down);
        default:
            break;
    }
    state.menu = {};
    switch (action) {
        case Action::erase:
            return erase_selected(state, frame, outbox);
        case Action::fit:
            return fit(state, frame.layout, frame.area, frame.ui_scale);
        case Action::tidy:
            return tidy_up(state, frame, outbox);
        case Action::copy:
            copy_selected(state, frame);
            return;
        case Action::cut:
            if (copy_selected(state, frame)) erase_selected(state, frame, outbox);
            return;
        case Action::paste:
            return paste_copied(state, frame, outbox);
        case Action::duplicate:
            return duplicate(state, frame, outbox);
        case Action::select_all:
            return select_all(state, frame.layout);
        case Action::lesion:
            return hurt_or_heal(state, frame, outbox);
        case Action::join:
            return begin_joining(state, frame);
        default:
            return;
    }
}

void choose(CanvasState& state, const CanvasFrame& frame, int index, Outbox& outbox) {
    const CanvasMenu menu = std::exchange(state.menu, {});
    if (index >= 0 && index < static_cast<int>(menu.rows.size()))
        carry_out(state, frame, menu.rows[static_cast<std::size_t>(index)], menu, outbox);
}

void carry_out(CanvasState& state, const CanvasFrame& frame, const MenuRow& row, const CanvasMenu& menu,
               Outbox& outbox) {
    const bool one_wire = state.selection.wires.size() == 1;
    switch (row.command) {
        case MenuCommand::add:
            return add_chosen(state, frame, menu, row.kind, outbox);
        case MenuCommand::edit_numbers:
            state.edit_numbers = true;
            return;
        case MenuCommand::join:
            return begin_joining(state, frame);
        case MenuCommand::insert:
            if (one_wire) insert_new(state, frame, *state.selection.wires.begin(), outbox);
            return;
        case MenuCommand::flip:
            if (!one_wire) return;
            return ask_weight(frame, frame.graph, *state.selection.wires.begin(),
                              -weight_of(frame.graph, *state.selection.wires.begin()), state.next_gesture++, outbox);
        case MenuCommand::detach:
            ask(state, frame, detach(frame.graph, state.selection.nodes), state.next_gesture++, outbox);
            return;
        case MenuCommand::column:
            return order(state, frame, Order::column, outbox);
        case MenuCommand::row:
            return order(state, frame, Order::row, outbox);
        case MenuCommand::even_down:
            return order(state, frame, Order::even_down, outbox);
        case MenuCommand::even_across:
            return order(state, frame, Order::even_across, outbox);
        default:
            if (row.key) obey(state, frame, *row.key, outbox);
            return;
    }
}

}  // namespace braitenlab
