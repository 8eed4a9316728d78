#include "render/text/set_type.h"

#include <algorithm>
#include <cmath>

namespace braitenlab::render {

namespace {

bool overlap(const Rect& a, const Rect& b) {
    return a.x < b.x + b.w && b.x < a.x + a.w && a.y < b.y + b.h && b.y < a.y + a.h;
}

}  // namespace

void set_type(std::vector<LetterInstance>& letters, const std::vector<Label>& labels, Lettering& lettering,
              const Picture& picture) {
    constexpr float grown = Lettering::room;
    letters.clear();
    std::vector<const Label*> in_order;
    for (const Label& label : labels) in_order.push_back(&label);
    std::stable_sort(in_order.begin(), in_order.end(), [](auto* a, auto* b) { return a->rank < b->rank; });
    std::vector<Rect> taken = picture.covered;
    const Rect& window = picture.camera_view.window;
    for (const Label* label : in_order) {
        const auto at = project(picture.camera_view, label->place, label->height);
        if (!at) continue;
        const maths::vec2 middle = *at + label->offset * picture.pixel_scale;
        if (!window.contains(middle.x, middle.y)) continue;
        const SetLine line = set_line(lettering, label->text);
        // Half the extent of the text in the direction `away`, so that the text does not cover its position.
        const maths::vec2 half{static_cast<float>(line.width) / 2, static_cast<float>(lettering.cap_height()) / 2};
        const float reach = std::fabs(label->away.x) * half.x + std::fabs(label->away.y) * half.y;
        const maths::vec2 centre = middle + label->away * reach;
        const float left = std::round(centre.x - half.x), base = std::round(centre.y + half.y);
        const auto height = static_cast<float>(lettering.pixels());
        const Rect box{left - 3, base - height, static_cast<float>(line.width) + 6, height * 1.3f};
        if (std::any_of(taken.begin(), taken.end(), [&](const Rect& other) { return overlap(box, other); })) continue;
        taken.push_back(box);
        for (const auto& [glyph, x] : line.characters) {
            if (glyph.width == 0) continue;
            letters.push_back(
                {{left + static_cast<float>(x + glyph.left) - grown, base + static_cast<float>(glyph.top) - grown,
                  static_cast<float>(glyph.width) + 2 * grown, static_cast<float>(glyph.height) + 2 * grown},
                 {static_cast<float>(glyph.x) - grown, static_cast<float>(glyph.y) - grown, 0, 0},
                 {label->colour.r, label->colour.g, label->colour.b, label->colour.a}});
        }
    }
}

}  // namespace braitenlab::render
