// A menu bar: a row of titles, and the panel of the open menu below its title.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/shortcuts.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

struct MenuTitle {
    std::string_view name, words;  // "file"; anchor: menu.file
    std::string_view how;          // tooltip
    std::string keys{};
};

// A row of the open menu.
struct MenuEntry {
    std::string anchor, words, keys{};
    std::string how{};         // tooltip; of a disabled row: why it cannot be chosen now
    std::optional<bool> on{};  // of a switch or an option
    bool open = false;         // the row of the open file: a dot before it
    bool in_sight = false;     // the menu opens scrolled as far as it takes to show it
    bool enabled = true;
    bool heading = false;
    bool rule_above = false;
    bool stays_open = false;  // the menu stays open after the choice
};

struct MenuBarState {
    std::string open;               // name of the open menu; empty: none
    std::string drawn;              // name of the menu drawn in the last frame
    Rect panel;                     // of the open menu, window pixels
    std::vector<KeyPress> presses;  // for the rows of the open menu
};

// The height of the bar, layout pixels.
inline constexpr float menu_bar_height = 26;

// Draws the titles. A click on a title opens its menu.
void menu_titles(Ui&, MenuBarState&, std::span<const MenuTitle>, Rect bar);

// Draws the open menu over the window and returns the index of the chosen row, or −1. The panel has the anchor
// `menu.rows`; it scrolls if the window is too low for it, and opens at the row of the open file. Only its rows can
// have the keyboard focus. A click beside it closes it and does nothing else; the pointer over another title opens that
// menu. Call after everything it covers.
int menu_panel(Ui&, MenuBarState&, std::span<const MenuTitle>, std::span<const MenuEntry>, Rect bar, Rect window);

}  // namespace braitenlab::ui
