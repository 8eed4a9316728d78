#include "ui/wiring/canvas.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <imgui.h>

#include "ui/imgui_compat.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/theme.h"
#include "ui/wiring/draw.h"
#include "ui/wiring/input.h"
#include "ui/wiring/menu.h"
#include "ui/words/strings.h"

namespace braitenlab::wiring {

using namespace ui;

using maths::vec2;

namespace {

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

bool shows_all(const Layout& layout, const View& view, Rect area) {
    return std::all_of(layout.nodes.begin(), layout.nodes.end(),
                       [&](const NodeShape& node) { return area.contains(view.to_window(node.centre)); });
}

// True when the brain has new nodes that the user has not just added: added ones are selected.
bool has_foreign_nodes(const BrainGraph& brain, const BrainGraph& before, const CanvasSelection& selection) {
    return std::any_of(brain.nodes.begin(), brain.nodes.end(), [&](const Node& node) {
        const Node* known = find_node(before, node.id);
        return (known == nullptr || known->name != node.name) && selection.nodes.count(node.id) == 0;
    });
}

// The watched diagram takes the space of the buttons, so that its cards are as large as their numbers need.
bool has_buttons(const LabView& lab) { return lab.mode == Mode::wiring; }

// Fits the brain. The layout depends on the zoom, because letters have a least height; labels that grow need more room.
template <class LayOut>
void fit_letters(CanvasCamera& camera, LayOut lay_out, Rect area, float ui_scale, bool with_buttons) {
    constexpr int most_rounds = 5;
    camera.zoom = most_zoom;  // labels at their least size
    float before = 0;
    for (int round = 0; round < most_rounds && camera.zoom != before; ++round) {
        before = camera.zoom;
        fit(camera, lay_out(), area, ui_scale, with_buttons);
    }
    if (camera.zoom == before) return;
    // With larger labels the brain fits only at a zoom at which they are still larger: the largest zoom with room.
    constexpr int most_steps = 12;
    constexpr float step = 0.96f;
    float zoom = std::max(camera.zoom, before);
    for (int i = 0; i < most_steps; ++i, zoom *= step) {
        camera.zoom = zoom;
        fit(camera, lay_out(), area, ui_scale, with_buttons);
        if (camera.zoom >= zoom) break;
    }
    camera.zoom = std::min(camera.zoom, zoom);
}

// Makes the diagram of many nodes that a lecture watches so small that it is a map: its labels would cover each other.
void keep_to_names(CanvasCamera& camera, Rect area, float ui_scale, float least_type) {
    constexpr float step = 0.98f;
    while (camera.zoom > least_zoom && !is_map(view_of(camera, area, ui_scale), ui_scale, least_type))
        camera.zoom *= step;
}

// Moves the camera between frames. Parts of the picture stay under the mouse while the brain is edited or a card opens
// or folds. The whole brain is fitted when the canvas is entered, when it is another brain (a preset, a file) and when
// the window or the pane beside the scene changes its size, unless the user has moved the camera.
// `lay_out` returns the layout at the camera's zoom.
template <class LayOut>
void follow(CanvasState& state, const LabView& lab, const VehicleView& vehicle,
            const std::shared_ptr<const BrainGraph>& brain, LayOut lay_out, Rect area, float ui_scale) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ShownBefore now{lab.run_id, vehicle.kind, brain, area, {window.x, window.y}, ui_scale, lab.mode != Mode::wiring};
    ShownBefore& before = state.shown;
    const bool another = before.kind != now.kind || before.run_id != now.run_id;
    const auto changed = [](float a, float b) { return std::fabs(a - b) > 0.2f * std::max(a, b); };
    // Beside the scene the pane is small, and the user can drag its border. In a lecture a step of a page, or a card
    // that opens, gives pane and editor another place.
    const bool moved = lab.lecture && before.area != area;
    const bool other_pane = now.watched != before.watched || moved ||
                            (now.watched && (changed(before.area.w, area.w) || changed(before.area.h, area.h)));
    const bool resized = before.window != now.window || before.ui_scale != now.ui_scale || other_pane;
    if (another) state.selection = {}, state.drag = {}, state.menu = {}, state.joining.reset(), state.focus = {};
    if (!another && !resized && before.area != area)
        state.camera.middle += (area.middle() - before.area.middle()) / (state.camera.zoom * ui_scale);
    const bool outgrown = !another && before.brain != brain &&
                          has_foreign_nodes(*brain, *before.brain, state.selection) &&
                          !shows_all(lay_out(), view_of(state.camera, area, ui_scale), area);
    if (another || (!state.camera.by_user && (resized || state.entered || outgrown)))
        fit_letters(state.camera, lay_out, area, ui_scale, has_buttons(lab));
    before = std::move(now);
}

// Deselects parts that are no longer in the brain, for example after an undo.
void drop_stale_selection(CanvasState& state, const Layout& layout) {
    std::erase_if(state.selection.nodes, [&](NodeId id) { return find_shape(layout, id) == nullptr; });
    std::erase_if(state.selection.wires, [&](WireEnds ends) { return find_shape(layout, ends) == nullptr; });
    if (!centre_of(layout, state.focus)) state.focus = {};
    if (state.joining && find_shape(layout, *state.joining) == nullptr) state.joining.reset();
}

// Arrange and Fit in the canvas's upper right corner. A press on them does not reach the canvas.
struct CornerButton {
    std::string_view anchor, words;
    Rect rect;
    bool hovered = false, pressed = false;
};

std::vector<CornerButton> corner_buttons(const Ui& ui, Rect area, Pointer& pointer) {
    std::vector<CornerButton> buttons{{"canvas.fit", ui.strings("wiring.fit"), {}},
                                      {"canvas.arrange", ui.strings("wiring.arrange"), {}}};
    float right = area.x + area.w - ui.px(spacing::medium);
    for (CornerButton& button : buttons) {
        const float width = text_width(ui, Face::text, button.words) + ui.px(spacing::wide);
        button.rect = {right - width, area.y + ui.px(spacing::medium), width, ui.px(ui.tall(32))};
        right -= width + ui.px(spacing::small);
        button.hovered = pointer.over && button.rect.contains(pointer.at);
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

void set_cursor(const CanvasState& state) {
    const bool weight = state.drag.phase == DragPhase::drag_weight;
    if (weight || (state.drag.phase == DragPhase::idle && state.hovered.part == Part::label))
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    else if (state.hovered.is_pin())
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    else if (state.drag.phase == DragPhase::pan || state.drag.phase == DragPhase::move_nodes)
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
}

// A window of Dear ImGui over all others. End it with compat::end_window().
void begin_cover() {
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
    ImGui::Begin("wiring menu", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollWithMouse);
}

// Covers the window while the menu is open, so that no other window gets the mouse. True when it is hovered.
bool cover_window() {
    begin_cover();
    const bool hovers = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    compat::end_window();
    return hovers;
}

// Over all, because a menu is higher than a low canvas.
void draw_menu_on_cover(const Pen& canvas, CanvasMenu& menu) {
    if (!menu.open()) return;
    begin_cover();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRectFullScreen();
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    draw_menu({list, canvas.ui, canvas.view}, menu, {0, 0, window.x, window.y});
    list.PopClipRect();
    compat::end_window();
}

// `why`: key of the reason why there is no brain to show.
void draw_no_brain(const Ui& ui, Rect area, std::string_view why) {
    const float room = area.w - 2 * ui.px(spacing::wide), line = line_height(ui, Face::text);
    const std::vector<std::string> lines = lines_of_words(ui, ui.strings(why), Face::text, room);
    float y = area.y + (area.h - static_cast<float>(lines.size()) * line) / 2;
    for (const std::string& words : lines)
        put_centred(ui, {area.x + area.w / 2, y}, words, ui.palette.second_text), y += line;
}

void draw_brain(const LabView& view, const VehicleView& vehicle, CanvasState& state, Ui& ui, Rect area, bool over) {
    const auto& brain = brain_of(*view.now, vehicle);
    const BrainGraph& graph = *brain;
    if (state.drag.phase != DragPhase::move_nodes) state.held.clear();
    const auto lay_out = [&]() -> const Layout& {
        const Pen pen{*ImGui::GetWindowDrawList(), ui, view_of(state.camera, area, ui.scale)};
        return state.layout.get(brain, state.held, letter_room(pen, view, vehicle, graph));
    };
    follow(state, view, vehicle, brain, lay_out, area, ui.scale);
    const bool is_network = view.lecture && !has_buttons(view) && graph.nodes.size() > few_nodes;
    if (is_network && !state.camera.by_user) keep_to_names(state.camera, area, ui.scale, ui.least_type);
    const Layout& before = lay_out();
    drop_stale_selection(state, before);

    const Target target = target_of(view, vehicle);
    CanvasFrame frame{graph,
                      before,
                      area,
                      target,
                      ui.scale,
                      view.wall_seconds,
                      read_pointer(over),
                      has_buttons(view),
                      finger_reach(view),
                      ui.least_type};
    std::vector<CornerButton> buttons;
    if (frame.has_buttons) buttons = corner_buttons(ui, area, frame.pointer);
    handle_input(state, frame, ui.outbox);
    if (state.hovered != state.rest.on) state.rest.on = state.hovered, state.rest.since = view.wall_seconds;
    const auto pressed = [&](std::string_view anchor) {
        return std::any_of(buttons.begin(), buttons.end(),
                           [&](const CornerButton& button) { return button.anchor == anchor && button.pressed; });
    };
    if (pressed("canvas.arrange")) execute(state, frame, Action::tidy, ui.outbox);
    if (pressed("canvas.fit")) fit_letters(state.camera, lay_out, area, ui.scale, true);
    const Layout& layout = lay_out();

    const Pen pen{*ImGui::GetWindowDrawList(), ui, view_of(state.camera, area, ui.scale)};
    update(state.readings, *view.now, vehicle, graph, layout);
    const Picture picture{view,
                          vehicle,
                          graph,
                          layout,
                          state.readings,
                          state,
                          pen.view.to_canvas({area.x, area.y}),
                          pen.view.to_canvas({area.x + area.w, area.y + area.h})};
    const CanvasFrame after{graph, layout, area, target, ui.scale, view.wall_seconds, frame.pointer, frame.has_buttons};
    draw_ground(pen, area);
    draw_wires(pen, picture);
    draw_labels(pen, picture);
    draw_nodes(pen, picture);
    record_anchors(ui, pen, picture, area);
    for (const CornerButton& button : buttons) draw_button(ui, button);
    draw_minimap(pen, picture, area);
    draw_cursor(pen, picture, after);
    state.menu.finger = ui.finger;
    draw_menu_on_cover(pen, state.menu);
    set_cursor(state);
}

}  // namespace

void draw_canvas(const LabView& view, CanvasState& state, Ui& ui, Rect area) {
    if (area.w <= 0 || area.h <= 0) return;
    const int frame = ImGui::GetFrameCount();
    state.entered = state.last_frame != frame - 1;
    if (state.entered) state.drag = {}, state.menu = {}, state.joining.reset();
    state.last_frame = frame;
    ui.anchors.record("canvas", area);

    ImGui::SetNextWindowPos({area.x, area.y});
    ImGui::SetNextWindowSize({area.w, area.h});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::Begin(canvas_window, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar(3);
    ImGui::InvisibleButton(
        "###canvas", {area.w, area.h},
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
    bool over = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    if (state.menu.open()) over |= cover_window();
    // A click on the canvas removes the keyboard focus from the cards; beside the scene the canvas gets it.
    if (over && ui.keyboard && ImGui::IsMouseClicked(0))
        ui.keyboard->focus = view.mode == Mode::wiring ? std::string_view{} : canvas_focus;

    const VehicleView* vehicle = selected_vehicle(view);
    const auto brains = static_cast<int>(view.now->brains.size());
    const bool has_brain = vehicle != nullptr && vehicle->brain >= 0 && vehicle->brain < brains;
    const bool hidden = has_brain && hides_brain(view, vehicle->kind);
    if (has_brain && !hidden) {
        draw_brain(view, *vehicle, state, ui, area, over);
    } else {
        const Pen pen{*ImGui::GetWindowDrawList(), ui, view_of(state.camera, area, ui.scale)};
        draw_ground(pen, area);
        const bool asks_first = hidden && hides_outcome(view) && !is_brain_secret(view, vehicle->kind);
        draw_no_brain(ui, area,
                      asks_first                   ? way_to_brain(view)
                      : hidden                     ? "wiring.hidden"
                      : view.now->vehicles.empty() ? "brain.empty_scene"
                                                   : "wiring.no_vehicle");
        state.drag = {};
        state.menu = {};
        state.actions.clear();
    }
    compat::end_window();
}

}  // namespace braitenlab::wiring
