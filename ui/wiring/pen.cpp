#include "ui/wiring/pen.h"

#include <algorithm>

#include "ui/imgui_compat.h"
#include "ui/theme.h"

namespace braitenlab {

using maths::vec2;

float Pen::stroke(float units) const { return std::max(size(units), ui.px(0.75f)); }

void Pen::text(vec2 unit, float height, float anchor, std::string_view words, Colour colour, Face face) const {
    const float pixels = size(height);
    if (pixels < ui.px(5) || words.empty()) return;
    // The face loaded nearest above the wanted size stays sharp.
    ImFont* chosen = font(ui, face == Face::text && pixels > ui.px(18) ? Face::title : face);
    const char* end = words.data() + words.size();
    const float width = chosen->CalcTextSizeA(pixels, 1e9f, 0, words.data(), end).x;
    const ImVec2 p = at(unit);
    list.AddText(chosen, pixels, {std::round(p.x - width * anchor), std::round(p.y - pixels / 2)}, paint(colour),
                 words.data(), end);
}

float Pen::text_width(float height, std::string_view words, Face face) const {
    return font(ui, face)->CalcTextSizeA(size(height), 1e9f, 0, words.data(), words.data() + words.size()).x /
           view.scale;
}

void Pen::box(vec2 centre, vec2 extent, float rounding, Colour colour) const {
    list.AddRectFilled(at(centre - extent / 2), at(centre + extent / 2), paint(colour), size(rounding));
}

void Pen::frame(vec2 centre, vec2 extent, float rounding, float thickness, Colour colour) const {
    compat::outline(list, at(centre - extent / 2), at(centre + extent / 2), paint(colour), size(rounding),
                    stroke(thickness));
}

void Pen::halo(vec2 centre, vec2 extent, float rounding, float reach, Colour colour) const {
    constexpr int layers = 8;
    for (int i = layers; i > 0; --i) {
        const float grow = reach * static_cast<float>(i) / layers;
        box(centre, extent + vec2{2 * grow, 2 * grow}, rounding + grow, colour.with_alpha(colour.a * 1.6f / layers));
    }
}

}  // namespace braitenlab
