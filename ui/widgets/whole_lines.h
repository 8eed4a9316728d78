// The edges of a part that scrolls: a line of text whose letters an edge would cut is not drawn, and a shade tells that
// there is more.
#pragma once

#include "ui/widgets/ui.h"

namespace braitenlab::ui {

// Narrows the clip rectangle to whole lines until the end of the scope. Without effect where the part does not scroll.
class WholeLines {
public:
    // `top` of the text's first line, `line` the height of each; window pixels.
    WholeLines(float top, float line);
    ~WholeLines();
    WholeLines(const WholeLines&) = delete;
    WholeLines& operator=(const WholeLines&) = delete;

private:
    bool narrowed_ = false;
};

// Shades the upper and lower edge of the current part with the colour of the panel where content lies beyond it. Call
// after the contents.
void shade_edges(const Ui&);

}  // namespace braitenlab::ui
