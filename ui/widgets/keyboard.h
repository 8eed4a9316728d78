// The keyboard focus: one widget, by its anchor, or the viewport. Dear ImGui's own keyboard navigation stays off: Space
// would press buttons, and 1.86 loses keys that go down and up within a frame.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/view/camera.h"
#include "ui/shortcuts.h"

namespace braitenlab::ui {

// Text input: none, to a text field that becomes active in one of the next frames, or to an active one.
enum class TextInput { none, awaited, open };

// What the open text field takes: of a number a screen shows the keys of digits.
enum class TextKind { none, text, number };

struct Keyboard {
    std::string focus;              // anchor of the focused widget; empty: the viewport
    std::vector<KeyPress> presses;  // for the focused widget, since the last frame
    bool revealed = false;          // a key has moved the focus: the card scrolls to the focused widget
    bool shown = false;  // the focus ring is visible: from a key that moves or uses the focus until a click or Space

    // A widget that can have the focus, and its card. In the order of drawing.
    struct Stop {
        std::string id;
        int card = 0;
        TextInput text = TextInput::none;
    };
    // Of this frame and of the last one. Only the first `count` are valid; the others keep their memory.
    std::vector<Stop> stops, last_stops;
    std::size_t stop_count = 0, last_count = 0;
    int card = 0;
    bool held = false, was_held = false;  // a sheet is drawn, in this frame and in the last one
    bool left = false;                    // a click beside a text field of the sheet has taken its focus
    std::string focus_before;             // focus when the sheet was opened
    TextInput text = TextInput::none;     // of the focused widget in the last frame
    Rect field;                           // of the text field that was active last, window pixels
};

// Shows or hides the focus ring after a key.
void show_focus_for(Keyboard&, KeyPress);

// Handles Tab among the presses: focus to the next widget, with Shift to the previous one, with Ctrl to the next card.
// Clears the focus when its widget no longer exists. Call once before the widgets.
void begin_keyboard(Keyboard&);

// Discards the keys that no widget has used. Call once after the widgets.
void end_keyboard(Keyboard&);

// Call at the start of a sheet: only widgets drawn after the call can have the focus in this frame; the first of them
// gets it. After the last frame with a sheet, the focus before the sheet is restored. `keyboard` may be null.
void hold_keyboard(Keyboard*);

// Restores the focus before the sheet at once, for an action that then moves it. Call after end_keyboard(), when the
// sheet has closed. Does nothing if there was none.
void release_keyboard(Keyboard&);

// Begins the next card in the order of Ctrl+Tab.
void begin_stops(Keyboard*);

// Registers a widget that can have the focus. True when it has it. `keyboard` may be null.
bool stop_here(Keyboard*, std::string_view id);

// Marks the widget registered last as a text field. `has_cursor`: it is active; else it becomes active in one of the
// next frames. `keyboard` may be null.
void takes_text(Keyboard*, std::string_view id, bool has_cursor);

// Ends the input to the active text field if the mouse is pressed beside it in this frame, so that the widget under the
// pointer gets this press. Call before the widgets.
void end_text_by_press(const Keyboard&);

// Takes the focus from this widget, if it has it: no widget has it then, also in a sheet. `keyboard` may be null.
void leave(Keyboard*, std::string_view id);

// Removes and returns the first press of this key, with or without Shift and Ctrl; nullopt when there is none.
std::optional<KeyPress> take(Keyboard&, int key);

}  // namespace braitenlab::ui
