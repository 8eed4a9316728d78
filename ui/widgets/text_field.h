// One line of text that is typed. It takes the cursor as soon as it has the focus, and while it has it, keys are
// letters.
#pragma once

#include <string>
#include <string_view>

#include "ui/shortcuts.h"
#include "ui/widgets/ui.h"

namespace braitenlab {

struct TextField {
    std::string text;
    bool active = false;   // has the cursor
    bool entered = false;  // Enter was pressed in it; for one frame
    bool ask_enter = false;
};

// Draws it at the cursor, `width` window pixels wide; anchor `id`. Empty, it says `what` belongs into it.
void text_field(Ui&, TextField&, std::string_view id, float width, std::string_view what, std::string_view how);

// Keys while it has the cursor: Enter, Tab and arrows up and down are left to the keyboard's focus, letters come by
// Dear ImGui. True when the key is not to go anywhere else.
bool for_text_field(TextField&, KeyPress);

}  // namespace braitenlab
