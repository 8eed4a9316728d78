#include "ui/widgets/paint.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/imgui_compat.h"
#include "ui/widgets/whole_lines.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

ImVec2 snapped(ImVec2 at) { return {std::floor(at.x + 0.5f), std::floor(at.y + 0.5f)}; }

const char* end_of(std::string_view words) { return words.data() + words.size(); }

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool has_decimal_number(std::string_view words) {
    for (std::size_t i = 1; i + 1 < words.size(); ++i)
        if ((words[i] == ',' || words[i] == '.') && is_digit(words[i - 1]) && is_digit(words[i + 1])) return true;
    return false;
}

float room_of_paragraph(const Ui& ui, float width) {
    return width > 0 ? width : card_width(ui) - ImGui::GetCursorPosX();
}

// `text`: the words with their line breaks.
void put_paragraph(Ui& ui, std::string_view words, const std::string& text, Colour colour, Face face, float width) {
    const WholeLines whole(ImGui::GetCursorScreenPos().y, line_height(ui, face));
    compat::push_font(font(ui, face));
    ImGui::PushStyleColor(ImGuiCol_Text, paint(colour));
    ImGui::PushTextWrapPos(width > 0 ? ImGui::GetCursorPosX() + width : card_width(ui));
    ImGui::TextUnformatted(text.c_str(), text.c_str() + text.size());
    const ImVec2 low = ImGui::GetItemRectMin(), size = ImGui::GetItemRectSize();
    record_text(ui, *ImGui::GetWindowDrawList(), {low.x, low.y, size.x, size.y}, words, line_height(ui, face));
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

float corner_radius(const Ui& ui, Rect r, Corner corner) {
    return corner == Corner::bar     ? ui.px(radius::bar)
           : corner == Corner::box   ? ui.px(radius::box)
           : corner == Corner::round ? std::min(r.w, r.h) / 2
                                     : 0;
}

// The largest rectangle of whole pixels within one whose corners have this radius.
Rect whole_pixels_inside(Rect r, float radius) {
    constexpr float share = 0.293f;  // 1 - sqrt(1/2): where the corner's arc is nearest to the corner's middle
    const float margin = share * radius;
    const float left = std::ceil(r.x + margin), right = std::max(left, std::floor(r.x + r.w - margin));
    const float top = std::ceil(r.y + margin), bottom = std::max(top, std::floor(r.y + r.h - margin));
    return {left, top, right - left, bottom - top};
}

Rect grown_to_whole_pixels(Rect r, float margin) {
    const float left = std::floor(r.x - margin), right = std::ceil(r.x + r.w + margin);
    const float top = std::floor(r.y - margin), bottom = std::ceil(r.y + r.h + margin);
    return {left, top, right - left, bottom - top};
}

// Draws what `drawn` adds between two rectangles, in four strips.
template <class Drawn>
void clip_to_rim(ImDrawList& draw, Rect outer, Rect inner, const Drawn& drawn) {
    const float right = inner.x + inner.w, bottom = inner.y + inner.h;
    const float outer_right = outer.x + outer.w, outer_bottom = outer.y + outer.h;
    const std::array<Rect, 4> strips{{{outer.x, outer.y, outer.w, inner.y - outer.y},
                                      {outer.x, bottom, outer.w, outer_bottom - bottom},
                                      {outer.x, inner.y, inner.x - outer.x, inner.h},
                                      {right, inner.y, outer_right - right, inner.h}}};
    for (const Rect& strip : strips) {
        draw.PushClipRect({strip.x, strip.y}, {strip.x + strip.w, strip.y + strip.h}, true);
        drawn();
        draw.PopClipRect();
    }
}

}  // namespace

void record_text(const Ui& ui, const ImDrawList& draw, Rect rect, std::string_view words, float pixels) {
    if (!ui.written) return;
    const ImVec2 low = draw.GetClipRectMin(), high = draw.GetClipRectMax();
    const ImGuiWindow& window = *ImGui::GetCurrentWindowRead();
    ui.written->push_back({std::string(words),
                           rect,
                           {low.x, low.y, high.x - low.x, high.y - low.y},
                           &draw,
                           pixels / line_height_em,
                           window.DrawList == &draw && window.ScrollMax.y > 0});
}

