#include "ui/window.h"

#include <algorithm>
#include <array>
#include <utility>

#include <imgui.h>

#include "ui/double_click.h"
#include "ui/panels/cards.h"
#include "ui/panels/course/exercise_keys.h"
#include "ui/panels/panels.h"
#include "ui/widgets/item.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/wiring/input.h"
#include "ui/wiring/inspector.h"

namespace braitenlab::ui {

namespace {

constexpr float above_inspector = 12;         // layout pixels
constexpr float lecture_type_share = 0.022f;  // of the window's height: legible from the last row

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
    if ((open.bar || open.scene) && !is_over("menu.rows") && is_over("button.presets")) state.open_presets = true;
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
    Rect canvas = layout.canvas;
    canvas.h -= below.h + ui.px(above_inspector);
    wiring::draw_canvas(view, state.canvas, ui, canvas);
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
    draw.AddRectFilled({b.x, b.y}, {c.x + c.w, c.y + c.h}, paint(ui.palette.ground));
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
             mix(ui.palette.line, ui.palette.accent, border.held || border.focused ? 1.0f : border.warmth), 2);
    if (border.focused) move_border_by_keys(view, *ui.keyboard, is_below, ui.outbox);
    if (border.held) ui.outbox.push_back(CanvasShareRequest{share_at_pointer(layout)});
    ImGui::End();
    wiring::draw_canvas(view, state.canvas, ui, layout.canvas);
    let_canvas_be_focused(ui, layout.canvas);
}

// The string key of how the tool is used; empty while no tool draws.
std::string hint_of_tool(const SceneInputState& scene_input, const LabView& view) {
    if (scene_input.path.on) return "hint.draw_path";
    if (scene_input.tool == SceneInputTool::hand || view.mode == Mode::wiring) return {};
    return "tools." + std::string(word(scene_input.tool)) + "_how";
}

std::optional<std::string_view> slider_of(Action action) {
    constexpr std::array<std::string_view, 4> sliders{"slider.LL", "slider.LR", "slider.RL", "slider.RR"};
    if (action < Action::slider_LL || action > Action::slider_RR) return std::nullopt;
    return sliders[static_cast<std::size_t>(action) - static_cast<std::size_t>(Action::slider_LL)];
}

bool key_for_typing(SliderState& sliders, KeyPress press) {
    if (sliders.typed.empty()) return false;
    if (press.key == key::enter) sliders.commit = true;
    if (press.key == key::escape) sliders.give_up = true;
    return true;
}

// Keys for the count of raised hands that is typed. Page Up and Page Down end typing.
bool key_for_hands(PanelState& state, KeyPress press) {
    if (press.key == key::page_up || press.key == key::page_down) {
        for (TextField& field : state.hands)
            if (std::exchange(field.active, false)) state.keyboard.focus.clear();
        return false;
    }
    return std::any_of(state.hands.begin(), state.hands.end(),
                       [press](TextField& field) { return for_text_field(field, press); });
}

bool key_for_focus(Keyboard& keyboard, KeyPress press) {
    if (keyboard.focus.empty()) return false;
    const auto action = action_for(press, KeyPlace::widget);
    if (!action) return false;
    if (*action == Action::cancel)
        keyboard.focus.clear();
    else
        keyboard.presses.push_back(press);
    return true;
}

bool key_for_canvas(wiring::CanvasState& canvas, KeyPress press) {
    auto action = action_for(press, KeyPlace::canvas);
    if (!action) action = action_for(press);
    return action && wiring::press_key(canvas, *action);
}

// Keys for the selection in the watched diagram. Letters without Ctrl keep their meaning for the window, and so does
// Tab.
bool works_in_watched_canvas(KeyPress press) {
    return press.key != key::tab && (press.ctrl || press.key >= key::escape);
}

// Keys that work while a sheet is open: those of the window. Keys of the lab do nothing.
bool works_under_a_sheet(KeyPress press) {
    const auto action = action_for(press);
    return action && (*action == Action::full_screen || *action == Action::screenshot || *action == Action::larger ||
                      *action == Action::smaller || *action == Action::keys);
}

