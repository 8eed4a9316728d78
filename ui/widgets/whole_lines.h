// Lines of text at the edges of a part that scrolls: a line whose letters an edge would cut is not drawn.
#pragma once

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

}  // namespace braitenlab::ui
