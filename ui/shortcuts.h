// Keyboard shortcuts: one table for dispatch, tooltips and the list of keys (F1).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ui/request.h"

namespace braitenlab {

class Strings;

// A printable key is the upper-case character that it types without Shift in the current layout: 'Z' is the key
// labelled Z. Other keys have GLFW's numbers. `alt` is the left Alt key, pressed and released without another key.
namespace key {
inline constexpr int escape = 256, enter = 257, tab = 258, backspace = 259, insert = 260, del = 261;
inline constexpr int right = 262, left = 263, down = 264, up = 265, page_up = 266, page_down = 267, home = 268,
                     end = 269;
inline constexpr int f1 = 290, f5 = 294, f9 = 298, f10 = 299, f11 = 300, f12 = 301, alt = 342, menu = 348;
inline constexpr int first_modifier = 340, last_modifier = 347;  // Shift, Ctrl, Alt …
}  // namespace key

struct KeyPress {
    int key = 0;
    bool ctrl = false, shift = false;
    friend bool operator==(const KeyPress&, const KeyPress&) = default;
};

// Where a shortcut applies. If several places use a key, the order is: lecture, focused widget, canvas or scene,
// everywhere.
enum class KeyPlace {
    everywhere,
    view,     // while held and no widget has the focus: moves the camera
    widget,   // while a widget has the focus
    canvas,   // while wiring
    scene,    // over the scene: while a tool draws, or while a lamp, an obstacle or a zone is selected (with Ctrl,
              // vehicles)
    lecture,  // in a lecture; keys of pages and notes while a lecture file is open
};
inline constexpr KeyPlace last_place = KeyPlace::lecture;

// "canvas": the string files have its heading as keys.place.canvas.
std::string_view name(KeyPlace);

struct Shortcut {
    KeyPress press;
    Action action;
    KeyPlace place = KeyPlace::everywhere;
};

// No key occurs twice in a place. An action may have several keys; the first one is shown.
std::span<const Shortcut> shortcuts();

std::optional<Action> action_for(KeyPress, KeyPlace = KeyPlace::everywhere);

// True for actions that hide a part of a lecture.
bool hides_a_part(Action);

// True for an action of KeyPlace::lecture whose key has an effect: those of pages and notes need an open lecture file.
bool has_effect_in_lecture(Action, bool has_pages);

// "play_pause": the string files have its words as action.play_pause.
std::string_view name(Action);
std::optional<Action> action_named(std::string_view);

// A key that a browser keeps for itself while a page has the focus. Once leave_keys_to_browser() was called, such keys
// are not shown.
bool is_for_browser(KeyPress);
void leave_keys_to_browser();
bool is_shown(KeyPress);

// The name of a key in the language of the strings: "Space", "Ctrl+Q", "−".
std::string key_name(KeyPress, const Strings&);

// The key to show for an action; empty when it has none.
std::string key_name(Action, const Strings&);

}  // namespace braitenlab
