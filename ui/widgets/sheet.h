// A sheet over the whole window: a heading, a body that scrolls in a low window, and a row of buttons. While it is
// open, only its widgets can have the keyboard focus.
#pragma once

#include <string_view>

#include "ui/widgets/ui.h"

namespace braitenlab::ui {

struct SheetState {
    float content = 0;        // height of its body in the last frame, window pixels; decides its height in the next one
    float fixed = 0;          // of the body, which scrolls where it has more; window pixels, 0: as high as its content
    float footer = 0;         // of what stands between body and buttons, window pixels; likewise
    bool is_resized = false;  // in the last frame one of these had another height than in the one before
    Rect rect;                // in this frame
    float scroll = 0;         // requested by keys, in pages of its body; carried out in the next frame
};

// Begins the body, `layout_width` layout pixels wide or as wide as the window; its content is card_width() wide. The
// anchor is `id`. Follow with sheet_buttons() and end_sheet().
void begin_sheet(Ui&, SheetState&, std::string_view id, std::string_view heading, float layout_width, Rect window);

// Ends the body and begins the row of buttons at the bottom (ImGui::SameLine between them). `problem`: what is wrong,
// above the buttons, where it does not scroll.
void sheet_buttons(Ui&, SheetState&, std::string_view problem = {});

// True after a click beside the sheet; the caller then cancels the sheet.
bool end_sheet(const SheetState&);

}  // namespace braitenlab::ui
