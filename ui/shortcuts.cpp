#include "ui/shortcuts.h"

#include <array>

#include "ui/strings.h"

namespace braitenlab {

namespace {

constexpr Shortcut shortcut_table[]{
    {{' '}, Action::play_pause},
    {{'.'}, Action::step},
    {{','}, Action::step_back},
    {{',', false, true}, Action::rewind},
    {{'.', false, true}, Action::fast_forward},
    {{'J'}, Action::set_bookmark},
    {{'J', false, true}, Action::last_bookmark},
    {{'R'}, Action::reset},
    {{'N'}, Action::new_population},
    {{'A'}, Action::add},
    {{'A', false, true}, Action::remove},
    {{'F'}, Action::follow},
    {{key::home}, Action::home},
    {{'O', false, true}, Action::slow_orbit},
    {{'B'}, Action::birds_eye},
    {{'V'}, Action::drivers_eye},
    {{'S'}, Action::sensors},
    {{'O'}, Action::outlines},
    {{'P'}, Action::trails},
    {{'U'}, Action::surfaces},
    {{'M'}, Action::map},
    {{'K'}, Action::labels},
    {{'I'}, Action::next_field},
    {{'E'}, Action::view},
    {{'W'}, Action::wiring},
    {{'W', false, true}, Action::watch},
    {{'D'}, Action::values},
    {{'R', false, true}, Action::another_start},
    {{'L', false, true}, Action::return_run},
    {{'G'}, Action::drive},
    {{'Y'}, Action::why},
    {{'M', false, true}, Action::memory},
    {{'Q'}, Action::slot},
    {{'Q', false, true}, Action::compare},
    {{'T', false, true}, Action::reality},
    {{'L'}, Action::lesion},
    {{'-'}, Action::slower},
    {{'='}, Action::faster},
    {{'+'}, Action::faster},  // layouts with + as an unshifted key
    {{'+', false, true}, Action::faster},
    {{'=', false, true}, Action::faster},
    {{key::tab}, Action::next_vehicle},
    {{key::tab, false, true}, Action::previous_vehicle},
    {{'X'}, Action::next_object},
    {{'X', false, true}, Action::previous_object},
    {{key::del}, Action::erase},
    {{'D', true, false}, Action::duplicate},
    {{'Z', true, false}, Action::undo},
    {{'Z', true, true}, Action::redo},
    {{'Y', true, false}, Action::redo},
    {{'T'}, Action::theme},
    {{'=', true, false}, Action::larger},
    {{'+', true, false}, Action::larger},
    {{'+', true, true}, Action::larger},
    {{'=', true, true}, Action::larger},
    {{'-', true, false}, Action::smaller},
    {{',', true, false}, Action::settings},
    {{'H', false, true}, Action::hint},
    {{'C'}, Action::charts},
    {{key::f9}, Action::lecture},
    {{key::f5}, Action::first_page},
    {{key::f11}, Action::full_screen},
    {{key::f12}, Action::screenshot},
    {{key::escape}, Action::cancel},
    {{'N', true, false}, Action::new_scene},
    {{'O', true, false}, Action::open},
    {{'S', true, false}, Action::save},
    {{'S', true, true}, Action::save_as},
    {{'Q', true, false}, Action::exit},
    {{key::f1}, Action::keys},
    {{key::f10}, Action::menu_bar},
    {{key::alt}, Action::menu_bar},

    {{key::left}, Action::turn_left, KeyPlace::view},
    {{key::right}, Action::turn_right, KeyPlace::view},
    {{key::up}, Action::raise, KeyPlace::view},
    {{key::down}, Action::lower, KeyPlace::view},
    {{key::left, false, true}, Action::pan_left, KeyPlace::view},
    {{key::right, false, true}, Action::pan_right, KeyPlace::view},
    {{key::up, false, true}, Action::pan_up, KeyPlace::view},
    {{key::down, false, true}, Action::pan_down, KeyPlace::view},
    {{key::page_up}, Action::zoom_in, KeyPlace::view},
    {{key::page_down}, Action::zoom_out, KeyPlace::view},

    {{'1'}, Action::slider_LL},
    {{'2'}, Action::slider_LR},
    {{'3'}, Action::slider_RL},
    {{'4'}, Action::slider_RR},
    {{key::tab, true, false}, Action::next_card},
    {{key::tab}, Action::next_widget, KeyPlace::widget},
    {{key::tab, false, true}, Action::previous_widget, KeyPlace::widget},
    {{key::enter}, Action::press, KeyPlace::widget},
    {{key::left}, Action::less, KeyPlace::widget},
    {{key::left, false, true}, Action::less, KeyPlace::widget},
    {{key::right}, Action::more, KeyPlace::widget},
    {{key::right, false, true}, Action::more, KeyPlace::widget},
    {{key::del}, Action::restore, KeyPlace::widget},
    {{key::escape}, Action::cancel, KeyPlace::widget},

    {{key::del}, Action::erase, KeyPlace::canvas},
    {{key::home}, Action::fit, KeyPlace::canvas},
    {{'F'}, Action::fit, KeyPlace::canvas},
    {{key::escape}, Action::cancel, KeyPlace::canvas},

    {{key::left}, Action::nudge, KeyPlace::scene},
    {{key::right}, Action::nudge, KeyPlace::scene},
    {{key::up}, Action::nudge, KeyPlace::scene},
    {{key::down}, Action::nudge, KeyPlace::scene},
    {{'Z'}, Action::rotate_left, KeyPlace::scene},
    {{'Z', false, true}, Action::rotate_right, KeyPlace::scene},
    {{'H'}, Action::add_here, KeyPlace::scene},
    {{key::insert}, Action::add_here, KeyPlace::scene},
    {{key::menu}, Action::scene_menu, KeyPlace::scene},
    {{key::f10, false, true}, Action::scene_menu, KeyPlace::scene},
    {{key::enter}, Action::close_outline, KeyPlace::scene},
    {{key::enter, false, true}, Action::close_outline, KeyPlace::scene},
    {{key::backspace}, Action::take_back, KeyPlace::scene},
    {{key::escape}, Action::cancel, KeyPlace::scene},
    {{'C', true, false}, Action::copy, KeyPlace::scene},
    {{'X', true, false}, Action::cut, KeyPlace::scene},
    {{'V', true, false}, Action::paste, KeyPlace::scene},
    {{'A', true, false}, Action::select_all, KeyPlace::scene},
    {{'C', true, false}, Action::copy, KeyPlace::canvas},
    {{'X', true, false}, Action::cut, KeyPlace::canvas},
    {{'V', true, false}, Action::paste, KeyPlace::canvas},
    {{'D', true, false}, Action::duplicate, KeyPlace::canvas},
    {{'A', true, false}, Action::select_all, KeyPlace::canvas},
    {{'T', false, true}, Action::tidy, KeyPlace::canvas},
    {{'L'}, Action::lesion, KeyPlace::canvas},
    {{'P'}, Action::probe, KeyPlace::canvas},
    {{'C'}, Action::join, KeyPlace::canvas},
    {{key::enter}, Action::menu, KeyPlace::canvas},
    {{key::left}, Action::step_left, KeyPlace::canvas},
    {{key::right}, Action::step_right, KeyPlace::canvas},
    {{key::up}, Action::step_up, KeyPlace::canvas},
    {{key::down}, Action::step_down, KeyPlace::canvas},

    {{key::page_down}, Action::next_page, KeyPlace::lecture},
    {{key::page_up}, Action::previous_page, KeyPlace::lecture},
    {{'N'}, Action::notes, KeyPlace::lecture},
    {{'N', false, true}, Action::notes_page, KeyPlace::lecture},
    {{'D'}, Action::draw_marks, KeyPlace::lecture},
    {{'D', false, true}, Action::clear_marks, KeyPlace::lecture},
    {{'T', false, true}, Action::hide_title, KeyPlace::lecture},
    {{'C', false, true}, Action::hide_character, KeyPlace::lecture},
    {{'B', false, true}, Action::hide_brain, KeyPlace::lecture},
    {{'B'}, Action::blank, KeyPlace::lecture},
    {{'.'}, Action::blank, KeyPlace::lecture},  // clickers send one of the two
};

struct NamedAction {
    Action action;
    std::string_view name;
};

// In the order of Action.
constexpr NamedAction action_names[]{
    {Action::play_pause, "play_pause"},
    {Action::step, "step"},
    {Action::step_back, "step_back"},
    {Action::rewind, "rewind"},
    {Action::fast_forward, "fast_forward"},
    {Action::set_bookmark, "set_bookmark"},
    {Action::last_bookmark, "last_bookmark"},
    {Action::reset, "reset"},
    {Action::add, "add"},
    {Action::remove, "remove"},
    {Action::follow, "follow"},
    {Action::new_population, "new_population"},
    {Action::exit, "exit"},
    {Action::sensors, "sensors"},
    {Action::outlines, "outlines"},
    {Action::trails, "trails"},
    {Action::surfaces, "surfaces"},
    {Action::memory, "memory"},
    {Action::labels, "labels"},
    {Action::last_run, "last_run"},
    {Action::next_field, "next_field"},
    {Action::view, "view"},
    {Action::wiring, "wiring"},
    {Action::watch, "watch"},
    {Action::values, "values"},
    {Action::another_start, "another_start"},
    {Action::return_run, "return_run"},
    {Action::undo, "undo"},
    {Action::redo, "redo"},
    {Action::slower, "slower"},
    {Action::faster, "faster"},
    {Action::drive, "drive"},
    {Action::why, "why"},
    {Action::map, "map"},
    {Action::reality, "reality"},
    {Action::slot, "slot"},
    {Action::compare, "compare"},
    {Action::mystery, "mystery"},
    {Action::lesion, "lesion"},
    {Action::next_vehicle, "next_vehicle"},
    {Action::previous_vehicle, "previous_vehicle"},
    {Action::next_object, "next_object"},
    {Action::previous_object, "previous_object"},
    {Action::home, "home"},
    {Action::slow_orbit, "slow_orbit"},
    {Action::birds_eye, "birds_eye"},
    {Action::drivers_eye, "drivers_eye"},
    {Action::cancel, "cancel"},
    {Action::erase, "erase"},
    {Action::duplicate, "duplicate"},
    {Action::screenshot, "screenshot"},
    {Action::full_screen, "full_screen"},
    {Action::theme, "theme"},
    {Action::larger, "larger"},
    {Action::smaller, "smaller"},
    {Action::settings, "settings"},
    {Action::charts, "charts"},
    {Action::studies, "studies"},
    {Action::keys, "keys"},
    {Action::hint, "hint"},
    {Action::exercise_reset, "exercise_reset"},
    {Action::open, "open"},
    {Action::save, "save"},
    {Action::save_as, "save_as"},
    {Action::copy_link, "copy_link"},
    {Action::lecture, "lecture"},
    {Action::first_page, "first_page"},
    {Action::next_page, "next_page"},
    {Action::previous_page, "previous_page"},
    {Action::notes, "notes"},
    {Action::notes_page, "notes_page"},
    {Action::hide_title, "hide_title"},
    {Action::hide_character, "hide_character"},
    {Action::hide_brain, "hide_brain"},
    {Action::new_scene, "new_scene"},
    {Action::menu_bar, "menu_bar"},
    {Action::save_run, "save_run"},
    {Action::save_brain, "save_brain"},
    {Action::save_exercise, "save_exercise"},
    {Action::export_csv, "export_csv"},
    {Action::export_robot, "export_robot"},
    {Action::take_away, "take_away"},
    {Action::about, "about"},
    {Action::glossary, "glossary"},
    {Action::draw_marks, "draw_marks"},
    {Action::clear_marks, "clear_marks"},
    {Action::blank, "blank"},
    {Action::slider_LL, "slider_LL"},
    {Action::slider_LR, "slider_LR"},
    {Action::slider_RL, "slider_RL"},
    {Action::slider_RR, "slider_RR"},
    {Action::next_card, "next_card"},
    {Action::next_widget, "next_widget"},
    {Action::previous_widget, "previous_widget"},
    {Action::press, "press"},
    {Action::less, "less"},
    {Action::more, "more"},
    {Action::restore, "restore"},
    {Action::turn_left, "turn_left"},
    {Action::turn_right, "turn_right"},
    {Action::raise, "raise"},
    {Action::lower, "lower"},
    {Action::zoom_in, "zoom_in"},
    {Action::zoom_out, "zoom_out"},
    {Action::pan_left, "pan_left"},
    {Action::pan_right, "pan_right"},
    {Action::pan_up, "pan_up"},
    {Action::pan_down, "pan_down"},
    {Action::fit, "fit"},
    {Action::nudge, "nudge"},
    {Action::rotate_left, "rotate_left"},
    {Action::rotate_right, "rotate_right"},
    {Action::close_outline, "close_outline"},
    {Action::take_back, "take_back"},
    {Action::scene_menu, "scene_menu"},
    {Action::add_here, "add_here"},
    {Action::copy, "copy"},
    {Action::cut, "cut"},
    {Action::paste, "paste"},
    {Action::select_all, "select_all"},
    {Action::tidy, "tidy"},
    {Action::probe, "probe"},
    {Action::join, "join"},
    {Action::menu, "menu"},
    {Action::step_left, "step_left"},
    {Action::step_right, "step_right"},
    {Action::step_up, "step_up"},
    {Action::step_down, "step_down"},
};

constexpr bool names_each_action() {
    if (std::size(action_names) != static_cast<std::size_t>(last_action) + 1) return false;
    for (std::size_t i = 0; i < std::size(action_names); ++i)
        if (action_names[i].action != static_cast<Action>(i)) return false;
    return true;
}
static_assert(names_each_action());

constexpr std::string_view place_names[]{"everywhere", "view", "widget", "canvas", "scene", "lecture"};
static_assert(std::size(place_names) == static_cast<std::size_t>(last_place) + 1);

struct NamedKey {
    int key;
    std::string_view words;  // in the string files
};

constexpr NamedKey named_keys[]{
    {' ', "key.space"},
    {key::escape, "key.escape"},
    {key::enter, "key.enter"},
    {key::tab, "key.tab"},
    {key::backspace, "key.backspace"},
    {key::del, "key.delete"},
    {key::home, "key.home"},
    {key::menu, "key.menu"},
    {'-', "key.minus"},
    {key::alt, "key.alt"},
    {key::insert, "key.insert"},
    {key::page_up, "key.page_up"},
    {key::page_down, "key.page_down"},
};

std::string bare_key_name(int pressed, const Strings& strings) {
    for (const NamedKey& named : named_keys)
        if (named.key == pressed) return std::string(strings(named.words));
    switch (pressed) {
        case key::left:
            return "←";
        case key::right:
            return "→";
        case key::up:
            return "↑";
        case key::down:
            return "↓";
        default:
            break;
    }
    if (pressed >= key::f1 && pressed < key::f1 + 25) return "F" + std::to_string(pressed - key::f1 + 1);
    return std::string(1, static_cast<char>(pressed));
}

}  // namespace

std::span<const Shortcut> shortcuts() { return shortcut_table; }

std::optional<Action> action_for(KeyPress press, KeyPlace place) {
    for (const Shortcut& shortcut : shortcut_table)
        if (shortcut.press == press && shortcut.place == place) return shortcut.action;
    return std::nullopt;
}

bool hides_a_part(Action action) {
    return action == Action::hide_title || action == Action::hide_character || action == Action::hide_brain;
}

bool has_effect_in_lecture(Action action, bool has_pages) {
    return has_pages || hides_a_part(action) || action == Action::draw_marks || action == Action::clear_marks ||
           action == Action::blank;
}

std::string_view name(KeyPlace place) { return place_names[static_cast<std::size_t>(place)]; }

std::string_view name(Action action) { return action_names[static_cast<std::size_t>(action)].name; }

std::optional<Action> action_named(std::string_view wanted) {
    for (const NamedAction& named : action_names)
        if (named.name == wanted) return named.action;
    return std::nullopt;
}

std::string key_name(KeyPress press, const Strings& strings) {
    std::string text;
    if (press.ctrl) text += std::string(strings("key.ctrl")) + "+";
    if (press.shift) text += std::string(strings("key.shift")) + "+";
    return text + bare_key_name(press.key, strings);
}

std::string key_name(Action action, const Strings& strings) {
    for (const Shortcut& shortcut : shortcut_table)
        if (shortcut.action == action) return key_name(shortcut.press, strings);
    return {};
}

}  // namespace braitenlab
