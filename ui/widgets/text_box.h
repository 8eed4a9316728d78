// What the text fields of one line and of several lines have in common; for text_field.cpp and text_area.cpp.
#pragma once

#include <string_view>

#include <imgui.h>

#include "ui/widgets/card.h"
#include "ui/widgets/text_field.h"

namespace braitenlab::ui {

struct TextBox {
    std::string_view id;
    Rect box;              // window pixels
    ImVec2 pad;            // between frame and text
    bool focused = false;  // has the keyboard focus of this frame
    bool clicked = false;  // was clicked in this frame
};

// Right after the input of Dear ImGui: it and the keyboard focus agree about which field is active.
void settle_focus(Ui&, TextField&, const TextBox&);

// Draws the frame and, in an empty field, `what`; records the anchor and shows the tooltip `how`.
void finish_text_box(Ui&, TextField&, const TextBox&, std::string_view what, std::string_view how);

}  // namespace braitenlab::ui
