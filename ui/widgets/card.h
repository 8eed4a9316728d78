// A card over the scene: a heading that folds the card, and a body that scrolls when the card is too low for it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ui/widgets/paint.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

struct CardState {
    bool folded = false;
    bool opened_by_user = false;  // stays open when the column is too low for all cards
    bool was_open = false;        // in the last frame, in a column with all cards
    bool gave_way = false;        // the card that was folded last to make room for another one
    std::optional<float> head;    // height of the part above the body that does not scroll; unset: there is none
    float footer = 0;             // height of the part below the body that does not scroll, window pixels
    bool in_head = false, in_body = false;
    bool is_cut = false;  // in the last frame a part was higher than in the one before, which decides the card's height
    float content = 0;    // height of the body measured in the last frame, window pixels; 0: not yet measured
    std::string id, fold_id;  // anchors of card and heading, stored so that a frame allocates no memory
};

// The height of the card with all of its content, or of its heading when folded; window pixels.
float wanted_height(const Ui&, const CardState&);

// The height of a folded card.
float folded_height(const Ui&);

// A small button in a card's heading.
struct HeadingButton {
    std::string_view id, words, tooltip, shortcut{};
    bool on = false;  // a toggle that is on
    bool pressed = false, hovered = false;
    std::string_view icon{};  // replaces the words where the heading leaves no room for them
};

// Begins a card in this rectangle. Anchors: `id` and `id`.fold for its heading. False when it is folded: draw nothing
// then. Call end_card() in both cases. With CardState::head set, the head is begun: draw it, then call end_head().
bool begin_card(Ui&, CardState&, std::string_view id, std::string_view heading, Rect,
                std::span<HeadingButton> = {});  // from right to left
void end_card(const Ui&, CardState&);

// Ends the head, measures its height for the next frame, and begins the body.
void end_head(const Ui&, CardState&, Rect card);

// Begins the footer, below the part that scrolls. end_footer() measures its height for the next frame; before the first
// one set CardState::footer to its least height.
void begin_footer(Ui&, CardState&, Rect card);
void end_footer(const Ui&, CardState&);

// The background of a card: opaque, with border and shadow.
void card_ground(const Ui&, Rect, Corner = Corner::box);

// A window without heading and padding, for bars. With `covers_cards` it comes to the front in each frame.
void begin_bar(Ui&, const char* name, Rect, bool covers_cards = false, Corner = Corner::square);
void end_bar();

// A box with a border over the scene and behind the cards, for what is only drawn: the mouse reaches the scene through
// it.
void begin_overlay(const Ui&, const char* name, Rect, Colour border);
void end_overlay();

// card_width() of the card in this rectangle, also outside its body.
float card_width(const Ui&, Rect card);

// As wide as the card, at the cursor; `share` of it is filled. `below`: gap, layout pixels.
void progress_bar(const Ui&, float share, float below = 0);

// A vertical gap; a small heading within a card.
void gap(const Ui&, float layout_pixels);
void subheading(Ui&, std::string_view);

}  // namespace braitenlab::ui