ImFont* font(const Ui& ui, Face face) {
    const Fonts& fonts = ui.fonts;
    if (face == Face::label && ui.least_type > 0) face = Face::small;  // labels are lower than the least type
    ImFont* chosen = face == Face::text      ? fonts.text
                     : face == Face::strong  ? fonts.strong
                     : face == Face::title   ? fonts.title
                     : face == Face::display ? fonts.display
                     : face == Face::caption ? fonts.caption
                     : face == Face::label   ? fonts.label
                                             : fonts.small;
    if (!chosen && face == Face::label) chosen = fonts.small;
    if (!chosen && (face == Face::display || face == Face::caption)) chosen = fonts.title;
    if (!chosen) chosen = fonts.text;
    return chosen ? chosen : ImGui::GetFont();
}

float line_height(const Ui& ui, Face face) { return compat::size_of(font(ui, face)); }

float text_width(const Ui& ui, Face face, std::string_view words) {
    if (words.empty()) return 0;
    ImFont* f = font(ui, face);
    return f->CalcTextSizeA(compat::size_of(f), 1e9f, 0, words.data(), end_of(words)).x;
}

float put(const Ui& ui, ImVec2 at, std::string_view words, Colour colour, Face face) {
    if (words.empty()) return 0;
    ImFont* f = font(ui, face);
    ImGui::GetWindowDrawList()->AddText(f, compat::size_of(f), snapped(at), paint(colour), words.data(), end_of(words));
    const float width = text_width(ui, face, words);
    record_text(ui, *ImGui::GetWindowDrawList(), {at.x, at.y, width, line_height(ui, face)}, words,
                line_height(ui, face));
    return width;
}

void put_on(ImDrawList& draw, const Ui& ui, ImVec2 at, std::string_view words, Colour colour, Face face, float wrap) {
    if (words.empty()) return;
    ImFont* f = font(ui, face);
    const float pixels = compat::size_of(f);
    draw.AddText(f, pixels, snapped(at), paint(colour), words.data(), end_of(words), wrap);
    if (!ui.written) return;
    const ImVec2 size = f->CalcTextSizeA(pixels, 1e9f, wrap, words.data(), end_of(words));
    record_text(ui, draw, {at.x, at.y, size.x, size.y}, words, pixels);
}

void put_right(const Ui& ui, ImVec2 at, std::string_view words, Colour colour, Face face) {
    put(ui, {at.x - text_width(ui, face, words), at.y}, words, colour, face);
}

void put_centred(const Ui& ui, ImVec2 at, std::string_view words, Colour colour, Face face) {
    put(ui, {at.x - text_width(ui, face, words) / 2, at.y}, words, colour, face);
}

std::string shortened(const Ui& ui, std::string_view words, Face face, float width) {
    if (text_width(ui, face, words) <= width) return std::string(words);
    if (ui.shortened) ++*ui.shortened;
    ImFont* f = font(ui, face);
    const float room = std::max(0.0f, width - text_width(ui, face, "…"));
    const char* end = words.data();
    f->CalcTextSizeA(compat::size_of(f), room, 0, words.data(), end_of(words), &end);
    return std::string(words.data(), end) + "…";
}

std::string shortened_first_sentence(const Ui& ui, std::string_view words, Face face, float width) {
    const auto fits = [&](std::string_view part) { return text_width(ui, face, part) <= width; };
    words = words.substr(0, std::min(words.size(), words.find(". ")) + 1);
    if (fits(words)) return std::string(words);
    for (std::size_t end = words.find_last_of(",:;"); end != std::string_view::npos && end > 0;
         end = words.find_last_of(",:;", end - 1)) {
        std::string part = std::string(words.substr(0, end)) + " …";
        if (words.substr(end + 1, 1) != " " || !fits(part)) continue;
        if (text_width(ui, face, part) < width / 4) break;
        if (ui.shortened) ++*ui.shortened;
        return part;
    }
    return shortened(ui, words, face, width);
}