// Keys of a lecture; those of pages and notes while a lecture file is open. They precede all others but those of sheets
// and text fields.
bool key_for_lecture(const LabView& view, PanelState& state, KeyPress press, Outbox& outbox) {
    const auto action = action_for(press, KeyPlace::lecture);
    if (!view.lecture || !action) return false;
    if (*action == Action::draw_marks)
        state.marks.drawing = !state.marks.drawing;
    else if (*action == Action::blank && view.pages)
        state.blank = true;
    else if (*action == Action::clear_marks)
        state.marks.lines.clear();
    else if (view.pages)
        outbox.push_back(*action);
    else
        return false;
    return true;
}

// Keys that give the lecture and tell nothing about the lab: they are not shown to the audience.
bool is_key_of_pages(const LabView& view, KeyPress press) {
    const auto action = action_for(press);
    return action == Action::lecture || action == Action::first_page ||
           (view.pages && action_for(press, KeyPlace::lecture).has_value());
}

// Scrolls the body of a sheet. Up and Down scroll those that only have words to read.
bool scrolls_sheet(PanelState& state, KeyPress press) {
    constexpr float all = 1000, line = 0.12f;  // pages
    const bool reads = state.sheet == Sheet::keys || state.sheet == Sheet::about;
    SheetState& sheet = state.sheet == Sheet::keys       ? state.keys
                        : state.sheet == Sheet::about    ? state.about
                        : state.sheet == Sheet::students ? state.students
                                                         : state.settings;
    const float pages = press.key == key::page_down       ? 1
                        : press.key == key::page_up       ? -1
                        : reads && press.key == key::down ? line
                        : reads && press.key == key::up   ? -line
                        : reads && press.key == key::home ? -all
                        : reads && press.key == key::end  ? all
                                                          : 0;
    sheet.scroll += pages;
    return pages != 0;
}

// On a sheet Down and Up are Tab and Shift+Tab, unless they scroll it or move in the grid of exercises. Other keys do
// nothing.
bool key_for_sheet(PanelState& state, KeyPress press) {
    if (scrolls_sheet(state, press)) return true;
    if (press.key == key::escape) state.sheet = Sheet::none;
    const bool in_gallery = state.sheet == Sheet::files && state.keyboard.focus.starts_with("gallery.");
    if (in_gallery && press.key >= key::right && press.key <= key::up)
        return state.keyboard.presses.push_back(press), true;
    if (press.key == key::down) press = {key::tab};
    if (press.key == key::up) press = {key::tab, false, true};
    if (state.sheet == Sheet::children && press.key >= '1' && press.key <= '9') state.keyboard.presses.push_back(press);
    if (press.key == key::tab || press.key == key::enter || press.key == key::left || press.key == key::right)
        state.keyboard.presses.push_back(press);
    return true;
}

// True when Ctrl+S needs no name.
bool saves_at_once(const LabView& view) { return view.files && !view.files->save_to.empty(); }

// Opens the menu, or closes it if it is open.
void toggle_menu(PanelState& state, std::string_view menu) {
    state.menu_bar.presses.clear();
    state.menu_bar.open = state.menu_bar.open == menu ? std::string_view{} : menu;
}

// Keys while a menu of the menu bar is open: Up and Down are Tab and Shift+Tab. False for keys that also work now.
bool key_for_menus(PanelState& state, KeyPress press) {
    MenuBarState& menus = state.menu_bar;
    const auto action = action_for(press);
    const auto for_row = [&](KeyPress key) { menus.presses.push_back(key); };
    if (press.key == key::escape || action == Action::menu_bar)
        toggle_menu(state, menus.open);
    else if (press.key == key::left || press.key == key::right)
        switch_menu(menus, press.key == key::left ? -1 : 1);
    else if (action == Action::view)
        toggle_menu(state, "view");
    else if (press.key == key::down)
        for_row({key::tab});
    else if (press.key == key::up)
        for_row({key::tab, false, true});
    else if (press.key == key::tab || press.key == key::enter)
        for_row(press);
    else if (works_under_a_sheet(press) || action_for(press) == Action::play_pause)
        return false;
    return true;
}

