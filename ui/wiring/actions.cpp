#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "core/brain/four_neurons.h"
#include "ui/wiring/edits.h"
#include "ui/wiring/input.h"
#include "ui/wiring/menu.h"

namespace braitenlab::wiring {

using namespace ui;

using maths::vec2;

namespace {

void tidy_up(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    PlaceNodes none{frame.target, {}};
    for (const Node& node : frame.graph.nodes) none.places.push_back({node.id, {}});
    const BrainGraph bare = without_places(frame.graph);
    if (bare != frame.graph) outbox.push_back(EditRequest{none, state.next_gesture++});
    state.held = tidy(bare);
    fit(state.camera, lay_out(bare, {}, frame.layout.room), frame.area, frame.ui_scale, frame.has_buttons);
}

void toggle_lesion(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    // The part under the pointer, unless it is selected: then the whole selection.
    CanvasSelection chosen = state.selection;
    const Hit& under = state.hovered;
    if (under.part != Part::nothing && !chosen.contains(under))
        chosen = under.is_wire() ? CanvasSelection{{}, {under.wire}} : CanvasSelection{{under.node}, {}};
    if (chosen.empty()) return;
    const bool lesioned = all_lesioned(frame.graph, chosen.nodes, chosen.wires);
    send_edit(state, frame, set_lesion(frame.graph, chosen.nodes, chosen.wires, !lesioned), state.next_gesture++,
              outbox);
}

// The node under the pointer, unless it is selected: then all selected ones. All of them get a probe, or lose theirs.
void toggle_probes(CanvasState& state, const CanvasFrame& frame, Outbox&) {
    std::set<NodeId> chosen = state.selection.nodes;
    if (state.hovered.is_of_node() && !state.selection.contains(state.hovered)) chosen = {state.hovered.node};
    const bool has_all = std::all_of(chosen.begin(), chosen.end(), [&](NodeId id) {
        return state.probes.contains(find_node(frame.graph, id)->name);
    });
    for (const NodeId id : chosen) {
        const std::string& name = find_node(frame.graph, id)->name;
        if (has_all)
            state.probes.erase(name);
        else
            state.probes.insert(name);
    }
}

void select_all(CanvasState& state, const CanvasFrame& frame, Outbox&) {
    state.selection = {};
    for (const NodeShape& node : frame.layout.nodes) state.selection.nodes.insert(node.id);
    for (const WireShape& wire : frame.layout.wires)
        if (!wire.ghost) state.selection.wires.insert(wire.ends);
}

void step_in_menu(CanvasMenu& menu, Direction direction) {
    const int count = static_cast<int>(menu.rows.size());
    if (direction == Direction::down) menu.current = (menu.current + 1) % count;
    if (direction == Direction::up) menu.current = (std::max(menu.current, 0) + count - 1) % count;
}

// Moves the camera to the part in focus. A fitted brain is in sight, and stays fitted.
void reveal_focus(CanvasState& state, const CanvasFrame& frame) {
    const auto at = centre_of(frame.layout, state.focus);
    if (!at) return;
    if (state.camera.by_user || !frame.area.contains(view_of(state, frame).to_window(*at)))
        reveal(state.camera, frame.area, frame.ui_scale, *at);
}

// Selects the next neuron or motor, column by column and from top to bottom: the parts that have a sum.
template <int count>
void step_to_node(CanvasState& state, const CanvasFrame& frame, Outbox&) {
    std::vector<const NodeShape*> nodes;
    for (const NodeShape& each : frame.layout.nodes)
        if (each.kind != NodeKind::sensor) nodes.push_back(&each);
    if (nodes.empty() || state.joining) return;
    std::sort(nodes.begin(), nodes.end(), [](const NodeShape* a, const NodeShape* b) {
        return std::tie(a->centre.x, a->centre.y, a->id) < std::tie(b->centre.x, b->centre.y, b->id);
    });
    const bool has_one = state.selection.nodes.size() == 1 && state.selection.wires.empty();
    const auto now = std::find_if(nodes.begin(), nodes.end(), [&](const NodeShape* each) {
        return has_one && each->id == *state.selection.nodes.begin();
    });
    const auto all = static_cast<std::ptrdiff_t>(nodes.size());
    const std::ptrdiff_t from = now != nodes.end() ? now - nodes.begin() : count > 0 ? -1 : all;
    state.focus = {Part::node, nodes[static_cast<std::size_t>((from + count + all) % all)]->id, {}};
    select(state, state.focus, false);
    reveal_focus(state, frame);
}

template <Direction direction>
void step(CanvasState& state, const CanvasFrame& frame, Outbox&) {
    if (state.menu.open()) return step_in_menu(state.menu, direction);
    state.focus = next_in(direction, frame.layout, state.focus, state.joining.has_value());
    if (!state.joining && state.focus.part != Part::nothing) select(state, state.focus, false);
    reveal_focus(state, frame);
}

void begin_joining(CanvasState& state, const CanvasFrame& frame, Outbox&) {
    const NodeShape* shape =
        state.selection.nodes.size() == 1 ? find_shape(frame.layout, *state.selection.nodes.begin()) : nullptr;
    if (shape == nullptr) return show_refusal(state, frame, "wiring.refused.join_one");
    if (!shape->has_out) return show_refusal(state, frame, "wiring.refused.no_output");
    state.joining = shape->id;
    state.focus = {Part::node, shape->id, {}};
}

void finish_joining(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    const WireEnds ends{*state.joining, state.focus.node};
    state.joining.reset();
    const Edit edit = connect(frame.graph, ends);
    if (!edit) return show_refusal(state, frame, edit.refusal);
    if (direct_dial(frame.graph, ends))
        send_weight(frame, frame.graph, ends, 1, state.next_gesture++, outbox);
    else
        send_edit(state, frame, edit, state.next_gesture++, outbox);
    select(state, {Part::label, 0, ends}, false);
}

void enter(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    if (state.menu.open()) return choose(state, frame, state.menu.current, outbox);
    if (state.joining) return finish_joining(state, frame, outbox);
    const auto at = state.selection.empty() ? std::nullopt : centre_of(frame.layout, state.focus);
    open_menu(state, frame, view_of(state, frame).to_window(at ? *at : state.camera.middle));
    state.menu.current = 0;
}

void cancel(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    if (state.menu.open())
        state.menu = {};
    else if (state.joining)
        state.joining.reset();
    else if (state.drag.phase != DragPhase::idle)
        cancel_drag(state, frame, outbox);
    else
        state.selection = {}, state.focus = {}, state.refusal = {};
}

void arrange(CanvasState& state, const CanvasFrame& frame, Arrangement wanted, Outbox& outbox) {
    state.held = arranged(frame.layout, state.selection.nodes, wanted);
    std::erase_if(state.held,
                  [&](const auto& moved) { return find_shape(frame.layout, moved.first)->centre == moved.second; });
    send_positions(frame, state.held, state.next_gesture++, outbox);
}

struct CanvasAction {
    Action action;
    void (*act)(CanvasState&, const CanvasFrame&, Outbox&);
    bool in_menu = false;  // acts on an open menu; another action closes it
};

constexpr CanvasAction canvas_actions[]{
    {Action::menu, enter, true},
    {Action::step_left, step<Direction::left>, true},
    {Action::step_right, step<Direction::right>, true},
    {Action::step_up, step<Direction::up>, true},
    {Action::step_down, step<Direction::down>, true},
    {Action::next_node, step_to_node<1>},
    {Action::previous_node, step_to_node<-1>},
    {Action::erase, erase_selected},
    {Action::fit, [](CanvasState& state, const CanvasFrame& frame,
                     Outbox&) { fit(state.camera, frame.layout, frame.area, frame.ui_scale, frame.has_buttons); }},
    {Action::tidy, tidy_up},
    {Action::copy, [](CanvasState& state, const CanvasFrame& frame, Outbox&) { copy_selected(state, frame); }},
    {Action::cut,
     [](CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
         if (copy_selected(state, frame)) erase_selected(state, frame, outbox);
     }},
    {Action::paste, paste_copied},
    {Action::duplicate, duplicate_selected},
    {Action::select_all, select_all},
    {Action::lesion, toggle_lesion},
    {Action::probe, toggle_probes},
    {Action::join, begin_joining},
};

const CanvasAction* find_canvas_action(Action action) {
    for (const CanvasAction& row : canvas_actions)
        if (row.action == action) return &row;
    return nullptr;
}

}  // namespace

bool is_of_canvas(Action action) { return find_canvas_action(action) != nullptr; }

void open_menu(CanvasState& state, const CanvasFrame& frame, vec2 at) {
    state.menu = {};
    state.menu.rows = menu_rows(frame.graph, state.selection, !state.clipboard.empty());
    state.menu.at = at;
    state.menu.canvas_at = view_of(state, frame).to_canvas(at);
    set_heading(state.menu);
}

void open_drop_menu(CanvasState& state, const CanvasFrame& frame, Hit pin) {
    state.menu = {};
    state.menu.rows = drop_rows();
    state.menu.at = frame.pointer.at;
    state.menu.canvas_at = view_of(state, frame).to_canvas(frame.pointer.at);
    state.menu.loose = pin;
    set_heading(state.menu);
}

void cancel_drag(CanvasState& state, const CanvasFrame& frame, Outbox& outbox) {
    Drag& drag = state.drag;
    // All edits are sent at the release, except a weight, which is sent while it is dragged.
    if (drag.phase == DragPhase::drag_weight && drag.sent != drag.weight)
        send_weight(frame, drag.graph, drag.pressed.wire, drag.weight, drag.gesture, outbox);
    state.held.clear();
    if (drag.phase != DragPhase::idle) state.selection = drag.selection;
    drag = {};
}

void execute(CanvasState& state, const CanvasFrame& frame, Action action, Outbox& outbox) {
    if (action == Action::cancel) return cancel(state, frame, outbox);
    if (state.drag.phase != DragPhase::idle) return;  // keys wait until the drag ends
    const CanvasAction* row = find_canvas_action(action);
    if (!row || !row->in_menu) state.menu = {};
    if (row) row->act(state, frame, outbox);
}

void choose(CanvasState& state, const CanvasFrame& frame, int index, Outbox& outbox) {
    const CanvasMenu menu = std::exchange(state.menu, {});
    if (index >= 0 && index < static_cast<int>(menu.rows.size()))
        execute(state, frame, menu.rows[static_cast<std::size_t>(index)], menu, outbox);
}

void execute(CanvasState& state, const CanvasFrame& frame, const MenuRow& row, const CanvasMenu& menu, Outbox& outbox) {
    if (const auto* action = std::get_if<Action>(&row.effect)) return execute(state, frame, *action, outbox);
    const bool one_wire = state.selection.wires.size() == 1;
    switch (std::get<MenuCommand>(row.effect)) {
        case MenuCommand::add:
            return add_chosen(state, frame, menu, row.kind, outbox);
        case MenuCommand::edit_numbers:
            state.edit_numbers = true;
            return;
        case MenuCommand::chart:
            for (const NodeId id : state.selection.nodes)
                if (const Node* node = find_node(frame.graph, id)) state.for_chart.push_back(node->name);
            return;
        case MenuCommand::join:
            return begin_joining(state, frame, outbox);
        case MenuCommand::insert:
            if (one_wire) insert_new(state, frame, *state.selection.wires.begin(), outbox);
            return;
        case MenuCommand::flip:
            if (!one_wire) return;
            return send_weight(frame, frame.graph, *state.selection.wires.begin(),
                               -weight_of(frame.graph, *state.selection.wires.begin()), state.next_gesture++, outbox);
        case MenuCommand::detach:
            send_edit(state, frame, detach(frame.graph, state.selection.nodes), state.next_gesture++, outbox);
            return;
        case MenuCommand::column:
            return arrange(state, frame, Arrangement::column, outbox);
        case MenuCommand::row:
            return arrange(state, frame, Arrangement::row, outbox);
        case MenuCommand::even_down:
            return arrange(state, frame, Arrangement::even_down, outbox);
        case MenuCommand::even_across:
            return arrange(state, frame, Arrangement::even_across, outbox);
    }
}

}  // namespace braitenlab::wiring