std::string wrapped_at_spaces(const Ui& ui, Face face, std::string_view words, float width) {
    std::string text(words);
    if (!has_decimal_number(words)) return text;
    std::size_t line = 0, last_space = text.npos;
    for (std::size_t i = 0; i <= text.size(); ++i) {
        const bool ends = i == text.size();
        if (!ends && text[i] != ' ' && text[i] != '\n') continue;
        const bool is_too_wide = text_width(ui, face, std::string_view(text).substr(line, i - line)) > width;
        if (is_too_wide && last_space != text.npos) text[last_space] = '\n', line = last_space + 1;
        if (ends) break;
        last_space = text[i] == ' ' ? i : text.npos;
        if (text[i] == '\n') line = i + 1;
    }
    return text;
}

std::vector<std::string> lines_of_words(const Ui& ui, std::string_view words, Face face, float width) {
    std::vector<std::string> lines{""};
    while (!words.empty()) {
        const std::size_t end = std::min(words.find_first_of(" \n"), words.size());
        const bool ends_line = end < words.size() && words[end] == '\n';
        const std::string word(words.substr(0, end));
        const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
        if (!lines.back().empty() && text_width(ui, face, longer) > width)
            lines.push_back(word);
        else
            lines.back() = longer;
        if (ends_line) lines.emplace_back();
        words.remove_prefix(std::min(end + 1, words.size()));
    }
    return lines;
}

std::vector<std::string> even_lines(const Ui& ui, std::string_view words, Face face, float width) {
    std::vector<std::string> lines = lines_of_words(ui, words, face, width);
    // Of the width that needs no further line.
    float least = width * (1 - 1 / static_cast<float>(lines.size())), most = width;
    constexpr int halvings = 6;
    for (int i = 0; i < halvings && lines.size() > 1; ++i) {
        const float middle = (least + most) / 2;
        std::vector<std::string> shorter = lines_of_words(ui, words, face, middle);
        const bool fits = shorter.size() == lines.size();
        (fits ? most : least) = middle;
        if (fits) lines = std::move(shorter);
    }
    return lines;
}

bool put_lines(const Ui& ui, ImVec2 at, std::string_view words, Colour colour, Face face, float width,
               std::size_t most) {
    std::vector<std::string> lines = lines_of_words(ui, words, face, width);
    const bool is_whole = lines.size() <= most;
    if (!is_whole) {
        for (std::size_t i = most; i < lines.size(); ++i) lines[most - 1] += " " + lines[i];
        lines.resize(most);
    }
    for (const std::string& line : lines) {
        put(ui, at, shortened(ui, line, face, width), colour, face);
        at.y += line_height(ui, face);
    }
    return is_whole;
}

void paragraph(Ui& ui, std::string_view words, Colour colour, Face face, float width) {
    put_paragraph(ui, words, wrapped_at_spaces(ui, face, words, room_of_paragraph(ui, width)), colour, face, width);
}

void even_paragraph(Ui& ui, std::string_view words, Colour colour, Face face, float width) {
    std::string text;
    for (const std::string& line : even_lines(ui, words, face, room_of_paragraph(ui, width)))
        text += (text.empty() ? "" : "\n") + line;
    put_paragraph(ui, words, text, colour, face, width);
}

std::string_view translated(const Ui& ui, std::string_view words) { return ui.strings.find(words, words); }

bool has_icons(const Ui& ui) { return compat::has_glyph(font(ui, Face::text), 0xF04B); }

std::string with_large_arrows(const Ui& ui, std::string text) {
    if (!has_icons(ui)) return text;
    constexpr std::array<std::array<std::string_view, 2>, 4> arrows{
        {{"←", "\uf060"}, {"→", "\uf061"}, {"↑", "\uf062"}, {"↓", "\uf063"}}};
    for (const auto& [small, large] : arrows)
        for (std::size_t at = text.find(small); at != text.npos; at = text.find(small))
            text.replace(at, small.size(), large);
    return text;
}

