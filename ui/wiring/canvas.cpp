#include "ui/wiring/canvas.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <imgui.h>

#include "ui/imgui_compat.h"
#include "ui/strings.h"
#include "ui/theme.h"
#include "ui/widgets/keyboard.h"
#include "ui/wiring/actions.h"
#include "ui/wiring/draw.h"
#include "ui/wiring/interaction.h"

namespace braitenlab {
namespace {

using maths::vec2;

Pointer read_pointer(bool over) {
    const ImGuiIO& io = ImGui::GetIO();
    Pointer pointer;
    pointer.valid = ImGui::IsMousePosValid();
    pointer.at = {io.MousePos.x, io.MousePos.y};
    pointer.over = over;
    pointer.left_pressed = over && ImGui::IsMouseClicked(0);
    pointer.right_pressed = over && ImGui::IsMouseClicked(1);
    pointer.middle_pressed = over && ImGui::IsMouseClicked(2);
    pointer.left_down = io.MouseDown[0];
    pointer.right_down = io.MouseDown[1];
    pointer.middle_down = io.MouseDown[2];
    pointer.wheel = over ? io.MouseWheel : 0;
    pointer.shift = io.KeyShift;
    return pointer;
}

bool all_in_sight(const Layout& layout, const View& view, Rect area) {
    return std::all_of(layout.nodes.begin(), layout.nodes.end(), [&](const NodeShape& node) {
        const vec2 at = view.to_window(node.centre);
        return area.contains(at.x, at.y);
    });
}

// Whether there are nodes that were not there before and that nobody here has just made: those are selected.
bool brings_others(const BrainGraph& brain, const BrainGraph& before, const Caught& selection) {
    return std::any_of(brain.nodes.begin(), brain.nodes.end(), [&](const Node& node) {
        const Node* known = find_node(before, node.id);
        return (known == nullptr || known->name != node.name) && selection.nodes.count(node.id) == 0;
    });
}

// What is under the mouse stays there, whatever is done to the brain and whatever card opens or folds beside it. All of
// it is brought into view when it is first seen, when it is another one (a preset, a file), and when the window takes
// another size; a view that a person has chosen is left to them.
void follow(CanvasState& state, const LabView& lab, const VehicleView& vehicle,
            const std::shared_ptr<const BrainGraph>& brain, const Layout& layout, Rect area, float ui_scale) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    CanvasShown now{lab.sitting, vehicle.kind, brain, area, {window.x, window.y}, ui_scale};
    CanvasShown& before = state.shown;
    const bool another = before.kind != now.kind || before.sitting != now.sitting;
    const bool resized = before.window != now.window || before.ui_scale != now.ui_scale;
    if (another) state.selection = {}, state.drag = {}, state.menu = {}, state.joining.reset(), state.focus = {};
    if (!another && !resized && before.area != area)
        state.middle += (vec2{area.x + area.w / 2, area.y + area.h / 2} -
                         vec2{before.area.x + before.area.w / 2, before.area.y + before.area.h / 2}) /
                        (state.zoom * ui_scale);
    const bool outgrown = !another && before.brain != brain && brings_others(*brain, *before.brain, state.selection) &&
                          !all_in_sight(layout, view_of(state, area, ui_scale), area);
    if (another || (!state.own_view && (resized || state.entered || outgrown))) fit(state, layout, area, ui_scale);
    before = std::move(now);
}

// What an undo has taken away cannot stay selected.
void drop_stale_selection(CanvasState& state, const Layout& layout) {
    std::erase_if(state.selection.nodes, [&](NodeId id) { return find_shape(layout, id) == nullptr; });
    std::erase_if(state.selection.wires, [&](WireEnds ends) { return find_shape(layout, ends) == nullptr; });
    if (!middle_of(layout, state.focus)) state.focus = {};
    if (state.joining && find_shape(layout, *state.joining) == nullptr) state.joining.reset();
}

// Arrange and Fit, in the canvas's upper right corner. They take the press before the canvas sees it.
struct CornerButton {
    std::string_view anchor, words;
    Rect rect;
    bool hovered = false, pressed = false;
};

std::array<CornerButton, 2> corner_buttons(const Ui& ui, Rect area, Pointer& pointer) {
    std::array<CornerButton, 2> buttons{
        {{"canvas.fit", ui.strings("wiring.fit"), {}}, {"canvas.arrange", ui.strings("wiring.arrange"), {}}}};
    float right = area.x + area.w - ui.px(12);
    for (CornerButton& button : buttons) {
        const float width = text_width(ui, Face::text, button.words) + ui.px(24);
        button.rect = {right - width, area.y + ui.px(12), width, ui.px(32)};
        right -= width + ui.px(8);
        button.hovered = pointer.over && button.rect.contains(pointer.at.x, pointer.at.y);
        button.pressed = button.hovered && pointer.left_pressed;
    }
    for (const CornerButton& button : buttons)
        if (button.hovered) pointer.left_pressed = pointer.right_pressed = pointer.middle_pressed = false;
    return buttons;
}

void draw_button(const Ui& ui, const CornerButton& button) {
    const Palette& p = ui.palette;
    fill_box(ui, button.rect, button.hovered ? p.raised : p.panel);
    line_box(ui, button.rect, button.hovered ? p.second_text : p.line);
    put_centred(ui,
                {button.rect.x + button.rect.w / 2, button.rect.y + (button.rect.h - line_height(ui, Face::text)) / 2},
                button.words, p.text);
    ui.anchors.record(button.anchor, button.rect);
}

bool in_sight(Rect area, Rect r) {
    return r.x < area.x + area.w && r.x + r.w > area.x && r.y < area.y + area.h && r.y + r.h > area.y;
}

// Records what can be found again, as far as it lies in sight, and lets the highlighted one pulse.
void record(Ui& ui, Rect area, const std::string& id, Rect rect) {
    if (!area.contains(rect.x + rect.w / 2, rect.y + rect.h / 2)) return;
    ui.anchors.record(id, rect);
    if (ui.highlight != id) return;
    const float grow = ui.px(3 + 4 * ui.pulse);
    line_box(ui, {rect.x - grow, rect.y - grow, rect.w + 2 * grow, rect.h + 2 * grow},
             ui.palette.accent.with_alpha(0.4f + 0.6f * ui.pulse), 10, 2.5f);
}

// A point of the curve that its label does not cover.
float label_clear(const WireShape& wire) {
    const float t = 0.7f;
    const maths::vec2 away = bezier_point(wire.bezier, t) - wire.label;
    const bool covered = std::abs(away.x) < wire.label_size.x / 2 + 6 && std::abs(away.y) < wire.label_size.y / 2 + 6;
    return covered ? 0.45f : t;
}

void record_selected(Ui& ui, const BrainGraph& graph, const Layout& layout, const View& view, const Caught& selection) {
    for (const NodeId id : selection.nodes)
        if (const NodeShape* node = find_shape(layout, id))
            ui.anchors.record("selected." + graph.nodes[node->node].name, node_rect(view, *node));
    for (const WireEnds& ends : selection.wires)
        if (const WireShape* wire = find_shape(layout, ends))
            ui.anchors.record("selected." + name_of(graph, layout, *wire), label_rect(view, *wire));
}

void record_anchors(Ui& ui, Rect area, const BrainGraph& graph, const Layout& layout, const View& view) {
    for (const NodeShape& node : layout.nodes) {
        const std::string& name = graph.nodes[node.node].name;
        if (!in_sight(area, node_rect(view, node))) continue;
        record(ui, area, "node." + name, node_rect(view, node));
        if (node.has_in) record(ui, area, "pin." + name + ".in", pin_rect(view, node.in_pin()));
        if (node.has_out) record(ui, area, "pin." + name + ".out", pin_rect(view, node.out_pin()));
    }
    if (view.scale < map_zoom * ui.scale) return;
    for (const WireShape& wire : layout.wires) {
        const Rect label = label_rect(view, wire);
        if (!in_sight(area, label)) continue;
        const std::string name = name_of(graph, layout, wire);
        record(ui, area, "wire." + name, label);
        const maths::vec2 beside = view.to_window(bezier_point(wire.bezier, label_clear(wire)));
        record(ui, area, "curve." + name, {beside.x - 1, beside.y - 1, 2, 2});
    }
}

void set_cursor(const CanvasState& state) {
    const bool weight = state.drag.phase == CanvasPhase::drag_weight;
    if (weight || (state.drag.phase == CanvasPhase::idle && state.hovered.part == Part::label))
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    else if (state.hovered.part == Part::in_pin || state.hovered.part == Part::out_pin)
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    else if (state.drag.phase == CanvasPhase::pan || state.drag.phase == CanvasPhase::move_nodes)
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
}

// While the menu is open all that is clicked is for it: whatever lies beside it, or beneath, does not see the mouse.
bool hovers_shield() {
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
    ImGui::Begin("wiring menu", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollWithMouse);
    const bool hovers = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    ImGui::End();
    return hovers;
}

void nobody(const Ui& ui, Rect area) {
    put_centred(ui, {area.x + area.w / 2, area.y + area.h / 2}, ui.strings("wiring.nobody"), ui.palette.second_text);
}

void canvas_of(const LabView& view, const VehicleView& vehicle, CanvasState& state, Ui& ui, Rect area, bool over) {
    const auto& brain = view.now->brains[static_cast<std::size_t>(vehicle.brain)];
    const BrainGraph& graph = *brain;
    if (state.drag.phase != CanvasPhase::move_nodes) state.held.clear();
    const Layout& before = state.layout.of(brain, state.held);
    follow(state, view, vehicle, brain, before, area, ui.scale);
    drop_stale_selection(state, before);

    Target target;
    if (view.whole_kind)
        target.kind = vehicle.kind;
    else
        target.vehicle = vehicle.id;
    CanvasFrame frame{graph, before, area, target, ui.scale, view.wall_seconds, read_pointer(over)};
    const auto buttons = corner_buttons(ui, area, frame.pointer);
    interact(state, frame, ui.outbox);
    if (state.hovered != state.rested) state.rested = state.hovered, state.rested_since = view.wall_seconds;
    if (buttons[1].pressed) obey(state, frame, Action::tidy, ui.outbox);
    const Layout& layout = state.layout.of(brain, state.held);
    if (buttons[0].pressed) fit(state, layout, area, ui.scale);

    const Pen pen{*ImGui::GetWindowDrawList(), ui, view_of(state, area, ui.scale)};
    read(state.moment, *view.now, vehicle, graph, layout);
    const CanvasPicture picture{view,
                                vehicle,
                                graph,
                                layout,
                                state.moment,
                                state,
                                pen.view.to_canvas({area.x, area.y}),
                                pen.view.to_canvas({area.x + area.w, area.y + area.h})};
    const CanvasFrame after{graph, layout, area, target, ui.scale, view.wall_seconds, frame.pointer};
    draw_ground(pen, area);
    draw_wires(pen, picture);
    draw_labels(pen, picture);
    draw_nodes(pen, picture);
    record_anchors(ui, area, graph, layout, pen.view);
    record_selected(ui, graph, layout, pen.view, state.selection);
    for (const CornerButton& button : buttons) draw_button(ui, button);
    draw_minimap(pen, picture, area);
    draw_cursor(pen, picture, after);
    draw_menu(pen, state.menu, area);
    set_cursor(state);
}

}  // namespace

