#include "ui/window.h"

#include <algorithm>
#include <array>
#include <optional>

#include <imgui.h>

#include "ui/double_click.h"
#include "ui/imgui_compat.h"
#include "ui/panels/cards.h"
#include "ui/panels/course/exercise_keys.h"
#include "ui/panels/panels.h"
#include "ui/panels/prompts.h"
#include "ui/panels/sheets.h"
#include "ui/panels/signal_drag.h"
#include "ui/panels/trail_legend.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/window_keys.h"
#include "ui/wiring/inspector.h"

namespace braitenlab::ui {

namespace {

constexpr float above_inspector = 12;  // layout pixels
// Of the window's height, so that letters (without the space between lines) have 2.2 %: legible from the last row.
constexpr float lecture_type_share = 0.03f;

// A click on the button or title of a menu while another menu is open closes that one, which covers the button, and
// opens this one. Call after the menus are drawn.
struct OpenMenus {
    bool bar = false, presets = false, scene = false;  // open at the start of the frame
};
void switch_menus(PanelState& state, const Ui& ui, OpenMenus open) {
    if (!ImGui::IsMouseClicked(0)) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const auto is_over = [&](std::string_view anchor) {
        const Rect* rect = ui.anchors.find(anchor);
        return rect && rect->contains(mouse.x, mouse.y);
    };
    if (open.scene && is_over("menu")) return;
    const std::string_view title = menu_title_at(ui, mouse.x, mouse.y);
    if ((open.presets || open.scene) && !title.empty()) state.menu_bar.open = title;
    if ((open.bar || open.scene) && !is_over("menu.rows") && is_over("button.presets"))
        state.brain.presets.wanted = true;
}

// The diagram without the inspector below it; of no width while it is not shown.
Rect diagram_of(const LabView& view, const PanelState& state, const Ui& ui, const WindowLayout& layout) {
    Rect diagram = layout.canvas;
    if (view.mode == Mode::wiring)
        diagram.h -= wiring::inspector_rect(ui, state.canvas, layout.canvas).h + ui.px(above_inspector);
    return diagram;
}

// The wiring canvas with the inspector below it. The background does not cover the inset with the scene.
void draw_canvas(const LabView& view, PanelState& state, Ui& ui, const WindowLayout& layout) {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const Rect& w = layout.window;
    const Rect& s = layout.scene;
    const ImU32 ground = paint(ui.palette.ground);
    draw.AddRectFilled({w.x, w.y}, {w.x + w.w, s.y}, ground);
    draw.AddRectFilled({w.x, s.y + s.h}, {w.x + w.w, w.y + w.h}, ground);
    draw.AddRectFilled({w.x, s.y}, {s.x, s.y + s.h}, ground);
    draw.AddRectFilled({s.x + s.w, s.y}, {w.x + w.w, s.y + s.h}, ground);
    draw.AddRect({s.x, s.y}, {s.x + s.w, s.y + s.h}, paint(ui.palette.line));
    const Rect below = wiring::inspector_rect(ui, state.canvas, layout.canvas);
    const Rect canvas = diagram_of(view, state, ui, layout);
    wiring::draw_canvas(view, state.canvas, ui, canvas);
    draw_probes(view, state, ui, canvas);
    wiring::draw_inspector(view, state.canvas, state.sliders, ui, below);
}

// The canvas's share of the space when the border is at the pointer.
float share_at_pointer(const WindowLayout& layout) {
    const Rect &s = layout.scene, &b = layout.border, &c = layout.canvas;
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    if (b.w > b.h) return (c.y + c.h - pointer.y - b.h / 2) / std::max(1.0f, s.h + c.h);
    return (c.x + c.w - pointer.x - b.w / 2) / std::max(1.0f, s.w + c.w);
}

// Left and Right move the focused border; a border below the scene moves up with Right.
void move_border_by_keys(const LabView& view, Keyboard& keyboard, bool is_below, Outbox& outbox) {
    constexpr float step = 0.05f;
    const auto presses = [&](int wanted) {
        int count = 0;
        while (take(keyboard, wanted)) ++count;
        return static_cast<float>(count);
    };
    const float grows = (is_below ? 1.0f : -1.0f) * (presses(key::right) - presses(key::left));
    if (grows != 0) outbox.push_back(CanvasShareRequest{view.settings.canvas_share + step * grows});
}

// The wiring canvas beside the scene gets the keys of the canvas while it has the focus: after a click on it, or by
// Tab.
void let_canvas_be_focused(Ui& ui, const Rect& canvas) {
    if (stop_here(ui.keyboard, wiring::canvas_focus) && ui.keyboard->shown)
        ImGui::GetBackgroundDrawList()->AddRect({canvas.x + 1, canvas.y + 1},
                                                {canvas.x + canvas.w - 1, canvas.y + canvas.h - 1},
                                                paint(ui.palette.accent), 0, 0, ui.px(2));
}

// The wiring canvas beside the scene, and the border between them, which the pointer or the arrow keys move.
void draw_watched(const LabView& view, PanelState& state, Ui& ui, const WindowLayout& layout) {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const Rect &b = layout.border, &c = layout.canvas;
    const bool is_below = b.w > b.h;
    draw.AddRectFilled({b.x, b.y}, {c.x + c.w, c.y + c.h}, paint(ui.palette.ground), ui.px(radius::box));
    ImGui::SetNextWindowPos({b.x, b.y});
    ImGui::SetNextWindowSize({b.w, b.h});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::Begin("canvas border", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav);
    ImGui::PopStyleVar(2);
    begin_stops(ui.keyboard);
    const Item border = item(ui, "canvas.border", {b.w, b.h});
    if (border.hovered || border.held)
        ImGui::SetMouseCursor(is_below ? ImGuiMouseCursor_ResizeNS : ImGuiMouseCursor_ResizeEW);
    const float length = ui.px(48), thickness = ui.px(4);
    const float w = is_below ? length : thickness, h = is_below ? thickness : length;
    fill_box(ui, {b.x + (b.w - w) / 2, b.y + (b.h - h) / 2, w, h},
             mix(ui.palette.line, ui.palette.accent, border.held || border.focused ? 1.0f : border.warmth),
             Corner::bar);
    if (border.focused) move_border_by_keys(view, *ui.keyboard, is_below, ui.outbox);
    if (border.held) ui.outbox.push_back(CanvasShareRequest{share_at_pointer(layout)});
    compat::end_window();
    wiring::draw_canvas(view, state.canvas, ui, layout.canvas);
    draw_probes(view, state, ui, layout.canvas);
    let_canvas_be_focused(ui, layout.canvas);
}

// The cards of the left column that are above those of the right one; null: none.
IsGuest guests_on_right(const WindowLayout& layout) {
    if (layout.left_on_right) return [](const CardTraits& card) { return card.column == Column::left; };
    if (layout.exercise_on_right) return [](const CardTraits& card) { return card.card == Card::exercise; };
    return nullptr;
}

// The string key of how the tool is used; empty while no tool draws.
std::string hint_of_tool(const SceneInputState& scene_input, const LabView& view) {
    if (scene_input.path.on) return "hint.draw_path";
    if (scene_input.tool == SceneInputTool::hand || view.mode == Mode::wiring) return {};
    return "tools." + std::string(word(scene_input.tool)) + "_how";
}

// The handles in the scene belong to the sensor that the open sensor card shows. Without the card there are none.
void choose_sensor_handles(const LabView& view, PanelState& state) {
    SensorHandleState& handles = state.scene_input.sensors;
    handles.shown = traits(Card::sensors).shown(view) && !state.card(Card::sensors).folded;
    handles.sensor = state.sensors.shown;
    handles.alone = state.sensors.alone;
}

// The parts of the window that the lecturer's lines can be on.
MarkedParts marked_parts(const LabView& view, const PanelState& state, const Ui& ui, const WindowLayout& layout) {
    MarkedParts parts{.scene = layout.scene,
                      .diagram = diagram_of(view, state, ui, layout),
                      .of_diagram = {},
                      .strip = shows_lecture_figures(view) ? layout.hint_bar : Rect{},
                      .question = layout.question,
                      .bar = layout.toolbar,
                      .window = layout.window};
    parts.of_diagram = wiring::view_of(state.canvas.camera, parts.diagram, ui.scale);
    if (const LectureView* page = asked(view)) parts.asked = 2 * page->page + (page->shows(PagePart::answer) ? 1 : 0);
    return parts;
}

// The parts of a page of a lecture file, or the tally of a question without one.
void draw_page(const LabView& view, PanelState& state, Ui& ui, const WindowLayout& layout) {
    if (layout.caption.w > 0) lecture_caption(view, ui, layout.caption);
    if (layout.question.w > 0) lecture_question(view, state, ui, layout.question);
    if (layout.notes.h > 0) lecture_notes(view, state, ui, layout.notes);
}

// Covers a window in which bars and cards would be on top of each other.
void ask_for_room(Ui& ui, Rect window) {
    begin_bar(ui, "small window", window, true);
    fill_box(ui, window, ui.palette.panel, Corner::square);
    const auto lines =
        lines_of_words(ui, ui.strings("window.too_small"), Face::text, window.w - ui.px(2 * spacing::large));
    const float line = line_height(ui, Face::text);
    float y = window.y + (window.h - line * static_cast<float>(lines.size())) / 2;
    for (const std::string& words : lines) {
        put_centred(ui, {window.x + window.w / 2, y}, words, ui.palette.text);
        y += line;
    }
    end_bar();
}

void draw_title_page(const LabView& view, PanelState& state, Ui& ui, Rect window) {
    begin_keyboard(state.keyboard);
    title_page(view, ui, window);
    end_keyboard(state.keyboard);
}

// The prompt, or what leads to its widget: the heading of a folded card, or the button of a closed sheet.
Prompt within_reach(Prompt prompt, const LabView& view, const PanelState& state) {
    constexpr std::array of_diagram{"node.", "pin.", "wire.", "canvas"};
    const auto is_of = [&](std::string_view stem) { return prompt.anchor.starts_with(stem); };
    const bool is_in_diagram = std::any_of(of_diagram.begin(), of_diagram.end(), is_of);
    if (prompt.hint == "hint.think" && is_in_diagram && !view.settings.watching) prompt.anchor = "button.watch";
    if (prompt.anchor == "exercise.reset" && state.exercise.reset_asked) prompt.anchor = "exercise.reset_yes";
    if (prompt.anchor.starts_with("breeding.") && state.sheet != Sheet::breeding) prompt.anchor = "exercise.breeding";
    if (prompt.anchor == "selection.open" && state.sheet == Sheet::children) return {};  // it is followed
    constexpr std::array of_brain{"slider.", "bias.", "threshold.", "curve.", "lesion.", "brain.", "button.watch"};
    const auto begins = [&](std::string_view stem) { return prompt.anchor.starts_with(stem); };
    const bool is_in_brain = std::any_of(of_brain.begin(), of_brain.end(), begins);
    const bool is_in_exercise = begins("exercise.") || begins("selection.");
    const std::optional<Card> of = is_in_brain              ? std::optional(Card::brain)
                                   : is_in_exercise         ? std::optional(Card::exercise)
                                   : begins("card.sensors") ? std::optional(Card::sensors)
                                                            : std::nullopt;
    if (!of || !traits(*of).shown(view)) return prompt;
    const CardState& card = state.cards[static_cast<std::size_t>(*of)];
    if (!card.folded || card.fold_id.empty()) return prompt;
    return {card.fold_id, *of == Card::sensors ? prompt.hint : "hint.unfold"};
}

// The selected vehicle as seen in the scene, window pixels; empty if it is not seen.
Rect selected_in_scene(const LabView& view, Rect scene) {
    const VehicleView* vehicle = selected_vehicle(view);
    if (!vehicle || !view.camera_view) return {};
    const maths::vec2 place{vehicle->x, vehicle->y};
    const auto middle = project(*view.camera_view, place);
    if (!middle || !scene.contains(middle->x, middle->y)) return {};
    const float reach = 0.6f * kind_of(*view.now, *vehicle).body.length * pixels_per_metre(*view.camera_view, place);
    return {middle->x - reach, middle->y - reach, 2 * reach, 2 * reach};
}

// A prompt may name a widget that is not in the window now: then nothing pulses, and the usual hint is shown. The
// toolbar and sheets are drawn later.
std::string_view shown_hint(const Prompt& prompt, const Ui& ui) {
    const bool pulses = prompt.anchor.empty() || prompt.anchor == lamp_anchor || ui.anchors.find(prompt.anchor);
    if (!pulses && prompt.hint == "hint.follow_hint") return "hint.after_hint";
    if (prompt.hint == "hint.think") return prompt.hint;
    const bool is_drawn_later = prompt.anchor.starts_with("button.") || prompt.anchor.starts_with("breeding.");
    return pulses || is_drawn_later ? prompt.hint : "";
}

}  // namespace

OpenCards open_cards(const LabView& view, const PanelState& state) {
    OpenCards open{.charts = state.charts.open};
    if (asked(view)) open.question = state.lecture.question_height;
    open.sum = view.lecture && watches_diagram(view, state) && state.canvas.selection.nodes.size() == 1;
    if (view.pages && view.pages->notes) open.notes = state.lecture.notes_height;
    for (const CardTraits& row : cards()) {
        if (row.column == Column::none || !row.shown(view)) continue;
        const bool is_left = row.column == Column::left;
        if (state.cards[static_cast<std::size_t>(row.card)].folded)
            ++(is_left ? open.folded_left : open.folded_right);
        else
            (is_left ? open.left : open.right) = true;
    }
    if (open.left) open.folded_left = 0;
    if (open.right) open.folded_right = 0;
    return open;
}

void draw_window(const LabView& view, PanelState& state, Ui& ui, const WindowLayout& layout) {
    ui.keyboard = &state.keyboard;
    ui.still = view.program.reduce_motion;
    if (view.program.title_page) {
        state.tooltips.hidden = true;  // the pointer that begins lies where a tooltip would be
        return draw_title_page(view, state, ui, layout.window);
    }
    ui.decimal_mark = decimal_mark(ui.strings);
    ui.tooltips = &state.tooltips;
    state.tooltips.kept_free = selected_in_scene(view, layout.scene);
    ui.quiet = view.lecture;
    ui.finger = finger_height(view, ui.scale);
    ui.least_type = view.lecture ? lecture_type_share * layout.window.h : 0;
    if (const ImVec2 moved = ImGui::GetIO().MouseDelta; moved.x != 0 || moved.y != 0) {
        state.tooltips.moved_at = ImGui::GetTime();
        state.tooltips.hidden = false;
    }
    if (!ImGui::GetIO().InputQueueCharacters.empty() || ImGui::IsMouseClicked(0)) state.tooltips.hidden = true;
    ImGui::GetIO().MouseDoubleClickTime = static_cast<float>(double_click_seconds);
    follow_held_play(view, state);
    Prompt prompt = view.lecture ? Prompt{} : next_prompt(state.prompts, view);
    if (is_play_held(view, state)) prompt = {"exercise.predict", "hint.predict_first"};
    if (view.mode != Mode::wiring && !view.lecture) prompt = within_reach(prompt, view, state);
    ui.highlight = prompt.anchor;
    Highlight& highlight = state.prompts.highlight;
    if (highlight.anchor != prompt.anchor) highlight.anchor = prompt.anchor, highlight.reveals = true;
    highlight.hint = prompt.hint;
    ui.reveals = &highlight.reveals;
    pass_keys_to_rows(state);
    scroll_by_finger(state.finger_scroll, ui, state.sliders.dragged.empty() && !state.playhead_held);
    begin_keyboard(state.keyboard);
    end_text_by_press(state.keyboard);
    // A click into the scene removes the focus from the cards.
    if (ImGui::IsMouseClicked(0) && !ImGui::GetIO().WantCaptureMouse) state.keyboard.focus.clear();
    if (ImGui::IsMouseClicked(0)) state.keyboard.shown = false;

    MenuBarState& menus = state.menu_bar;
    if (view.lecture || state.sheet != Sheet::none) menus.open.clear();
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const OpenMenus open_menus{!menus.open.empty(), state.brain.presets.open, state.scene_input.menu.open};
    state.scene_input.below_menu = open_menus.bar && !menus.panel.contains(mouse.x, mouse.y);
    state.is_unsettled = false;
    state.brain.lesion_under_pointer.clear();
    state.brain.what_if.clear();
    state.map.hovered.reset();
    state.reality.hovered.reset();
    follow_map(view, state);
    state.map.replaces_diagram = layout.card_replaces_diagram;
    record(state.charts.history, view);
    follow_lecture(view, state);
    ui.anchors.record("viewport", layout.scene);
    choose_sensor_handles(view, state);
    if (state.lecture.marks.drawing) {  // the mouse draws and does nothing else
        LabView without_camera = view;
        without_camera.camera_view = nullptr;
        scene_input(without_camera, state.scene_input, ui, layout.scene, {});
    } else {
        scene_input(view, state.scene_input, ui, layout.scene, place_of_tool_palette(view, state, ui, layout.tools));
    }
    trail_legend(view, ui, layout.scene);
    why_callout(view, ui, layout.scene);
    point_to_lamp(view, ui);
    drop_nodes_on_chart(view, state, layout.charts);
    if (view.mode == Mode::wiring)
        draw_canvas(view, state, ui, layout);
    else if (layout.canvas.w > 0)
        draw_watched(view, state, ui, layout);
    draw_column(Column::left, view, state, ui, layout.left);
    draw_column(Column::right, view, state, ui, layout.right, guests_on_right(layout));
    lesions(view, state, ui);
    try_without_wire(view, state, ui, layout.scene);
    if (layout.charts.w > 0) chart_card(view, state, ui, layout.charts);
    drop_signals(view, state, ui, layout.charts);
    tool_palette(view, state, ui, layout.tools);
    if (view.lecture) {
        lecture_figures(view, state, ui, layout.hint_bar);
        lecture_bar(view, state, ui, layout.toolbar);
        draw_page(view, state, ui, layout);
        if (state.sheet == Sheet::none)
            draw_marks(view, state.lecture.marks, ui, marked_parts(view, state, ui, layout));
    } else {
        state.lecture.marks = {};
        timeline(view, state, ui, layout.timeline);
        const std::string tool = hint_of_tool(state.scene_input, view);
        const std::string_view hint = !state.sliders.dragged.empty() ? "hint.slider_drag"
                                      : tool.empty()                 ? shown_hint(prompt, ui)
                                                                     : std::string_view(tool);
        hint_bar(view, ui, layout.hint_bar, hint);
        toolbar(view, state, ui, layout.toolbar);
        menu_bar(state, ui, layout.menu_bar);
    }
    if (window_too_small(layout)) ask_for_room(ui, layout.window);
    scene_menu(view, state, ui, layout.window);
    if (!view.lecture) lab_menu(view, state, ui, layout.menu_bar, layout.window);
    switch_menus(state, ui, open_menus);
    draw_sheets(view, state, ui, layout.window);
    term_card(view, state, ui, layout.window);
    keep_drawn(state.sliders);
    keep_drawn(state.fields);
    keep_drawn_fields(state);
    for (TextField* field : {&state.values.seed, &state.exercise.note, &state.exercise.hand_in.name})
        (void)keep_drawn(*field);
    for (TextField& field : state.lecture.hands) (void)keep_drawn(field);
    blank_window(view, state, ui, layout.window);
    end_keyboard(state.keyboard);
    execute_chosen(view, state, ui.outbox);
}

TextKind awaited_text(const PanelState& state) {
    const auto& hands = state.lecture.hands;
    const bool counts = std::any_of(hands.begin(), hands.end(), [](const TextField& field) { return field.active; });
    const bool is_number = !state.sliders.typed.empty() || state.values.seed.active || counts;
    return is_number ? TextKind::number : TextKind::text;
}

bool drags_vehicle(const PanelState& state, VehicleId vehicle) {
    if (vehicle == no_vehicle || !ImGui::GetIO().MouseDown[0]) return false;
    return !state.sliders.dragged.empty() || state.brain.stick_held || state.map.drags ||
           state.scene_input.drag.on.object == vehicle_object(vehicle);
}

}  // namespace braitenlab::ui