void put_icon(const Ui& ui, ImVec2 middle, std::string_view name, Colour colour, Face face) {
    if (has_icons(ui)) put_centred(ui, {middle.x, middle.y - line_height(ui, face) / 2}, name, colour, face);
}

void fill_box(const Ui& ui, Rect r, Colour colour, Corner corner) {
    constexpr float least_cleared = 4000;  // px²; a smaller box is not worth five more commands
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float radius = corner_radius(ui, r, corner);
    const ImU32 paint_of_box = paint(colour);
    const auto fill_all = [&] { draw.AddRectFilled({r.x, r.y}, {r.x + r.w, r.y + r.h}, paint_of_box, radius); };
    const Rect inside = whole_pixels_inside(r, radius);
    const bool is_opaque = paint_of_box >> IM_COL32_A_SHIFT == 255;
    if (!ui.fill_clip || !is_opaque || inside.w * inside.h < least_cleared) return fill_all();
    draw.PushClipRect({inside.x, inside.y}, {inside.x + inside.w, inside.y + inside.h}, true);
    draw.AddCallback(ui.fill_clip, reinterpret_cast<void*>(static_cast<std::uintptr_t>(paint_of_box)));
    draw.PopClipRect();
    clip_to_rim(draw, grown_to_whole_pixels(r, 1), inside, fill_all);
}

void line_box(const Ui& ui, Rect r, Colour colour, Corner corner, float thickness) {
    compat::outline(*ImGui::GetWindowDrawList(), {r.x, r.y}, {r.x + r.w, r.y + r.h}, paint(colour),
                    corner_radius(ui, r, corner), ui.px(thickness));
}

void shadow_box(const Ui& ui, ImDrawList& draw, Rect r, Corner corner, Shadow look) {
    const Colour shadow = ui.palette.shadow.with_alpha(ui.palette.shadow.a * look.share);
    const float radius = corner_radius(ui, r, corner), lowered = ui.px(2);
    const float reach = ui.px(look.step) * static_cast<float>(look.rings) + lowered + 1;
    // Only the rim is drawn: below the box a software renderer would shade hidden pixels.
    const Rect outer = grown_to_whole_pixels(r, reach);
    clip_to_rim(draw, outer, whole_pixels_inside(r, radius), [&] {
        for (int ring = look.rings; ring > 0; --ring) {
            const float grown = ui.px(look.step) * static_cast<float>(ring);
            draw.AddRectFilled({r.x - grown, r.y - grown + lowered}, {r.x + r.w + grown, r.y + r.h + grown + lowered},
                               paint(shadow), radius + grown);
        }
    });
}

void put_role(const Ui& ui, ImVec2 middle, float size, Role role) {
    put_role(ui, middle, size, role, colour_of(ui.palette, role));
}

void put_role(const Ui&, ImVec2 c, float size, Role role, Colour of_sign) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float h = size / 2;
    const ImU32 colour = paint(of_sign);
    switch (role) {
        case Role::predator:
            draw.AddTriangleFilled({c.x, c.y - h * 1.05f}, {c.x + h, c.y + h * 0.9f}, {c.x - h, c.y + h * 0.9f},
                                   colour);
            break;
        case Role::prey:
            draw.AddCircleFilled(c, h * 0.95f, colour);
            break;
        case Role::none:
        case Role::wiring:
            draw.AddRectFilled({c.x - h * 0.85f, c.y - h * 0.85f}, {c.x + h * 0.85f, c.y + h * 0.85f}, colour,
                               size / 8);
            break;
    }
}

Colour colour_of_weight(const Palette& p, float weight) {
    constexpr float nothing = 0.005f;  // would be written as 0.00
    return weight >= nothing ? p.excites : weight <= -nothing ? p.inhibits : p.second_text;
}

float card_width(const Ui& ui) { return ImGui::GetWindowWidth() - ui.px(side_padding - card_scrollbar_inset); }

}  // namespace braitenlab::ui