// Passes the keys of the rows on, once the menu that they are for has been drawn. Call before begin_keyboard().
void pass_keys_to_rows(PanelState& state) {
    MenuBarState& menus = state.menu_bar;
    if (menus.open.empty()) menus.presses.clear();
    if (menus.drawn != menus.open) return;
    auto& presses = state.keyboard.presses;
    presses.insert(presses.end(), menus.presses.begin(), menus.presses.end());
    menus.presses.clear();
}

// Actions that open a file or the sheet of files.
bool act_on_files(const LabView& view, PanelState& state, Action action, Outbox& outbox) {
    const auto open_sheet = [&](bool saving, FileKind kind = FileKind::scene) {
        begin_files(state.files, saving, kind);
        state.sheet = Sheet::files;
        return true;
    };
    switch (action) {
        case Action::new_scene:
            if (const CatalogueEntry* scene = empty_scene(view)) outbox.push_back(OpenRequest{scene->path});
            return true;
        case Action::open:
            return open_sheet(false);
        case Action::save:
            return !saves_at_once(view) && open_sheet(true);
        case Action::save_as:
            return open_sheet(true);
        case Action::save_run:
            return open_sheet(true, FileKind::run);
        case Action::save_brain:
            return open_sheet(true, FileKind::brain);
        case Action::save_exercise:
            begin_author(view, state.author);
            state.sheet = Sheet::author;
            return true;
        default:
            return false;
    }
}

// Actions that open a panel, move the focus or need the state of a panel. False for actions of the lab.
bool act_on_panels(const LabView& view, PanelState& state, Action action, KeyPress press, Outbox& outbox) {
    if (const auto slider = slider_of(action)) {
        state.card(Card::brain).folded = false;
        state.keyboard.focus = *slider;
        state.keyboard.revealed = true;
    } else if (action == Action::next_card)
        state.keyboard.presses.push_back(press);
    else if (action == Action::keys)
        state.sheet = state.sheet == Sheet::keys ? Sheet::none : Sheet::keys;
    else if (action == Action::menu_bar || action == Action::view)
        toggle_menu(state, view.lecture ? "" : action == Action::view ? "view" : "file");
    else if (action == Action::export_csv)
        export_csv(view, state, outbox);
    else if (action == Action::settings)
        state.sheet = Sheet::settings;
    else if (action == Action::glossary)
        state.sheet = Sheet::glossary;
    else if (action == Action::about)
        state.sheet = Sheet::about;
    else if (action == Action::charts)
        state.charts_open = !state.charts_open;
    else if (action == Action::lesion && !state.lesion_under_pointer.empty())
        state.lesion_requested = state.lesion_under_pointer;
    else
        return act_on_files(view, state, action, outbox);
    return true;
}

// Executes an action that was chosen with the pointer or in a menu.
void execute_chosen(const LabView& view, PanelState& state, Action action, Outbox& outbox) {
    const auto has_place = [&](KeyPlace place) {
        return std::any_of(shortcuts().begin(), shortcuts().end(),
                           [&](const Shortcut& s) { return s.action == action && s.place == place; });
    };
    if (view.mode == Mode::wiring && has_place(KeyPlace::canvas)) {
        wiring::press_key(state.canvas, action);
    } else if (has_place(KeyPlace::scene)) {
        for (const Shortcut& s : shortcuts())
            if (s.action == action && s.place == KeyPlace::scene)
                return void(press_key(view, state.scene_input, state.keyboard, s.press, outbox));
    } else if (!act_on_panels(view, state, action, {}, outbox) && !holds_play(view, state, action, outbox)) {
        outbox.push_back(action);
    }
}

// The keyboard focus returns from the rows of a menu first: an action may move it.
void execute_chosen(const LabView& view, PanelState& state, Outbox& outbox) {
    if (state.chosen.empty()) return;
    if (state.menu_bar.open.empty()) release_keyboard(state.keyboard);
    for (const Action action : std::exchange(state.chosen, {})) execute_chosen(view, state, action, outbox);
}

// The handles in the scene belong to the sensor that the open sensor card shows.
void choose_sensor_handles(const LabView& view, PanelState& state) {
    SensorHandleState& handles = state.scene_input.sensors;
    handles.shown = !view.lecture && !state.card(Card::sensors).folded;
    handles.sensor = state.sensor;
    handles.alone = state.sensor_alone;
}

