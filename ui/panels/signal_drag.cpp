#include "ui/panels/signal_drag.h"

#include <string>
#include <utility>

#include <imgui.h>

#include "ui/imgui_compat.h"
#include "ui/panels/charts/chart_strips.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/wiring/node_text.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr float signal_drag_begins = 4;  // layout pixels

bool is_pointer_in(Rect r) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    return r.w > 0 && r.contains(mouse.x, mouse.y);
}

bool is_from(const SignalDrag& drag, Rect card) { return card.w > 0 && card.contains(drag.press.x, drag.press.y); }

// Where the signal can be dropped; empty: nowhere.
Rect target_of_signal(const SignalDrag& drag, const Ui& ui, Rect card) {
    const bool is_from_card = is_from(drag, card);
    if (is_from_card && !drag.onto.empty()) return drag.onto_row;
    const Rect* part = is_from_card ? ui.anchors.find("charts.tab.3")
                       : card.w > 0 ? &card
                                    : ui.anchors.find("button.charts");
    return part ? *part : Rect{};
}

void show_chosen_strips(PanelState& state) {
    state.charts.open = true;
    state.charts.shown = Chart::chosen;
}

// A strip of the tab takes the place of the one that it is dropped on.
void drop_signal(PanelState& state, Rect card) {
    const SignalDrag& drag = state.charts.drag;
    if (is_from(drag, card) && !drag.onto.empty()) return move_strip(state, drag.name, drag.onto);
    choose_strip(state, drag.name);
    show_chosen_strips(state);
}

// The name beside the pointer, and the place where it can be dropped.
void draw_signal_drag(const Ui& ui, std::string_view name, Rect target) {
    ImDrawList& draw = *ImGui::GetForegroundDrawList();
    const Palette& p = ui.palette;
    if (target.w > 0)
        compat::outline(draw, {target.x, target.y}, {target.x + target.w, target.y + target.h},
                        paint(p.accent.with_alpha(is_pointer_in(target) ? 1.0f : 0.5f)), ui.px(radius::box), ui.px(2));
    const ImVec2 mouse = ImGui::GetIO().MousePos, pad{ui.px(spacing::small), ui.px(spacing::tight)};
    const ImVec2 low{mouse.x + ui.px(14), mouse.y + ui.px(8)};
    const ImVec2 high{low.x + text_width(ui, Face::small, name) + 2 * pad.x,
                      low.y + line_height(ui, Face::small) + 2 * pad.y};
    draw.AddRectFilled(low, high, paint(p.raised), ui.px(radius::box));
    compat::outline(draw, low, high, paint(p.accent), ui.px(radius::box), ui.px(1));
    put_on(draw, ui, {low.x + pad.x, low.y + pad.y}, name, p.text, Face::small);
}

void draw_node_over_chart(const LabView& view, const PanelState& state, const Ui& ui, Rect card) {
    const wiring::Drag& drag = state.canvas.drag;
    const VehicleView* vehicle = selected_vehicle(view);
    if (drag.phase != wiring::DragPhase::move_nodes || !is_pointer_in(card) || !vehicle) return;
    const Node* node = find_node(*brain_of(*view.now, *vehicle), drag.pressed.node);
    if (node) draw_signal_drag(ui, wiring::short_name(kind_of(*view.now, *vehicle).sensors, node->name), card);
}

// Those that the menu of the diagram has chosen. The chart is not in the window while the diagram fills it.
void take_from_menu(const LabView& view, PanelState& state, Outbox& outbox) {
    const std::vector<std::string> names = std::exchange(state.canvas.for_chart, {});
    if (names.empty()) return;
    std::string words;
    for (const std::string& name : names) {
        choose_strip(state, name);
        words += (words.empty() ? "" : ", ") + name;
    }
    show_chosen_strips(state);
    if (view.mode == Mode::wiring) outbox.push_back(NoticeRequest{"notice.on_chart", words, {}});
}

}  // namespace

void drag_signal(PanelState& state, const Ui& ui, bool held, std::string_view name) {
    SignalDrag& drag = state.charts.drag;
    if (!held || !ImGui::GetIO().MouseDown[0]) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (drag.name != name) drag = {.name = std::string(name), .press = {mouse.x, mouse.y}};
    drag.moves |= maths::distance({mouse.x, mouse.y}, drag.press) >= ui.px(signal_drag_begins);
}

bool give_up_drag(PanelState& state) {
    SignalDrag& drag = state.charts.drag;
    return drag.moves && !std::exchange(drag.given_up, true);
}

void drop_nodes_on_chart(const LabView& view, PanelState& state, Rect card) {
    wiring::CanvasState& canvas = state.canvas;
    if (canvas.drag.phase != wiring::DragPhase::move_nodes || !is_pointer_in(card)) return;
    const VehicleView* vehicle = selected_vehicle(view);
    if (!vehicle || ImGui::GetIO().MouseDown[0]) return;
    for (const NodeId id : canvas.selection.nodes)
        if (const Node* node = find_node(*brain_of(*view.now, *vehicle), id)) choose_strip(state, node->name);
    show_chosen_strips(state);
    canvas.held.clear();
    canvas.drag = {};
}

void drop_signals(const LabView& view, PanelState& state, Ui& ui, Rect card) {
    take_from_menu(view, state, ui.outbox);
    draw_node_over_chart(view, state, ui, card);
    SignalDrag& drag = state.charts.drag;
    if (drag.name.empty()) return;
    const Rect target = target_of_signal(drag, ui, card);
    if (!ImGui::GetIO().MouseDown[0]) {
        if (drag.moves && !drag.given_up && is_pointer_in(target)) drop_signal(state, card);
        drag = {};
        return;
    }
    if (!drag.moves || drag.given_up) return;
    const VehicleView* vehicle = selected_vehicle(view);
    draw_signal_drag(ui, vehicle ? wiring::short_name(kind_of(*view.now, *vehicle).sensors, drag.name) : drag.name,
                     target);
}

}  // namespace braitenlab::ui
