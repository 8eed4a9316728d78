// Buttons, toggles, choices and chips.
#pragma once

#include <span>
#include <string_view>

#include "ui/widgets/item.h"
#include "ui/widgets/ui.h"

namespace braitenlab {

enum class Emphasis { primary, plain, quiet };  // filled with the accent; raised with a line; bare until hovered

struct ButtonLook {
    std::string_view icon, words;  // words may be left out when the icon font is there
    Emphasis emphasis = Emphasis::plain;
    bool on = false;  // a toggle that is on
    bool enabled = true;
    float min_width = 0;   // layout pixels
    bool compact = false;  // smaller words and less air, for bars that have little room
};

inline constexpr float button_height = 32;  // layout pixels

float button_width(const Ui&, const ButtonLook&);
Item button(Ui&, std::string_view id, const ButtonLook&);

// A slim quiet button of one line of small words, for the captions of a card.
struct SmallButton {
    std::string_view id, icon, words;
    bool on = false;
};
inline constexpr float small_button_height = 22;                      // layout pixels
float small_button_width(const Ui&, const SmallButton&, bool words);  // without words: the icon alone
Item small_button(Ui&, const SmallButton&, bool words = true);

// One of a few, side by side, filling `width`: the index clicked, or −1. Anchors: `id`.1, `id`.2 …
int segments(Ui&, std::string_view id, std::span<const std::string_view> words, int chosen, float width,
             std::string_view how = {});

// One of a list, each a row of wrapped words. True when clicked.
bool radio_row(Ui&, std::string_view id, std::string_view words, bool chosen, bool enabled, std::string_view how = {});

// A line with an angle that opens what follows; returns whether it is open.
bool fold_row(Ui&, std::string_view id, std::string_view words, bool& open, std::string_view how = {});

// A word in a rounded box, with the middle of its left side at `at`.
void chip(const Ui&, ImVec2 at, std::string_view words);
float chip_width(const Ui&, std::string_view words);

}  // namespace braitenlab
