// A text field of one line. It is active while it has the focus; keys are then text.
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
};

// Draws it at the cursor, `width` window pixels wide; anchor `id`. While empty it shows `what`.
void text_field(Ui&, TextField&, std::string_view id, float width, std::string_view what, std::string_view how);

// Keys of an active field. Enter, Tab, Up and Down are left to the focus; characters come through Dear ImGui. True when
// the key is handled.
bool for_text_field(TextField&, KeyPress);

}  // namespace braitenlab::ui
