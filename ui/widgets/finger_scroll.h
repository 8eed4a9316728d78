// A finger that is moved up or down on a card, a sheet or a menu scrolls it, and presses nothing.
#pragma once

namespace braitenlab::ui {

struct Ui;

struct FingerScroll {
    unsigned part = 0;  // of Dear ImGui, in which the finger was set and that can be scrolled; 0: none
    bool moves = false;
};

// Call once in a frame, before the widgets; does nothing while Ui::finger is 0. `free`: the finger drags nothing.
void scroll_by_finger(FingerScroll&, const Ui&, bool free);

}  // namespace braitenlab::ui
