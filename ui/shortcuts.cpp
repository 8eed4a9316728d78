#include "ui/shortcuts.h"

#include <algorithm>
#include <array>
#include <initializer_list>

#include "ui/words/strings.h"

namespace braitenlab {

namespace {

constexpr std::size_t most_keys = 5;  // of one action

struct Key {
    constexpr Key() = default;  // none
    constexpr Key(int key, KeyPlace where = KeyPlace::everywhere) : press{key}, place(where) {}
    constexpr Key(KeyPress pressed, KeyPlace where = KeyPlace::everywhere) : press(pressed), place(where) {}

    KeyPress press;
    KeyPlace place = KeyPlace::everywhere;
};

constexpr KeyPress ctrl(int key) { return {key, true, false}; }
constexpr KeyPress shift(int key) { return {key, false, true}; }
constexpr KeyPress ctrl_shift(int key) { return {key, true, true}; }

constexpr std::array<Key, most_keys> list_of(std::initializer_list<Key> keys) {
    std::array<Key, most_keys> list;
    std::copy(keys.begin(), keys.end(), list.begin());
    return list;
}

struct NamedAction {
    std::string_view name;
    std::array<Key, most_keys> keys;
};

bool browser_has_keys = false;

// In the order of Action.
constexpr NamedAction named_actions[]{
#define KEYS(...) list_of({__VA_ARGS__})
#define ACTION(id, keys, ...) {#id, keys},
#include "ui/actions.def"
#undef KEYS
};

constexpr std::size_t count_keys() {
    std::size_t count = 0;
    for (const NamedAction& action : named_actions)
        for (const Key& key : action.keys) count += key.press.key != 0;
    return count;
}

constexpr std::array<Shortcut, count_keys()> list_keys() {
    std::array<Shortcut, count_keys()> all{};
    std::size_t next = 0;
    for (std::size_t i = 0; i < std::size(named_actions); ++i)
        for (const Key& key : named_actions[i].keys)
            if (key.press.key != 0) all[next++] = {key.press, static_cast<Action>(i), key.place};
    return all;
}

constexpr auto shortcut_table = list_keys();

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

// From key::right to key::up.
constexpr const char* arrow_names[]{"→", "←", "↓", "↑"};

std::string bare_key_name(int pressed, const Strings& strings) {
    for (const NamedKey& named : named_keys)
        if (named.key == pressed) return std::string(strings(named.words));
    if (pressed >= key::right && pressed <= key::up) return arrow_names[pressed - key::right];
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
    return action == Action::hide_title || action == Action::hide_character || action == Action::hide_brain ||
           action == Action::ask_first;
}

bool has_effect_in_lecture(Action action, bool has_pages) {
    return has_pages || hides_a_part(action) || action == Action::draw_marks || action == Action::clear_marks ||
           action == Action::blank || action == Action::tally;
}

bool is_for_browser(KeyPress press) {
    constexpr std::string_view with_ctrl = "ACDOSVXYZ,";  // of the page
    if (!press.ctrl) return press.key == key::f12;
    return press.key >= 128 || with_ctrl.find(static_cast<char>(press.key)) == std::string_view::npos;
}

void leave_keys_to_browser() { browser_has_keys = true; }

bool is_shown(KeyPress press) { return !browser_has_keys || !is_for_browser(press); }

std::string_view name(KeyPlace place) { return place_names[static_cast<std::size_t>(place)]; }

std::string_view name(Action action) { return named_actions[static_cast<std::size_t>(action)].name; }

std::optional<Action> action_named(std::string_view wanted) {
    for (std::size_t i = 0; i < std::size(named_actions); ++i)
        if (named_actions[i].name == wanted) return static_cast<Action>(i);
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
        if (shortcut.action == action && is_shown(shortcut.press)) return key_name(shortcut.press, strings);
    return {};
}

}  // namespace braitenlab
