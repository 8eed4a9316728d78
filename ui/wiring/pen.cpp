#include "ui/wiring/pen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/maths/portable.h"
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

// As many of the characters as fit, and "…" for the rest.
template <class Fits>
std::string fitted(std::string_view words, Fits fits) {
    std::string text(words);
    while (!fits(text) && !words.empty()) {
        bool inside = true;  // a character of several bytes goes as a whole
        while (inside && !words.empty()) {
            inside = (static_cast<unsigned char>(words.back()) & 0xC0U) == 0x80U;
            words.remove_suffix(1);
        }
        text = std::string(words) + "…";
    }
    return text;
}

}  // namespace

void Pen::text(vec2 unit, float height, float anchor, std::string_view words, Colour colour, Face face,
               float room) const {
    if (words.empty() || size(height) < ui.px(too_small)) return;
    const float least = ui.px(least_type);
    Type type = type_for(ui, face, std::max(size(height), least));
    const auto width_of = [&](std::string_view part) {
        return type.font->CalcTextSizeA(type.pixels, 1e9f, 0, part.data(), part.data() + part.size()).x;
    };
    float width = width_of(words);
    std::string shortened;
    if (room > 0 && width > size(room)) {
        const float fitting = type.pixels * size(room) / width;
        if (fitting < least && face == Face::small) return;  // a caption that cannot be read only dirties the card
        type.pixels = std::max(fitting, ui.px(least_name));
        shortened = fitted(words, [&](std::string_view part) { return width_of(part) <= size(room) + 1; });
        words = shortened;
        width = width_of(words);
    }
    const ImVec2 p = at(unit);
    list.AddText(type.font, type.pixels, {std::round(p.x - width * anchor), std::round(p.y - type.pixels / 2)},
                 paint(colour), words.data(), words.data() + words.size());
}

void Pen::box(vec2 centre, vec2 extent, float rounding, Colour colour) const {
    list.AddRectFilled(at(centre - extent / 2), at(centre + extent / 2), paint(colour), size(rounding));
}

void Pen::frame(vec2 centre, vec2 extent, float rounding, float thickness, Colour colour) const {
    compat::outline(list, at(centre - extent / 2), at(centre + extent / 2), paint(colour), size(rounding),
                    stroke(thickness));
}

namespace {

constexpr int corner_steps = 6;  // of a quarter circle
constexpr int rim_points = 4 * (corner_steps + 1);

// Directions of a rounded box's rim from its corners' middles, clockwise from the right.
const std::array<ImVec2, rim_points>& rim() {
    static const std::array<ImVec2, rim_points> points = [] {
        std::array<ImVec2, rim_points> made;
        for (int i = 0; i < rim_points; ++i) {
            const int quarter = i / (corner_steps + 1), step = i % (corner_steps + 1);
            const float turn = (static_cast<float>(quarter) + static_cast<float>(step) / corner_steps) * maths::pi / 2;
            made[static_cast<std::size_t>(i)] = {maths::cosine(turn), maths::sine(turn)};
        }
        return made;
    }();
    return points;
}

// What lies inside the inner rim in one colour, out to the outer rim fading to nothing; both rims have `count` points,
// in pairs: inner, outer, inner, outer …
void fade_out(ImDrawList& list, const ImVec2* pairs, int count, ImU32 colour) {
    const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
    list.PrimReserve(3 * (count - 2) + 6 * count, 2 * count);
    const unsigned first = list._VtxCurrentIdx;
    const auto corner = [&](int i) { list.PrimWriteIdx(static_cast<ImDrawIdx>(first + static_cast<unsigned>(i))); };
    const auto triangle = [&](int a, int b, int c) { corner(a), corner(b), corner(c); };
    for (int i = 2; i < count; ++i) triangle(0, 2 * i - 2, 2 * i);
    for (int i = 0; i < count; ++i) {
        const int here = 2 * i, next = 2 * ((i + 1) % count);
        triangle(here, next, next + 1);
        triangle(here, next + 1, here + 1);
    }
    for (int i = 0; i < 2 * count; ++i)
        list.PrimWriteVtx(pairs[i], white, i % 2 == 0 ? colour : colour & ~IM_COL32_A_MASK);
}

}  // namespace

void Pen::halo(vec2 centre, vec2 extent, float rounding, float reach, Colour colour) const {
    const vec2 half = extent / 2 - vec2{rounding, rounding};
    const ImVec2 middle = at(centre);
    std::array<ImVec2, 2 * rim_points> pairs;
    for (int i = 0; i < rim_points; ++i) {
        const ImVec2 out = rim()[static_cast<std::size_t>(i)];
        const int quarter = i / (corner_steps + 1);
        const vec2 corner{quarter == 0 || quarter == 3 ? half.x : -half.x, quarter < 2 ? half.y : -half.y};
        for (const int outer : {0, 1}) {
            const float radius = size(rounding + (outer == 0 ? 0 : reach));
            pairs[static_cast<std::size_t>(2 * i + outer)] = {middle.x + size(corner.x) + out.x * radius,
                                                              middle.y + size(corner.y) + out.y * radius};
        }
    }
    fade_out(list, pairs.data(), rim_points, paint(colour.with_alpha(std::min(1.0f, colour.a * 1.35f))));
}

void Pen::dot(ImVec2 middle, float radius, ImU32 colour) const {
    constexpr int corners = 8;
    constexpr float slant = 0.70710678f;
    const ImVec2 out[corners] = {{1, 0},  {slant, slant},   {0, 1},  {-slant, slant},
                                 {-1, 0}, {-slant, -slant}, {0, -1}, {slant, -slant}};
    ImVec2 pairs[2 * corners];
    for (int i = 0; i < 2 * corners; ++i) {
        const float r = std::max(0.0f, radius + (i % 2 == 0 ? -0.5f : 0.5f));  // a rim of one pixel
        pairs[i] = {middle.x + out[i / 2].x * r, middle.y + out[i / 2].y * r};
    }
    fade_out(list, pairs, corners, colour);
}

}  // namespace braitenlab
