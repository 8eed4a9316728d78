// The fields of ui/panels/card_table.def, which has one row per card. Layout, folding, lectures and Reset All are
// derived from this table.
#pragma once

#include <span>
#include <string_view>

#include "ui/lab_view.h"
#include "ui/panels/panel_state.h"
#include "ui/widgets/card.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

enum class Column { left, right, none };  // none: the window sets the rectangle of the card

// The effect of a lecture on the state of a card. restored: the state at the start is restored at the end. folded: as
// restored, and the card is folded at the start. In a lecture a folded card is only as wide as its heading.
enum class InLecture { unchanged, restored, folded };

struct CardTraits {
    Card card;
    void (*draw)(const LabView&, PanelState&, Ui&, Rect place, Rect rest) = nullptr;  // null: the window draws it
    std::string_view anchor;   // "card.brain"; its heading has the anchor "card.brain.fold"
    std::string_view heading;  // string key; empty: the card draws its heading
    Column column = Column::none;
    InLecture in_lecture = InLecture::unchanged;
    bool folded = false;  // at first and after Reset All

    bool (*shown)(const LabView&) = nullptr;

    // Heights in a column. The cards of a column share it from top to bottom, in the order of the table. No card leaves
    // it: where the least heights of all exceed it, the largest of them are cut, but not that of a first card with
    // keeps_least.
    float most = 1;         // at most this share of the column; below 1: not squeezed by cards below
    float least = 96;       // layout pixels; minimum height beside the other cards, while it is open
    float least_share = 0;  // the same as a share of the column
    bool keeps_least = false;
    bool folds_when_cramped = false;  // folded while the column is too low, unless the user has opened it
};

// In the order of Card.
std::span<const CardTraits> cards();
const CardTraits& traits(Card);

// Cuts the largest heights to one height, at least `floor`, so that the sum is at most `room`.
void cut_to_fit(std::span<float> heights, float floor, float room);

// Draws the visible cards of a column, and above them its guests: cards of the other column that have no room there.
using IsGuest = bool (*)(const CardTraits&);
void draw_column(Column, const LabView&, PanelState&, Ui&, Rect, IsGuest = nullptr);

// begin_card() with state, anchor and heading of the table's row; `heading` replaces the row's. Follow with end_card().
bool open_card(PanelState&, Ui&, Card, Rect place, std::span<HeadingButton> = {}, std::string_view heading = {});

// Resets the folds of all cards to their initial state.
void reset_cards(PanelState&);

}  // namespace braitenlab::ui
