#include "ui/window.h"

#include <algorithm>
#include <array>

#include <imgui.h>

#include "ui/panels/lesion.h"
#include "ui/panels/panels.h"
#include "ui/theme.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"
#include "ui/wiring/input.h"
#include "ui/wiring/inspector.h"

namespace braitenlab {

namespace {

constexpr float between_cards = 12, least_open_card = 124;  // layout pixels

// In a lecture a folded card is no wider than its title: it lies over the scene.
Rect slim(const LabView& view, const Ui& ui, const CardState& card, Rect r, bool to_the_right) {
    constexpr float title_width = 150;  // layout pixels
    if (!view.lecture || !card.folded) return r;
    const float w = std::min(r.w, ui.px(title_width));
    return {to_the_right ? r.x + r.w - w : r.x, r.y, w, r.h};
}

// The wiring canvas on its own ground, which leaves only the inset with the scene open.
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
    canvas.h -= below.h + ui.px(between_cards);
    wiring::draw_canvas(view, state.canvas, ui, canvas);
    wiring::draw_inspector(view, state.canvas, state.sliders, ui, below);
}

// The card of the lamp or obstacle that is selected above all. The brain card on top, the information card in what is
// left; in a low window the latter is folded, unless a person has opened it: then the brain card scrolls.
void right_column(const LabView& view, PanelState& state, Ui& ui, WindowLayout layout) {
    if (view.settings.selection.object && view.mode != Mode::wiring) {
        Rect object = layout.right;
        object.h = std::min(wanted_height(ui, state.object), 0.6f * layout.right.h);
        object_card(view, state, ui, object);
        layout.right.y += object.h + ui.px(between_cards);
        layout.right.h -= object.h + ui.px(between_cards);
    }
    Rect brain = layout.right;
    const float wanted = wanted_height(ui, state.brain);
    if (view.mode == Mode::wiring || view.lecture) {
        brain.h = std::min(wanted, layout.right.h);
        brain_card(view, state, ui, slim(view, ui, state.brain, brain, true), layout.right);
        return;
    }
    CardState& information = state.information;
    const float space = ui.px(between_cards);
    const float least =
        information.folded ? folded_height(ui) : std::min(wanted_height(ui, information), ui.px(least_open_card));
    const bool measured = state.brain.content > 0;
    const bool cramped = measured && wanted + space + least > layout.right.h;
    const bool was_folded = information.folded;
    if (cramped && !state.information_opened) information.folded = true;
    const float reserved = (information.folded ? folded_height(ui) : least) + space;
    brain.h = std::min(wanted, layout.right.h - reserved);
    brain_card(view, state, ui, brain, layout.right);
    Rect below = layout.right;
    below.y = brain.y + brain.h + space;
    below.h = std::min(wanted_height(ui, information), layout.right.y + layout.right.h - below.y);
    const bool folded_for_room = information.folded && !was_folded;
    const bool before = information.folded;
    information_card(view, state, ui, below);
    if (folded_for_room && information.folded == before) information.folded = was_folded;
}

// The exercise or the scene on top, the sensors below. Open, they take what the upper card leaves, and at least half of
// the column where it leaves less: then that card scrolls.
void left_column(const LabView& view, PanelState& state, Ui& ui, Rect column) {
    if (column.w <= 0) return;
    const CardState& upper = view.lesson ? state.exercise : state.scene;
    const float space = ui.px(between_cards), wanted = wanted_height(ui, state.sensors);
    const float left_over = column.h - space - wanted_height(ui, upper);
    const float reserved = std::min(wanted, std::max({folded_height(ui), left_over, column.h / 2}));
    Rect top = column;
    top.h = std::min(column.h - space - reserved, wanted_height(ui, upper));
    top = slim(view, ui, upper, top, false);
    if (view.lesson)
        exercise_card(view, state, ui, top);
    else
        scene_card(view, state, ui, top);
    if (view.lecture) return;
    Rect below = column;
    below.y = top.y + top.h + space;
    below.h = std::min(wanted, column.y + column.h - below.y);
    sensor_card(view, state, ui, below);
}

std::optional<std::string_view> slider_of(Action action) {
    constexpr std::array<std::string_view, 4> sliders{"slider.LL", "slider.LR", "slider.RL", "slider.RR"};
    if (action < Action::slider_LL || action > Action::slider_RR) return std::nullopt;
    return sliders[static_cast<std::size_t>(action) - static_cast<std::size_t>(Action::slider_LL)];
}

bool for_typing(SliderState& sliders, KeyPress press) {
    if (sliders.typed.empty()) return false;
    if (press.key == key::enter) sliders.commit = true;
    if (press.key == key::escape) sliders.give_up = true;
    return true;
}

bool for_focus(Keyboard& keyboard, KeyPress press) {
    if (keyboard.focus.empty()) return false;
    const auto action = action_for(press, KeyPlace::widget);
    if (!action) return false;
    if (*action == Action::cancel)
        keyboard.focus.clear();
    else
        keyboard.presses.push_back(press);
    return true;
}

// Undo and redo are the lab's, but for what the canvas alone has changed.
bool for_canvas(wiring::CanvasState& canvas, KeyPress press) {
    auto action = action_for(press, KeyPlace::canvas);
    if (!action) action = action_for(press);
    return action && wiring::press_key(canvas, *action);
}

// Under a sheet the lab still plays, and the window still grows: nothing that its widgets could want.
bool works_under_a_sheet(KeyPress press) {
    const auto action = action_for(press);
    return action &&
           (*action == Action::play_pause || *action == Action::full_screen || *action == Action::screenshot ||
            *action == Action::larger || *action == Action::smaller || *action == Action::keys);
}

// Down and Up are Tab and Shift+Tab there; every other key rests.
bool for_sheet(PanelState& state, KeyPress press) {
    if (press.key == key::escape) state.sheet = Sheet::none;
    if (press.key == key::down) press = {key::tab};
    if (press.key == key::up) press = {key::tab, false, true};
    if (press.key == key::tab || press.key == key::enter || press.key == key::left || press.key == key::right)
        state.keyboard.presses.push_back(press);
    return true;
}

// Into the file that it came from; else a person has to say where.
bool saves_at_once(const LabView& view) { return view.files && !view.files->save_to.empty(); }

// What opens a panel or moves the focus concerns nobody else.
bool panels_own(const LabView& view, PanelState& state, Action action, KeyPress press) {
    if (const auto slider = slider_of(action)) {
        state.brain.folded = false;
        state.keyboard.focus = *slider;
        state.keyboard.revealed = true;
    } else if (action == Action::next_card)
        state.keyboard.presses.push_back(press);
    else if (action == Action::keys)
        state.sheet = state.sheet == Sheet::keys ? Sheet::none : Sheet::keys;
    else if (action == Action::open || action == Action::save_as || (action == Action::save && !saves_at_once(view)))
        begin_files(state.files, action != Action::open), state.sheet = Sheet::files;
    else if (action == Action::view)
        state.view_menu = state.focus_view_menu = !state.view_menu;
    else if (action == Action::settings)
        state.sheet = Sheet::settings;
    else if (action == Action::charts)
        state.charts_open = !state.charts_open;
    else if (action == Action::lesion && !state.lesion_under_pointer.empty())
        state.lesion_wanted = state.lesion_under_pointer;
    else
        return false;
    return true;
}

}  // namespace

