#include "render/text/set_type.h"

#include <algorithm>
#include <cmath>

namespace braitenlab::render {

void set_type(std::vector<LetterInstance>& letters, const std::vector<Label>& labels, Lettering& lettering,
              const Picture& picture, LabelSpace space) {
    constexpr float grown = Lettering::room;
    letters.clear();
    std::vector<const Label*> in_order;
    for (const Label& label : labels) in_order.push_back(&label);
    std::stable_sort(in_order.begin(), in_order.end(), [](auto* a, auto* b) { return a->rank < b->rank; });
    for (const Rect& covered : picture.covered) space.take(covered);
    const Rect& window = picture.camera_view.window;
    const auto height = static_cast<float>(lettering.pixels());
    for (const Label* label : in_order) {
        const SetLine line = set_line(lettering, label->text);
        const maths::vec2 half{static_cast<float>(line.width) / 2, static_cast<float>(lettering.cap_height()) / 2};
        float left = 0, base = 0;
        const auto fits = [&](const LabelSpot& spot) {
            const auto at = project(picture.camera_view, label->place, spot.height);
            if (!at) return false;
            const maths::vec2 middle = *at + spot.offset * picture.pixel_scale;
            if (!window.contains(middle)) return false;
            // Half the extent of the text in the direction `away`, so that the text does not cover its position.
            const float reach = std::fabs(spot.away.x) * half.x + std::fabs(spot.away.y) * half.y;
            const maths::vec2 centre = middle + spot.away * reach;
            left = std::round(centre.x - half.x), base = std::round(centre.y + half.y);
            const Rect box{left - 3, base - height, static_cast<float>(line.width) + 6, height * 1.3f};
            if (!space.is_free(box)) return false;
            space.take(box);
            return true;
        };
        if (!fits({label->height, label->offset, label->away}) &&
            std::none_of(label->elsewhere.begin(), label->elsewhere.end(), fits))
            continue;
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
