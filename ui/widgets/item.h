// The base of every widget: an invisible item that records its anchor and reads mouse and keyboard. The widget draws
// over it.
#pragma once

#include <string_view>

#include <imgui.h>

#include "ui/widgets/theme.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

struct Item {
    Rect rect;  // window pixels
    bool hovered = false;
    bool held = false;     // the left button went down on it and is still down
    bool pressed = false;  // clicked, or Enter while focused
    bool entered = false;  // pressed by Enter
    bool focused = false;  // has the keyboard focus
    bool enabled = true;
    int shown = -1;    // index in Ui::shown
    float warmth = 0;  // 0..1: hovered or held, eased over 150 ms

    float middle_x() const { return rect.x + rect.w / 2; }
    float middle_y() const { return rect.y + rect.h / 2; }
    float right() const { return rect.x + rect.w; }
    float bottom() const { return rect.y + rect.h; }
};

// The room between what a hint is about and the ring around it, layout pixels. A button has room of its own around its
// words; the words of a part that is not a widget, and those of a slider's row, begin at its edge.
struct RingRoom {
    float across, down;
    float before_sign = 0;  // of a heading with a sign at its right end: the width of the sign with its margin
};
inline constexpr RingRoom around_button{spacing::hair, spacing::hair}, around_words{spacing::small, spacing::tight},
    around_row{spacing::small, 0};

// A widget at the cursor. A disabled one only shows its tooltip; a picture is a disabled widget.
Item item(Ui&, std::string_view id, ImVec2 size, bool enabled = true, RingRoom = around_button);

// Records the anchor of a part that is not a widget, and highlights it. The anchor is clipped to the card.
void mark(Ui&, std::string_view id, Rect, RingRoom = around_words);

// What a hint is about: a wash over the rectangle, a ring that widens with Ui::pulse, and the light bulb of the hint
// bar at its upper right corner; a smaller bulb where it reaches the margin of its card, and before the sign of a
// heading. Beside a pin the bulb is outside of its node, below the number. Ring and bulb stay inside the card.
// The keyboard focus is a thin ring without a wash and a bulb.
void point_out(const Ui&, Rect, RingRoom = around_button);

// That light bulb; it may extend beyond the clip rectangle.
inline constexpr float hint_badge_radius = 9;  // layout pixels
void hint_badge(const Ui&, ImDrawList&, ImVec2 middle, float radius = hint_badge_radius);

// Scrolls the window being drawn by no more than it takes to show all between these two heights, window pixels, with
// room for a focus ring; a part that is too high is shown from its top.
void reveal(const Ui&, float top, float bottom);

// False if no tooltip is shown in this frame; its text need not be built then.
inline bool wants_tooltip(const Ui& ui, const Item& item) { return (item.hovered && !item.held) || ui.shown; }

// Words and shortcut, shown when the pointer has rested for 0.5 s, or at once if another tooltip was visible just
// before. Not shown from a key until the pointer moves: the key may have moved the widget below the pointer. Nor while
// the left button is down: what is dragged is watched. Covers neither the item nor Tooltips::kept_free where the window
// has room elsewhere. Anchor: tooltip.
void tooltip(Ui&, const Item&, std::string_view words, std::string_view shortcut = {});

// An eased value that moves to `target` (0..1) within `seconds`. Dear ImGui stores it under the id.
float eased(const Ui&, std::string_view id, float target, float seconds = 0.15f);

}  // namespace braitenlab::ui
