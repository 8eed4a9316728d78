// The size of the texts of a frame, and whether they are drawn completely.
#pragma once

#include <span>

#include "ui/widgets/ui.h"

namespace braitenlab::ui {

struct TextFacts {
    float smallest = 0;  // em of the smallest visible text, window pixels; 0 without text
    int clipped = 0;     // texts cut by their clip rectangle, or shortened with an ellipsis
};

// False for a text that is scrolled out of its card.
bool is_visible(const Written&);

// True if a part of a visible text is outside its clip rectangle. A line at the edge of a part that scrolls up and down
// is not cut.
bool is_cut(const Written&);

// `shortened`: counted by Ui::shortened.
TextFacts text_facts(std::span<const Written>, int shortened);

}  // namespace braitenlab::ui
