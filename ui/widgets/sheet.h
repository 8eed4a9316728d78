// A sheet over the whole window, for what wants all the attention: a heading, a body that scrolls where the window is
// low, and a row of buttons that stays. While it is there the keyboard belongs to it.
#pragma once

#include <string_view>

#include "ui/widgets/ui.h"

namespace braitenlab {

// What a sheet remembers between frames.
struct SheetState {
    float content = 0;  // how high its body is, measured last frame, window pixels
    Rect rect;          // where it stands in this frame
};

// Begins the body, `layout_width` wide or as wide as the window allows; draw on at the cursor, card_width() wide. The
// anchor is `id`. Follow with sheet_buttons() and end_sheet(), always.
void begin_sheet(Ui&, SheetState&, std::string_view id, std::string_view heading, float layout_width, Rect window);

// Ends the body; buttons drawn from here on stand in a row at the bottom (ImGui::SameLine between them).
void sheet_buttons(Ui&, SheetState&);

// True when a click went beside the sheet, which is a way to say no.
bool end_sheet(const SheetState&);

}  // namespace braitenlab
