// The context of every widget: palette, fonts and scale, the anchors, and the outbox for requests.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "render/view/palette.h"
#include "ui/request.h"
#include "ui/widgets/anchors.h"

struct ImDrawCmd;
struct ImDrawList;
struct ImFont;

namespace braitenlab {

class Strings;  // ui/words/strings.h

namespace ui {

struct Keyboard;  // ui/widgets/keyboard.h

// A callback of Dear ImGui's drawing: fills the clip rectangle of the command with the opaque colour that its
// UserCallbackData is (ImU32), faster than triangles do.
using FillClip = void(const ImDrawList*, const ImDrawCmd*);

// Null: Dear ImGui's current font.
struct Fonts {
    ImFont* text = nullptr;     // 16 px em, times scale
    ImFont* title = nullptr;    // 20 px, bold
    ImFont* strong = nullptr;   // 16 px, bold
    ImFont* display = nullptr;  // 48 px, bold: figures of a lecture; letters and digits only
    ImFont* small = nullptr;    // 14 px: second lines, tooltips, small buttons
    ImFont* label = nullptr;    // 12 px: names in diagrams and beside the axes of charts
    ImFont* caption = nullptr;  // 28 px, bold: captions of a lecture; without icons
};

// A text as drawn in this frame, for tests that find clipped and overlapping texts.
struct Written {
    std::string words;
    Rect rect, clip;         // window pixels
    const void* sheet = {};  // equal for texts on the same draw list
    float size = 0;          // em, window pixels
    bool scrolls = false;    // in a part of a card that can be scrolled up and down
};

// A widget as drawn in this frame, for tests that find missing tooltips and small targets.
struct Shown {
    std::string id;
    bool has_tooltip = false;
    Rect rect{};  // window pixels; not clipped to its card
    bool enabled = true;
};

// When tooltips are due: a pointer rests, or another tooltip was visible just before. And what they do not cover.
struct Tooltips {
    double moved_at = 0;   // ImGui::GetTime() of the pointer's last movement
    double shown_at = -1;  // and of the last frame with a tooltip
    bool hidden = false;   // since a key or the left button was pressed, until the pointer moves
    Rect kept_free;        // the selected vehicle as seen in the scene, window pixels; empty: none
};

// Where the ring and the light bulb of a hint are, window pixels.
struct PointedOut {
    Rect ring, bulb;
};

struct Ui {
    const Strings& strings;
    Palette palette;
    Fonts fonts;
    float scale = 1;  // window pixels per layout pixel; every size in code is in layout pixels
    Anchors& anchors;
    Outbox& outbox;
    std::string_view highlight;               // anchor of the widget that pulses; empty: none
    float pulse = 0;                          // strength of the highlight, 0..1; 1 where motion is reduced
    Keyboard* keyboard = nullptr;             // set by draw_window; null: widgets react to the mouse only
    bool still = false;                       // set by draw_window; true: no easing
    bool quiet = false;                       // set by draw_window; true: no tooltips
    float least_type = 0;                     // set by draw_window; least height of letters in diagrams, window pixels
    float finger = 0;                         // set by draw_window; height that a finger needs; 0: the mouse is used
    char decimal_mark = '.';                  // set by draw_window; of the language
    std::vector<Written>* written = nullptr;  // null: not recorded
    bool* reveals = nullptr;                  // true until the card has scrolled to `highlight`; null: it does not
    int* shortened = nullptr;                 // null: not counted; texts that were cut with an ellipsis
    std::vector<Shown>* shown = nullptr;      // null: not recorded
    std::vector<Rect>* opaque = nullptr;      // null: not recorded; what cards, bars and sheets cover, window pixels
    PointedOut* pointed_out = nullptr;        // null: not recorded
    FillClip* fill_clip = nullptr;            // null: triangles fill large boxes, too
    Tooltips* tooltips = nullptr;             // set by draw_window; null: each waits for itself

    // Layout pixels to window pixels.
    float px(float layout_pixels) const { return layout_pixels * scale; }
    // The height of a control, and the width of one that shows a sign only, in layout pixels: as given for the mouse,
    // enough for a finger while one is used. Every widget takes its height from here.
    float tall(float layout_pixels) const { return std::max(layout_pixels, finger); }
};

}  // namespace ui

}  // namespace braitenlab
