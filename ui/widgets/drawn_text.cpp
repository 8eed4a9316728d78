#include "ui/widgets/drawn_text.h"

#include <algorithm>

namespace braitenlab::ui {

namespace {

constexpr float tolerance = 0.75f;     // window pixels
constexpr float line_spacing = 0.18f;  // of the height of a line, above and below its letters

}  // namespace

bool is_visible(const Written& w) {
    const float letters = w.rect.h * line_spacing;
    return w.clip.overlaps({w.rect.x, w.rect.y + letters, w.rect.w, w.rect.h - 2 * letters});
}

bool is_cut(const Written& w) {
    if (!is_visible(w)) return false;
    if (w.rect.x < w.clip.x - tolerance || w.rect.x + w.rect.w > w.clip.x + w.clip.w + tolerance) return true;
    // The first and the last line of the text have the spacing of one line.
    const float letters = std::min(w.rect.h, 1.4f * w.size) * line_spacing + tolerance;
    return !w.scrolls && (w.rect.y + letters < w.clip.y || w.rect.y + w.rect.h - letters > w.clip.y + w.clip.h);
}

TextFacts text_facts(std::span<const Written> written, int shortened) {
    TextFacts facts{.clipped = shortened};
    for (const Written& w : written) {
        if (!is_visible(w)) continue;
        if (facts.smallest == 0 || w.size < facts.smallest) facts.smallest = w.size;
        facts.clipped += is_cut(w);
    }
    return facts;
}

}  // namespace braitenlab::ui
