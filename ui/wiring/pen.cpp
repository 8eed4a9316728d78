#include "ui/wiring/pen.h"

#include <algorithm>

#include "ui/imgui_compat.h"
#include "ui/theme.h"

namespace braitenlab {

using maths::vec2;

float Pen::stroke(float units) const { return std::max(size(units), ui.px(0.75f)); }

namespace {

struct Type {
    ImFont* font;
    float pixels;
};

// The loaded font nearest to the wanted size; at its own size where that is near enough, since letters that are scaled
// by a little look worn. A bold face stays bold.
Type type_for(const Ui& ui, Face face, float pixels) {
    const bool bold = face == Face::strong || face == Face::title;
    const Face choices[2] = {bold ? Face::strong : Face::small, bold ? Face::title : Face::text};
    for (const Face choice : choices) {
        ImFont* loaded = font(ui, choice);
        const float own = compat::size_of(loaded);
        if (pixels < own * 0.9f) return {loaded, pixels};
        if (pixels < own * 1.13f) return {loaded, own};
    }
    return {font(ui, Face::title), pixels};
}

}  // namespace

void Pen::text(vec2 unit, float height, float anchor, std::string_view words, Colour colour, Face face,
               float room) const {
    constexpr float least = 6;  // layout pixels
    if (words.empty() || size(height) < ui.px(least)) return;
    Type type = type_for(ui, face, size(height));
    const char* end = words.data() + words.size();
    float width = type.font->CalcTextSizeA(type.pixels, 1e9f, 0, words.data(), end).x;
    if (room > 0 && width > size(room)) {
        type.pixels *= size(room) / width;
        width = size(room);
    }
    if (type.pixels < ui.px(least)) return;
    const ImVec2 p = at(unit);
    list.AddText(type.font, type.pixels, {std::round(p.x - width * anchor), std::round(p.y - type.pixels / 2)},
                 paint(colour), words.data(), end);
}

void Pen::box(vec2 centre, vec2 extent, float rounding, Colour colour) const {
    list.AddRectFilled(at(centre - extent / 2), at(centre + extent / 2), paint(colour), size(rounding));
}

void Pen::frame(vec2 centre, vec2 extent, float rounding, float thickness, Colour colour) const {
    compat::outline(list, at(centre - extent / 2), at(centre + extent / 2), paint(colour), size(rounding),
                    stroke(thickness));
}

void Pen::halo(vec2 centre, vec2 extent, float rounding, float reach, Colour colour) const {
    // A layer every other pixel or so: more cannot be told apart.
    const int layers = std::clamp(static_cast<int>(size(reach) / ui.px(1.5f)), 2, 8);
    const auto count = static_cast<float>(layers);
    for (int i = layers; i > 0; --i) {
        const float grow = reach * static_cast<float>(i) / count;
        box(centre, extent + vec2{2 * grow, 2 * grow}, rounding + grow, colour.with_alpha(colour.a * 1.6f / count));
    }
}

}  // namespace braitenlab
