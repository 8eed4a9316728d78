// Which key does what: one table for dispatch, tooltips and the list of keys (F1).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ui/request.h"

namespace braitenlab {

class Strings;

// Printable keys are the character they type without Shift, in upper case, as the layout in use has it: 'Z' is where Z
// is printed. The others are numbered as GLFW numbers them, so that the window needs no table.
namespace key {
inline constexpr int escape = 256, enter = 257, tab = 258, backspace = 259, del = 261;
inline constexpr int right = 262, left = 263, down = 264, up = 265, home = 268, end = 269;
inline constexpr int f1 = 290, f9 = 298, f10 = 299, f11 = 300, f12 = 301, menu = 348;
}  // namespace key

struct KeyPress {
    int key = 0;
    bool ctrl = false, shift = false;
    friend bool operator==(const KeyPress&, const KeyPress&) = default;
};

// Where a key means what it means. Of two places that know a key, the narrower one has it: the focused widget, then the
// wiring canvas, then everywhere.
enum class KeyPlace {
    everywhere,
    view,    // while it is held and no widget has the focus: moves the camera
    widget,  // while a widget has the focus
    canvas,  // while wiring
    scene,   // over the scene: while drawing, or while a lamp or an obstacle is selected (with Ctrl, vehicles too)
};
inline constexpr KeyPlace last_place = KeyPlace::scene;

struct Shortcut {
    KeyPress press;
    Action action;
    KeyPlace place = KeyPlace::everywhere;
};

// No key twice in a place; an action may have several keys, the one to show first.
std::span<const Shortcut> shortcuts();

std::optional<Action> action_for(KeyPress, KeyPlace = KeyPlace::everywhere);

// "play_pause": the string files have its words as action.play_pause.
std::string_view name(Action);
std::optional<Action> action_named(std::string_view);

// "Space", "Ctrl+Q", "−", in the language of the strings.
std::string key_name(KeyPress, const Strings&);

// The key to show for an action; empty where it has none.
std::string key_name(Action, const Strings&);

}  // namespace braitenlab