// The parts of a page of a lecture file.
void draw_page(const LabView& view, PanelState& state, Ui& ui, const WindowLayout& layout) {
    if (!view.pages) return;
    if (layout.caption.w > 0) lecture_caption(view, ui, layout.caption);
    if (layout.question.w > 0) lecture_question(view, state, ui, layout.question);
    if (layout.notes.h > 0) lecture_notes(view, state, ui, layout.notes);
}

}  // namespace

OpenCards open_cards(const LabView& view, const PanelState& state) {
    OpenCards open{.charts = state.charts_open};
    if (view.pages && view.pages->notes) open.notes = state.notes_height;
    for (const CardTraits& row : cards())
        open.right |=
            row.column == Column::right && row.shown(view) && !state.cards[static_cast<std::size_t>(row.card)].folded;
    return open;
}

void draw_window(const LabView& view, PanelState& state, Ui& ui, const WindowLayout& layout) {
    ui.keyboard = &state.keyboard;
    ui.still = view.reduce_motion;
    ui.decimal_mark = decimal_mark(ui.strings);
    ui.tooltips = &state.tooltips;
    ui.quiet = view.lecture;
    ui.least_type = view.lecture ? lecture_type_share * layout.window.h : 0;
    if (const ImVec2 moved = ImGui::GetIO().MouseDelta; moved.x != 0 || moved.y != 0)
        state.tooltips.moved_at = ImGui::GetTime();
    ImGui::GetIO().MouseDoubleClickTime = static_cast<float>(double_click_seconds);
    follow_held_play(view, state);
    Prompt prompt = view.lecture ? Prompt{} : next_prompt(state.prompts, view);
    if (is_play_held(view, state)) prompt = {"exercise.predict", "hint.predict_first"};
    ui.highlight = prompt.anchor;
    pass_keys_to_rows(state);
    begin_keyboard(state.keyboard);
    // A click into the scene removes the focus from the cards.
    if (ImGui::IsMouseClicked(0) && !ImGui::GetIO().WantCaptureMouse) state.keyboard.focus.clear();
    if (ImGui::IsMouseClicked(0)) state.keyboard.shown = false;

    MenuBarState& menus = state.menu_bar;
    if (view.lecture || state.sheet != Sheet::none) menus.open.clear();
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const OpenMenus open_menus{!menus.open.empty(), state.presets_open, state.scene_input.menu.open};
    state.scene_input.below_menu = open_menus.bar && !menus.panel.contains(mouse.x, mouse.y);
    state.lesion_under_pointer.clear();
    record(state.history, view);
    follow_lecture(view, state);
    ui.anchors.record("viewport", layout.scene);
    choose_sensor_handles(view, state);
    if (state.marks.drawing) {  // the mouse draws and does nothing else
        LabView without_camera = view;
        without_camera.camera_view = nullptr;
        scene_input(without_camera, state.scene_input, ui, layout.scene);
    } else {
        scene_input(view, state.scene_input, ui, layout.scene);
    }
    point_to_lamp(view, ui);
    if (view.mode == Mode::wiring)
        draw_canvas(view, state, ui, layout);
    else if (layout.canvas.w > 0)
        draw_watched(view, state, ui, layout);
    draw_column(Column::left, view, state, ui, layout.left);
    draw_column(Column::right, view, state, ui, layout.right);
    lesions(view, state, ui);
    if (layout.charts.w > 0) chart_card(view, state, ui, layout.charts);
    if (!view.lecture) tool_palette(view, state, ui, layout.tools);
    if (view.lecture) {
        lecture_figures(view, state, ui, layout.hint_bar);
        lecture_bar(view, state, ui, layout.toolbar);
        draw_page(view, state, ui, layout);
        if (state.sheet == Sheet::none) draw_marks(view, state.marks, ui, layout.scene, layout.toolbar, layout.window);
    } else {
        state.marks = {};
        timeline(view, state, ui, layout.timeline);
        const std::string tool = hint_of_tool(state.scene_input, view);
        hint_bar(view, ui, layout.hint_bar, tool.empty() ? prompt.hint : std::string_view(tool));
        toolbar(view, state, ui, layout.toolbar);
        menu_bar(state, ui, layout.menu_bar);
    }
    scene_menu(view, state, ui, layout.window);
    recovery_sheet(view, state, ui, layout.window);
    if (!view.lecture) lab_menu(view, state, ui, layout.menu_bar, layout.window);
    switch_menus(state, ui, open_menus);
    keys_card(view, state, ui, layout.window);
    files_sheet(view, state, ui, layout.window);
    author_sheet(view, state, ui, layout.window);
    settings_card(view, state, ui, layout.window);
    about_card(view, state, ui, layout.window);
    children_sheet(view, state, ui, layout.window);
    student_sheet(view, state, ui, layout.window);
    glossary_sheet(view, state, ui, layout.window);
    term_card(view, state, ui, layout.window);
    leaving_sheet(view, state, ui, layout.window);
    keep_drawn(state.fields);
    for (TextField* field : {&state.values.seed, &state.note, &state.student_name, &state.hand_in.name})
        (void)keep_drawn(*field);
    keep_drawn(state.author);
    for (TextField& field : state.hands) (void)keep_drawn(field);
    blank_window(view, state, ui, layout.window);
    end_keyboard(state.keyboard);
    execute_chosen(view, state, ui.outbox);
}