void draw_window(const LabView& view, PanelState& state, Ui& ui, const WindowLayout& layout) {
    ui.keyboard = &state.keyboard;
    ui.still = view.reduce_motion;
    const Prompt prompt = next_prompt(state.prompts, view);
    ui.highlight = prompt.anchor;
    begin_keyboard(state.keyboard);
    // A click into the scene takes the keyboard away from the cards.
    if (ImGui::IsMouseClicked(0) && !ImGui::GetIO().WantCaptureMouse) state.keyboard.focus.clear();
    if (ImGui::IsMouseClicked(0)) state.keyboard.shown = false;

    state.lesion_under_pointer.clear();
    remember(state.history, view);
    follow_lecture(view, state);
    ui.anchors.record("viewport", layout.scene);
    scene_input(view, state.scene_input, ui, layout.scene);
    point_to_lamp(view, ui);
    if (view.mode == Mode::wiring) draw_canvas(view, state, ui, layout);
    left_column(view, state, ui, layout.left);
    right_column(view, state, ui, layout);
    lesions_elsewhere(view, state, ui);
    if (layout.charts.w > 0) chart_card(view, state, ui, layout.charts);
    if (!view.lecture) tool_palette(view, state, ui, layout.tools);
    if (view.lecture) {
        lecture_figures(view, state, ui, layout);
        lecture_bar(view, ui, layout.toolbar);
    } else {
        timeline(view, state, ui, layout.timeline);
        hint_bar(view, ui, layout.hint_bar, prompt.hint);
        toolbar(view, state, ui, layout.toolbar);
    }
    scene_menu(view, state, ui, layout.window);
    recovery_sheet(view, state, ui, layout.window);
    view_menu(view, state, ui, layout);
    keys_card(view, state, ui, layout.window);
    files_sheet(view, state, ui, layout.window);
    settings_card(view, state, ui, layout.window);
    leaving_sheet(view, state, ui, layout.window);
    end_keyboard(state.keyboard);
}

bool press_key(const LabView& view, PanelState& state, KeyPress press, Outbox& outbox) {
    show_focus_for(state.keyboard, press);
    if (action_for(press) == Action::exit) {  // whatever is open or typed: nothing is lost, the lab asks
        outbox.push_back(Action::exit);
        return true;
    }
    if (for_typing(state.sliders, press)) return true;
    if (view.lecture && state.sheet == Sheet::none && press.key != key::f9)
        state.pressed.push_back({press, view.wall_seconds});
    if (state.sheet == Sheet::files &&
        (for_text_field(state.files.typed, press) || for_text_field(state.files.title, press)))
        return true;
    if (state.sheet != Sheet::none && !works_under_a_sheet(press)) return for_sheet(state, press);
    if (state.presets_open && press.key == key::escape) {
        state.close_presets = true;
        return true;
    }
    if (state.view_menu && press.key == key::escape) {
        state.view_menu = false;
        return true;
    }
    if (press_key(view, state.scene_input, state.keyboard, press, outbox)) return true;
    if (state.view_menu && for_view_menu(view, state, press)) return true;
    if (for_focus(state.keyboard, press)) return true;
    const bool on_a_card = action_for(press) == Action::lesion && !state.lesion_under_pointer.empty();
    if (view.mode == Mode::wiring && !on_a_card && for_canvas(state.canvas, press)) return true;
    if (const auto action = action_for(press)) {
        if (!panels_own(view, state, *action, press)) outbox.push_back(*action);
        return true;
    }
    return false;
}

}  // namespace braitenlab
