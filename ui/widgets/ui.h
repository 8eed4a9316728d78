// What every panel gets: how it should look, where to record its widgets and where to put what the person wants.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "render/view/palette.h"
#include "ui/request.h"
#include "ui/widgets/anchors.h"

struct ImFont;

namespace braitenlab {

class Strings;    // ui/strings.h: words by key
struct Keyboard;  // ui/widgets/keyboard.h: who has the focus

// Null stands for Dear ImGui's current font.
struct Fonts {
    ImFont* text = nullptr;     // 16 px times scale
    ImFont* title = nullptr;    // 1.35 times that, bold
    ImFont* strong = nullptr;   // the size of text, bold
    ImFont* display = nullptr;  // 2.6 times text, bold: letters and figures alone
    ImFont* small = nullptr;    // captions and figures, 0.85 times text
};

// Words as they were put on the screen, for tests that look for clipped and colliding ones.
struct Written {
    std::string words;
    Rect rect, clip;         // window pixels
    const void* sheet = {};  // the same for words that lie on one sheet
};

// A widget as it was drawn, for tests that look for one that does not explain itself.
struct Shown {
    std::string id;
    bool has_tooltip = false;
};

struct Ui {
    const Strings& strings;
    Palette palette;
    Fonts fonts;
    float scale = 1;  // layout pixels to window pixels: every size in code is times this
    Anchors& anchors;
    Outbox& outbox;
    std::string_view highlight;    // the anchor that pulses; empty for none
    float pulse = 0;               // 0..1, how strong the highlight stands now; steady 1 where motion is reduced
    Keyboard* keyboard = nullptr;  // draw_window sets it; null: widgets answer to the mouse alone
    bool still = false;            // draw_window sets it: no easing, everything is at once where it is going
    std::vector<Written>* written = nullptr;  // null: nobody wants to know
    std::vector<Shown>* shown = nullptr;      // the same

    // px of the layout's 8 px grid in window pixels.
    float px(float layout_pixels) const { return layout_pixels * scale; }
};

}  // namespace braitenlab