void wiring_canvas(const LabView& view, CanvasState& state, Ui& ui, Rect area) {
    if (area.w <= 0 || area.h <= 0) return;
    const int frame = ImGui::GetFrameCount();
    state.entered = state.last_frame != frame - 1;  // it was away in between
    if (state.entered) state.drag = {}, state.menu = {}, state.joining.reset();
    state.last_frame = frame;
    ui.anchors.record("canvas", area);

    ImGui::SetNextWindowPos({area.x, area.y});
    ImGui::SetNextWindowSize({area.w, area.h});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::Begin("wiring canvas", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar(3);
    ImGui::InvisibleButton(
        "###canvas", {area.w, area.h},
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
    bool over = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    if (state.menu.open()) over |= hovers_shield();
    // A click on the canvas takes the keyboard away from the cards.
    if (over && ui.keyboard && ImGui::IsMouseClicked(0)) ui.keyboard->focus.clear();

    const VehicleView* vehicle = find_vehicle(*view.now, view.selected);
    const auto brains = static_cast<int>(view.now->brains.size());
    const bool has_brain = vehicle != nullptr && vehicle->brain >= 0 && vehicle->brain < brains;
    if (has_brain) {
        canvas_of(view, *vehicle, state, ui, area, over);
    } else {
        const Pen pen{*ImGui::GetWindowDrawList(), ui, view_of(state, area, ui.scale)};
        draw_ground(pen, area);
        nobody(ui, area);
        state.drag = {};
        state.menu = {};
        state.keys.clear();
    }
    ImGui::End();
}

}  // namespace braitenlab