bool drags_vehicle(const PanelState& state, VehicleId vehicle) {
    if (vehicle == no_vehicle || !ImGui::GetIO().MouseDown[0]) return false;
    return !state.sliders.dragged.empty() || state.stick_held ||
           state.scene_input.drag.on.object == vehicle_object(vehicle);
}

bool press_key(const LabView& view, PanelState& state, KeyPress press, Outbox& outbox) {
    const bool is_modifier = press.key >= key::first_modifier && press.key <= key::last_modifier;
    if (state.blank && !is_modifier) {
        state.blank = false;
        return true;
    }
    if (key_for_prediction(view, state, press, outbox) || key_for_next_exercise(view, state, press)) return true;
    show_focus_for(state.keyboard, press);
    if (action_for(press) == Action::exit) {  // in every state; the app shows the sheet about unsaved edits
        outbox.push_back(Action::exit);
        return true;
    }
    if (key_for_typing(state.sliders, press)) return true;
    if (state.sheet == Sheet::none &&
        (for_record_text(state.fields, press) || for_text_field(state.values.seed, press) ||
         for_text_area(state.note, press) || key_for_hands(state, press) || for_text_field(state.hand_in.name, press)))
        return true;
    if (state.sheet == Sheet::students && for_text_field(state.student_name, press)) return true;
    if (view.lecture && state.sheet == Sheet::none && !is_modifier && !is_key_of_pages(view, press))
        state.pressed.push_back({press, view.wall_seconds});
    if (state.sheet == Sheet::files &&
        (for_text_field(state.files.typed, press) || for_text_field(state.files.title, press) ||
         for_text_field(state.files.story, press)))
        return true;
    if (state.sheet == Sheet::author && for_author_text(state.author, press)) return true;
    if (state.sheet != Sheet::none && !works_under_a_sheet(press)) return key_for_sheet(state, press);
    if (!state.menu_bar.open.empty() && key_for_menus(state, press)) return true;
    if (state.presets_open && press.key == key::escape) {
        state.close_presets = true;
        return true;
    }
    if (!state.glossary.open.empty() && press.key == key::escape) {
        state.glossary.open.clear();
        return true;
    }
    if (key_for_lecture(view, state, press, outbox)) return true;
    if (state.marks.drawing && press.key == key::escape) {
        state.marks.drawing = false;
        return true;
    }
    if (press_key(view, state.scene_input, state.keyboard, press, outbox)) return true;
    const bool watched = state.keyboard.focus == wiring::canvas_focus && view.mode != Mode::wiring;
    if (watched && works_in_watched_canvas(press) && key_for_canvas(state.canvas, press)) return true;
    if (key_for_focus(state.keyboard, press)) return true;
    const bool on_a_card = action_for(press) == Action::lesion && !state.lesion_under_pointer.empty();
    if (view.mode == Mode::wiring && !on_a_card && key_for_canvas(state.canvas, press)) return true;
    if (const auto action = action_for(press)) {
        if (!act_on_panels(view, state, *action, press, outbox) && !holds_play(view, state, *action, outbox))
            outbox.push_back(*action);
        return true;
    }
    return false;
}

}  // namespace braitenlab::ui
