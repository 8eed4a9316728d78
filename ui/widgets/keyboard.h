// Who has the keyboard: one widget, by its anchor, or the viewport. Dear ImGui's own keyboard navigation stays off:
// Space would press buttons there, and 1.86 loses keys that go down and up within a frame.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/shortcuts.h"

namespace braitenlab {

// What is typed goes into a text field that has the cursor, or into one that is about to have it.
enum class TextInput { none, awaited, open };

struct Keyboard {
    std::string focus;              // the anchor that has the focus; empty: the viewport has it
    std::vector<KeyPress> presses;  // for the focused widget, since the last frame
    bool revealed = false;          // the focus moved by a key: its card scrolls to it
    bool shown = false;             // a ring says who has it: from a key that moves or uses it to a click or Space

    // A widget that can have the focus, in the order of drawing, and the card that it is on.
    struct Stop {
        std::string id;
        int card = 0;
        TextInput text = TextInput::none;
    };
    // This frame's and the last one's; those beyond the count are spent, and keep their memory for the next frame.
    std::vector<Stop> stops, last_stops;
    std::size_t stop_count = 0, last_count = 0;
    int card = 0;
    bool held = false, was_held = false;  // by a sheet, in this frame and in the last one
    std::string focus_before;             // who had it when the sheet came
    TextInput text = TextInput::none;     // of the focused widget, when the last frame had been drawn
};

// Whether the focus is shown after this key.
void show_focus_for(Keyboard&, KeyPress);

// Moves the focus for the Tabs among the presses: to the next widget, with Shift to the previous one, with Ctrl to the
// next card. Forgets a focus whose widget is gone. Call once before the widgets.
void begin_keyboard(Keyboard&);

// Forgets the keys that no widget wanted. Call once after the widgets.
void end_keyboard(Keyboard&);

// Only widgets drawn from here on can have the focus in this frame: a sheet lies over the others. Its first widget gets
// it, and whoever had it before gets it back when no sheet is drawn any more. `keyboard` may be null.
void hold_keyboard(Keyboard*);

// Widgets drawn from here on belong to another card.
void begin_stops(Keyboard*);

// The widget can have the focus; true when it has it. `keyboard` may be null.
bool stop_here(Keyboard*, std::string_view id);

// The widget that just became a stop takes text: it has the cursor, or will in one of the next frames. `keyboard` may
// be null.
void takes_text(Keyboard*, std::string_view id, bool has_cursor);

// Takes the first press of this key away, with or without Shift and Ctrl. Nothing when it was not pressed.
std::optional<KeyPress> take(Keyboard&, int key);

}  // namespace braitenlab
