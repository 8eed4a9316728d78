// The one way a widget enters the window: it takes its place, records its anchor and says what mouse and keyboard do to
// it. How it looks is drawn over it.
#pragma once

#include <string_view>

#include <imgui.h>

#include "ui/widgets/ui.h"

namespace braitenlab {

struct Item {
    Rect rect;  // window pixels
    bool hovered = false;
    bool held = false;     // the left button went down on it and has not been let go
    bool pressed = false;  // clicked, or Enter while focused
    bool entered = false;  // pressed by Enter
    bool focused = false;  // has the keyboard
    bool enabled = true;
    int shown = -1;    // in Ui::shown
    float warmth = 0;  // 0..1: hovered or held, eased over 150 ms

    float middle_x() const { return rect.x + rect.w / 2; }
    float middle_y() const { return rect.y + rect.h / 2; }
    float right() const { return rect.x + rect.w; }
    float bottom() const { return rect.y + rect.h; }
};

// A widget at the cursor. A disabled one still shows its tooltip and answers to nothing else: so is a mere picture.
Item item(Ui&, std::string_view id, ImVec2 size, bool enabled = true);

// Records where something stands that cannot be pressed, and lets it pulse. Only the part inside the card counts.
void mark(Ui&, std::string_view id, Rect);

// Whether there is any use in putting a tooltip's words together in this frame.
inline bool wants_tooltip(const Ui& ui, const Item& item) { return (item.hovered && !item.held) || ui.shown; }

// Shows after a moment of hovering: what it is and, set apart, its shortcut.
void tooltip(Ui&, const Item&, std::string_view words, std::string_view shortcut = {});

// 0..1 moving towards `target`, kept by Dear ImGui under the id; arrives within `seconds`.
float eased(const Ui&, std::string_view id, float target, float seconds = 0.15f);

}  // namespace braitenlab
