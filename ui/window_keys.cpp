#include "ui/window_keys.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <imgui.h>

#include "core/io/link.h"
#include "ui/panels/course/exercise_keys.h"
#include "ui/panels/panels.h"
#include "ui/panels/prompts.h"
#include "ui/panels/sheets.h"
#include "ui/panels/signal_drag.h"
#include "ui/widgets/keyboard.h"
#include "ui/wiring/input.h"

namespace braitenlab::ui {

namespace {

bool turns_page(const LabView& view, KeyPress press) {
    const auto action = action_for(press, KeyPlace::lecture);
    return view.lecture && (action == Action::next_page || action == Action::previous_page);
}

// Keys for the number that is typed at a slider. Those that turn a page, as a clicker sends them, also take the number.
bool key_for_typing(const LabView& view, SliderState& sliders, Keyboard& keyboard, KeyPress press) {
    if (sliders.typed.empty()) return false;
    if (turns_page(view, press)) {
        sliders.commit = true;
        return false;
    }
    if (press.key == key::enter || press.key == key::tab) sliders.commit = true;
    if (press.key == key::tab) keyboard.focus = sliders.typed, keyboard.presses.push_back(press);
    if (press.key == key::escape) sliders.give_up = true;
    return true;
}

// Keys for the count of raised hands that is typed. Keys of a clicker end typing.
bool key_for_hands(PanelState& state, KeyPress press) {
    if (press.key == key::page_up || press.key == key::page_down ||
        action_for(press, KeyPlace::lecture) == Action::blank) {
        for (TextField& field : state.lecture.hands)
            if (std::exchange(field.active, false)) state.keyboard.focus.clear();
        return false;
    }
    return std::any_of(state.lecture.hands.begin(), state.lecture.hands.end(),
                       [press](TextField& field) { return for_text_field(field, press); });
}

bool key_for_focus(Keyboard& keyboard, KeyPress press) {
    if (keyboard.focus.empty()) return false;
    const auto action = action_for(press, KeyPlace::widget);
    if (!action) return false;
    // A slider that only the mouse has used shows no ring: Del deletes what is selected, as everywhere else.
    if (*action == Action::restore && !keyboard.shown && is_slider(keyboard.focus)) return false;
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

// True for a key that walks through the neurons of the diagram beside the scene: while it has the focus, and always in
// a lecture.
bool walks_watched_nodes(const LabView& view, const PanelState& state, KeyPress press) {
    const auto action = action_for(press, KeyPlace::canvas);
    if (view.mode == Mode::wiring || (action != Action::next_node && action != Action::previous_node)) return false;
    return state.keyboard.focus == wiring::canvas_focus || (view.lecture && watches_diagram(view, state));
}

// Keys that work while a sheet is open: those of the window. Keys of the lab do nothing.
bool works_under_a_sheet(KeyPress press) {
    const auto action = action_for(press);
    return action && (*action == Action::full_screen || *action == Action::screenshot || *action == Action::larger ||
                      *action == Action::smaller || *action == Action::keys);
}

// Keys of a lecture; those of pages and notes while a lecture file is open. Between its pages those that turn a page go
// back to the one that was left. They precede all others but those of sheets
// and text fields.
bool key_for_lecture(const LabView& view, PanelState& state, KeyPress press, Outbox& outbox) {
    const auto action = action_for(press, KeyPlace::lecture);
    if (!view.lecture || !action) return false;
    if (turns_page(view, press) && !view.pages && view.documents.left_pages)
        return outbox.emplace_back(back_to_page(view)), true;
    if (!has_effect_in_lecture(*action, view.pages)) {
        // Without pages N is not the key of a new population, and a clicker does not move the camera.
        const bool is_of_pages = *action == Action::notes || *action == Action::notes_page || turns_page(view, press);
        if (is_of_pages) outbox.push_back(NoticeRequest{"unavailable.no_lecture", {}, {}});
        return is_of_pages;
    }
    if (const std::string_view why_not = why_unavailable(view, state, *action); !why_not.empty())
        outbox.push_back(NoticeRequest{std::string(why_not), {}, {}});
    else if (!act_on_panels({view, state, press, outbox}, *action))
        outbox.push_back(*action);
    return true;
}

// Keys that give the lecture and tell nothing about the lab: they are not shown to the audience.
bool is_key_of_pages(const LabView& view, KeyPress press) {
    const auto action = action_for(press);
    const auto in_lecture = action_for(press, KeyPlace::lecture);
    return action == Action::lecture || action == Action::first_page || (in_lecture && hides_a_part(*in_lecture)) ||
           (view.pages && in_lecture.has_value());
}

// On the title page Enter, Space and Esc begin, and so do the keys of a lecturer: of lecture mode and of files, which
// then do their own. Keys of the window work, those of the lab do nothing.
bool key_for_title_page(const Acting& at, Outbox& outbox) {
    const KeyPress press = at.press;
    const auto action = action_for(press);
    const bool begins_lecture = action == Action::lecture || action == Action::open;
    if (press.key == key::enter || press.key == ' ' || press.key == key::escape || begins_lecture)
        outbox.push_back(BeginRequest{});
    if (begins_lecture && !act_on_panels(at, *action)) outbox.push_back(*action);
    if (action == Action::exit || action == Action::full_screen || action == Action::theme) outbox.push_back(*action);
    return true;
}

// Keys while a menu of the menu bar is open: Up and Down are Tab and Shift+Tab. False for keys that also work now.
bool key_for_menus(PanelState& state, KeyPress press) {
    MenuBarState& menus = state.menu_bar;
    const auto action = action_for(press);
    const auto for_row = [&](KeyPress key) { menus.presses.push_back(key); };
    if (press.key == key::escape || action == Action::menu_bar)
        toggle_menu(menus, menus.open);
    else if (press.key == key::left || press.key == key::right)
        switch_menu(menus, press.key == key::left ? -1 : 1);
    else if (action == Action::view)
        toggle_menu(menus, "view");
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

std::string clipboard_text() {
    const char* text = ImGui::GetClipboardText();
    return text ? text : "";
}

// Ctrl+V opens a link from the clipboard, unless objects or nodes have been copied in the lab since.
bool key_for_link(PanelState& state, KeyPress press, Outbox& outbox) {
    const auto action = action_for(press, KeyPlace::scene);
    if (action == Action::copy || action == Action::cut) state.scene_input.clipboard_at_copy = clipboard_text();
    if (action != Action::paste) return false;
    std::string text = clipboard_text();
    if (!io::is_link(text) || text == state.scene_input.clipboard_at_copy) return false;
    outbox.push_back(OpenRequest{std::move(text)});
    return true;
}

bool selects_vehicle(Action action) { return action == Action::next_vehicle || action == Action::previous_vehicle; }

// True if Tab has a vehicle to select. Without one it moves the focus into the cards, as it does in other programs.
bool has_other_vehicle(const LabView& view) {
    return std::any_of(view.now->vehicles.begin(), view.now->vehicles.end(), [&](const VehicleView& vehicle) {
        return vehicle.id != view.settings.selection.vehicle && is_in_tab_order(view, vehicle);
    });
}

// Moves the focus to the folded card that pulses, which Enter then unfolds. False if none does.
bool focus_folded_card(PanelState& state) {
    const std::string& anchor = state.prompts.highlight.anchor;
    const bool is_folded_card = std::any_of(state.cards.begin(), state.cards.end(), [&](const CardState& card) {
        return card.folded && !card.fold_id.empty() && card.fold_id == anchor;
    });
    if (!is_folded_card) return false;
    state.keyboard.focus = anchor, state.keyboard.revealed = true;
    return true;
}

// Actions for what a lecture does not show. The key of a hint works where its page shows the exercise.
bool is_left_out(const LabView& view, const PanelState& state, Action action) {
    if (!view.lecture) return false;
    return action == Action::charts || action == Action::menu_bar || action == Action::view ||
           (action == Action::hint && (!view.lesson || state.cards[static_cast<std::size_t>(Card::exercise)].folded));
}

// Executes an action: by the panels, or else by a request. Says why where it is impossible now.
void carry_out(const Acting& at, Action action) {
    const std::string_view why_not =
        is_left_out(at.view, at.state, action) ? "unavailable.in_lecture" : why_unavailable(at.view, at.state, action);
    if (!why_not.empty())
        at.outbox.push_back(NoticeRequest{std::string(why_not), {}, {}});
    else if (!act_on_panels(at, action) && !holds_play(at.view, at.state, action, at.outbox))
        at.outbox.push_back(action);
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
    } else {
        carry_out({view, state, {}, outbox}, action);
    }
}

}  // namespace

void pass_keys_to_rows(PanelState& state) {
    MenuBarState& menus = state.menu_bar;
    if (menus.open.empty()) menus.presses.clear();
    if (menus.drawn != menus.open) return;
    auto& presses = state.keyboard.presses;
    presses.insert(presses.end(), menus.presses.begin(), menus.presses.end());
    menus.presses.clear();
}

void execute_chosen(const LabView& view, PanelState& state, Outbox& outbox) {
    if (state.chosen.empty()) return;
    if (state.menu_bar.open.empty()) release_keyboard(state.keyboard);
    for (const Action action : std::exchange(state.chosen, {})) execute_chosen(view, state, action, outbox);
}

// Where a sheet covers Play, Space presses the button that has the ring, as Enter does; but it parts the words of a
// search.
bool presses_button(const PanelState& state, KeyPress press) {
    const Keyboard& keyboard = state.keyboard;
    const bool searches = state.sheet == Sheet::files && !state.sheets.files.search.empty();
    return press == KeyPress{' '} && state.sheet != Sheet::none && keyboard.shown && !keyboard.focus.empty() &&
           keyboard.text == TextInput::none && !searches;
}

bool press_key(const LabView& view, PanelState& state, KeyPress press, Outbox& outbox) {
    if (presses_button(state, press)) press = {key::enter};
    if (view.program.title_page) return key_for_title_page({view, state, press, outbox}, outbox);
    const bool is_modifier = press.key >= key::first_modifier && press.key <= key::last_modifier;
    if (!is_modifier) state.tooltips.hidden = true;
    if (state.lecture.blank && !is_modifier) {
        state.lecture.blank = false;
        return true;
    }
    if (key_for_prediction(view, state, press, outbox) || key_for_next_exercise(view, state, press)) return true;
    show_focus_for(state.keyboard, press);
    if (action_for(press) == Action::exit) {  // in every state; the app shows the sheet about unsaved edits
        outbox.push_back(Action::exit);
        return true;
    }
    if (key_for_typing(view, state.sliders, state.keyboard, press)) return true;
    if (state.sheet == Sheet::none &&
        (for_record_text(state.fields, press) || for_text_field(state.values.seed, press) ||
         for_text_area(state.exercise.note, press) || key_for_hands(state, press) ||
         for_text_field(state.exercise.hand_in.name, press)))
        return true;
    if (key_for_sheet_text(state, press)) return true;
    if (view.lecture && state.sheet == Sheet::none && !is_modifier && !is_key_of_pages(view, press))
        state.lecture.pressed.push_back({press, view.wall_seconds});
    if (state.sheet != Sheet::none && !works_under_a_sheet(press)) {
        key_for_sheet(state, press);
        return true;
    }
    if (!state.menu_bar.open.empty() && key_for_menus(state, press)) return true;
    if (press.key == key::escape && give_up_drag(state)) return true;
    if (state.brain.presets.open && press.key == key::escape) {
        state.brain.presets.closes = true;
        return true;
    }
    if (!state.glossary.open.empty() && press.key == key::escape) {
        state.glossary.open.clear();
        return true;
    }
    if (key_for_lecture(view, state, press, outbox)) return true;
    if (state.lecture.marks.drawing && press.key == key::escape) {
        state.lecture.marks.drawing = false;
        return true;
    }
    if (key_for_link(state, press, outbox)) return true;
    if (press_key(view, state.scene_input, state.keyboard, press, outbox)) return true;
    const bool watched = state.keyboard.focus == wiring::canvas_focus && view.mode != Mode::wiring;
    if (watched && works_in_watched_canvas(press) && key_for_canvas(state.canvas, press)) return true;
    if (walks_watched_nodes(view, state, press) && key_for_canvas(state.canvas, press)) return true;
    if (key_for_focus(state.keyboard, press)) return true;
    const bool on_a_card = action_for(press) == Action::lesion && !state.brain.lesion_under_pointer.empty();
    if (view.mode == Mode::wiring && !on_a_card && key_for_canvas(state.canvas, press)) return true;
    if (const auto action = action_for(press)) {
        if (*action == Action::next_vehicle && focus_folded_card(state)) return true;
        if (selects_vehicle(*action) && !has_other_vehicle(view))
            state.keyboard.presses.push_back(press);
        else
            carry_out({view, state, press, outbox}, *action);
        return true;
    }
    return false;
}

}  // namespace braitenlab::ui
