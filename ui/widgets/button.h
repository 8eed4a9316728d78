// Buttons, toggles, choices and chips.
#pragma once

#include <initializer_list>
#include <span>
#include <string_view>

#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

enum class Emphasis { primary, plain, quiet };  // filled with the accent; raised with a border; no border until hovered

struct ButtonLook {
    std::string_view icon, words;  // words may be empty when the icon font is loaded
    Emphasis emphasis = Emphasis::plain;
    bool on = false;  // a toggle that is on
    bool enabled = true;
    float min_width = 0, min_height = 0;  // layout pixels
    bool compact = false;                 // smaller words and gaps
};

inline constexpr float button_height = 32;  // layout pixels

float button_width(const Ui&, const ButtonLook&);

// For ButtonLook::min_width of a button whose words change among these strings: what is beside it stays in its place.
float least_width_for(const Ui&, ButtonLook, std::initializer_list<std::string_view> keys);

Item button(Ui&, std::string_view id, const ButtonLook&);
// The same with its tooltip, and the key that does what it does. True when it is pressed.
bool push_button(Ui&, std::string_view id, const ButtonLook&, std::string_view how, std::string_view shortcut = {});

// A small button with one line of small words.
struct SmallButton {
    std::string_view id, icon, words;
    bool on = false;
};
inline constexpr float small_button_height = 24;                      // layout pixels
float small_button_width(const Ui&, const SmallButton&, bool words);  // without words: the icon only
Item small_button(Ui&, const SmallButton&, bool words = true);
bool small_push_button(Ui&, const SmallButton&, std::string_view how, std::string_view shortcut = {});

// Puts a widget of this width to the right of the last one, or below it where it would pass `right`; window pixels.
void beside_or_below(const Ui&, float width, float right);

// A choice of a few words, side by side, `width` window pixels wide, each part as wide as the others if its word fits.
// The index clicked, or −1. Anchors: `id`.1, `id`.2 …
int segments(Ui&, std::string_view id, std::span<const std::string_view> words, int chosen, float width,
             std::string_view how = {});

// An option of a list: a row of wrapped words. True when clicked.
// `key`: of the key that presses it, shown as a cap at the right end.
bool radio_row(Ui&, std::string_view id, std::string_view words, bool chosen, bool enabled, std::string_view how = {},
               std::string_view key = {});

// A key cap; `at`: the middle of its left edge. Returns its width.
float key_cap(const Ui&, ImVec2 at, std::string_view words, Face = Face::small);
float key_cap_width(const Ui&, std::string_view words, Face = Face::small);

// A row that folds and unfolds the part below it. Returns true if the part is open.
bool fold_row(Ui&, std::string_view id, std::string_view words, bool& open, std::string_view how = {});

// A word in a rounded box; `at` is the middle of its left side.
void chip(const Ui&, ImVec2 at, std::string_view words);
float chip_width(const Ui&, std::string_view words);

}  // namespace braitenlab::ui
