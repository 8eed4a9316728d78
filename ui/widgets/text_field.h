// A text field of one line. It is active while it has the focus: then keys type text. All of its text is selected when
// it becomes active, so that typing replaces a suggestion.
#pragma once

#include <string>
#include <string_view>

#include "ui/shortcuts.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

struct TextField {
    std::string text;
    bool active = false;   // receives text
    bool entered = false;  // Enter was pressed in it; for one frame
    bool ask_enter = false;
    bool ask_leave = false;  // Escape was pressed in a field of several lines
    bool drawn = false;      // in this frame
    bool is_masked = false;  // a sign stands for each letter; of a field of one line
    bool at_end = false;     // once it is active, the cursor is behind its text, of which nothing is selected
    bool is_new = false;     // its text was replaced from outside: an active field of several lines takes it over
};

// Draws a field of several lines at the cursor: it is `rows` lines high, a line that becomes too wide is broken at a
// space, and Enter begins a new line. Its text is not selected when it becomes active.
void text_area(Ui&, TextField&, std::string_view id, float width, int rows, std::string_view what,
               std::string_view how);

// Draws the field at the cursor, `width` window pixels wide; anchor `id`. An empty field shows `what`.
void text_field(Ui&, TextField&, std::string_view id, float width, std::string_view what, std::string_view how);

// Call at the end of a frame. False for a field that was not drawn in it: it receives no more text.
bool keep_drawn(TextField&);

// As for_text_field(), of a field of several lines: Enter, Up and Down are handled, too.
bool for_text_area(TextField&, KeyPress);

// Handles a key of an active field. Returns true if the key is handled. Enter, Tab, Up and Down are not handled here
// but by the keyboard focus; characters are received through Dear ImGui.
bool for_text_field(TextField&, KeyPress);

}  // namespace braitenlab::ui
