// A quiet card over the scene: a heading that folds it, and what it holds, which scrolls where the window is too low.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "ui/widgets/ui.h"

namespace braitenlab {

struct CardState {
    bool folded = false;
    float footer = 0;  // window pixels kept at the bottom for what must stay in sight
    bool in_body = false;
    float content = 0;        // how high everything in it is, measured last frame, window pixels; 0 before the first
    std::string id, fold_id;  // of the card and its heading, spelled once and not in every frame
};

// The height that the card wants, heading and borders included.
float wanted_height(const Ui&, const CardState&);

// The height of a folded card.
float folded_height(const Ui&);

// A quiet button in a card's heading.
struct HeadingButton {
    std::string_view id, words, tooltip, shortcut{};
    bool on = false;  // a toggle that is on
    bool pressed = false, hovered = false;
};

// Opens the card in this rectangle; anchors: `id` for all of it, `id`.fold for its heading. When false, nothing may be
// drawn in it (it is folded); end_card is called either way.
bool begin_card(Ui&, CardState&, std::string_view id, std::string_view heading, Rect,
                std::span<HeadingButton> = {});  // from right to left
void end_card(CardState&);

// What is drawn from here on stands in the footer, below the part that scrolls. Set CardState::footer beforehand.
void begin_footer(Ui&, CardState&, Rect card);

// The card's ground alone: panel colour at 92 %, a line around, a soft shadow.
void card_ground(const Ui&, Rect, float layout_rounding = 6);

// A plain window without a card's heading, for bars: its cursor starts at the rectangle's corner, without padding.
// One that covers the cards comes to the front each frame.
void begin_bar(Ui&, const char* name, Rect, bool covers_cards = false, float layout_rounding = 0);
void end_bar();

// The width between the card's paddings, where the scrollbar is not.
float card_width(const Ui&);

// A little space, and a quiet heading within a card.
void gap(const Ui&, float layout_pixels);
void subheading(Ui&, std::string_view);

}  // namespace braitenlab
