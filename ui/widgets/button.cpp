#include "ui/widgets/button.h"

#include <algorithm>
#include <string>
#include <vector>

#include "ui/imgui_compat.h"
#include "ui/widgets/card.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/whole_lines.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr float icon_room = 18, around_segment = 10;  // layout pixels
float button_padding(const ButtonLook& look) { return look.compact ? 6 : 10; }
float button_icon_gap(const ButtonLook& look) { return look.compact ? 3 : 6; }

Face face_of(const ButtonLook& look) {
    if (look.emphasis == Emphasis::primary) return Face::strong;
    return look.compact ? Face::small : Face::text;
}

bool shows_icon(const Ui& ui, const ButtonLook& look) { return !look.icon.empty() && has_icons(ui); }

struct ButtonColours {
    Colour fill, line, words;
};

ButtonColours colours(const Ui& ui, const ButtonLook& look, const Item& at) {
    const Palette& p = ui.palette;
    const float pressed = at.held ? 1.0f : 0.0f;
    if (!look.enabled)
        return {p.raised.with_alpha(0), p.line.with_alpha(look.emphasis == Emphasis::quiet ? 0.0f : 0.6f),
                p.second_text.with_alpha(0.75f)};
    if (look.emphasis == Emphasis::primary) {
        const Colour fill = mix(mix(p.accent, p.text, 0.14f * at.warmth), p.ground, 0.15f * pressed);
        return {fill, fill, p.on_accent};
    }
    const Colour warm = mix(p.raised, p.line, at.warmth * 0.6f + pressed * 0.4f);
    if (look.on) return {mix(p.panel, p.accent, 0.16f + 0.08f * at.warmth), p.accent.with_alpha(0.8f), p.text};
    if (look.emphasis == Emphasis::quiet)
        return {warm.with_alpha(std::max(at.warmth, pressed)), p.line.with_alpha(at.warmth), p.text};
    return {warm, p.line, p.text};
}

// Of the icon and the space behind it; wide icons take more.
float sign_room(const Ui& ui, const SmallButton& look) {
    if (!has_icons(ui) || look.icon.empty()) return 0;
    return std::max(ui.px(16), text_width(ui, Face::small, look.icon) + ui.px(4));
}

struct Segments {
    std::vector<float> widths;      // window pixels
    std::vector<std::size_t> ends;  // of each row, the number of the segment behind it
    bool equal = true;
};

// The ends of the rows: as many words a row as fit.
std::vector<std::size_t> rows_of_segments(std::span<const float> lengths, float around, float width) {
    std::vector<std::size_t> ends;
    float used = 0;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        const float wanted = lengths[i] + around;
        if (i > 0 && used + wanted > width) ends.push_back(i), used = 0;
        used += wanted;
    }
    ends.push_back(lengths.size());
    return ends;
}

// Of equal widths; where a word does not fit into its own, each gets the length of its word and the rest is shared.
// Words that do not fit beside each other are in several rows.
Segments lay_out_segments(const Ui& ui, std::span<const std::string_view> words, float width) {
    const float each = width / static_cast<float>(words.size());
    Segments segments{std::vector<float>(words.size(), each), {words.size()}, true};
    std::vector<float> lengths;
    for (const std::string_view word : words) {
        lengths.push_back(text_width(ui, Face::label, word));
        segments.equal &= lengths.back() < each - ui.px(12);
    }
    if (segments.equal) return segments;
    segments.ends = rows_of_segments(lengths, ui.px(around_segment), width);
    std::size_t begin = 0;
    for (const std::size_t end : segments.ends) {
        float rest = width;
        for (std::size_t i = begin; i < end; ++i) rest -= lengths[i];
        for (std::size_t i = begin; i < end; ++i)
            segments.widths[i] = lengths[i] + rest / static_cast<float>(end - begin);
        begin = end;
    }
    return segments;
}

// The largest face in which every word fits: one size for all.
Face face_of_segments(const Ui& ui, std::span<const std::string_view> words, const Segments& segments) {
    if (!segments.equal) return Face::label;
    for (const Face face : {Face::text, Face::small})
        if (std::all_of(words.begin(), words.end(), [&](std::string_view word) {
                return text_width(ui, face, word) < segments.widths.front() - ui.px(12);
            }))
            return face;
    return Face::label;
}

}  // namespace

float button_width(const Ui& ui, const ButtonLook& look) {
    float width = 2 * ui.px(button_padding(look));
    if (shows_icon(ui, look)) width += ui.px(icon_room) + (look.words.empty() ? 0 : ui.px(button_icon_gap(look)));
    width += text_width(ui, face_of(look), look.words);
    return std::max(width, ui.px(ui.tall(look.min_width)));
}

float least_width_for(const Ui& ui, ButtonLook look, std::initializer_list<std::string_view> keys) {
    float most = 0;
    for (const std::string_view key : keys) {
        look.words = ui.strings(key);
        most = std::max(most, button_width(ui, look));
    }
    return most / ui.px(1);
}

Item button(Ui& ui, std::string_view id, const ButtonLook& look) {
    const float height = ui.px(std::max(ui.tall(button_height), look.min_height));
    const Item at = item(ui, id, {button_width(ui, look), height}, look.enabled);
    const ButtonColours c = colours(ui, look, at);
    fill_box(ui, at.rect, c.fill);
    line_box(ui, at.rect, c.line);
    const Face face = face_of(look);
    const bool with_icon = shows_icon(ui, look);
    float content = text_width(ui, face, look.words);
    if (with_icon) content += ui.px(icon_room) + (look.words.empty() ? 0 : ui.px(button_icon_gap(look)));
    float x = at.middle_x() - content / 2;
    if (with_icon) {
        put_icon(ui, {x + ui.px(icon_room) / 2, at.middle_y()}, look.icon, c.words, Face::text);
        x += ui.px(icon_room + button_icon_gap(look));
    }
    put(ui, {x, at.middle_y() - line_height(ui, face) / 2}, look.words, c.words, face);
    return at;
}

bool push_button(Ui& ui, std::string_view id, const ButtonLook& look, std::string_view how, std::string_view shortcut) {
    const Item at = button(ui, id, look);
    tooltip(ui, at, how, shortcut);
    return at.pressed;
}

float small_button_width(const Ui& ui, const SmallButton& look, bool words) {
    if (!words && has_icons(ui)) return ui.px(ui.tall(28));
    return ui.px(14) + sign_room(ui, look) + text_width(ui, Face::small, look.words);
}

Item small_button(Ui& ui, const SmallButton& look, bool words) {
    const Item at = item(ui, look.id, {small_button_width(ui, look, words), ui.px(ui.tall(small_button_height))});
    const Palette& p = ui.palette;
    fill_box(ui, at.rect,
             look.on ? mix(p.panel, p.accent, 0.16f + 0.08f * at.warmth) : mix(p.raised, p.line, at.warmth));
    line_box(ui, at.rect, look.on ? p.accent.with_alpha(0.8f) : p.line);
    if (!words && has_icons(ui)) {
        put_icon(ui, {at.middle_x(), at.middle_y()}, look.icon, p.text, Face::small);
        return at;
    }
    float x = at.rect.x + ui.px(7);
    if (has_icons(ui) && !look.icon.empty()) {
        put_icon(ui, {x + (sign_room(ui, look) - ui.px(4)) / 2, at.middle_y()}, look.icon, p.second_text, Face::small);
        x += sign_room(ui, look);
    }
    put(ui, {x, at.middle_y() - line_height(ui, Face::small) / 2}, look.words, p.text, Face::small);
    return at;
}

bool small_push_button(Ui& ui, const SmallButton& look, std::string_view how, std::string_view shortcut) {
    const Item at = small_button(ui, look);
    tooltip(ui, at, how, shortcut);
    return at.pressed;
}

void beside_or_below(const Ui& ui, float width, float right) {
    const float space = ui.px(spacing::small);
    if (ImGui::GetItemRectMax().x + space + width <= right + 0.5f) ImGui::SameLine(0, space);
}

int segments(Ui& ui, std::string_view id, std::span<const std::string_view> words, int chosen, float width,
             std::string_view how) {
    const Segments segments = lay_out_segments(ui, words, width);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float row = ui.px(ui.tall(segments.ends.size() > 1 ? 26 : 30));
    const Rect all{start.x, start.y, width, row * static_cast<float>(segments.ends.size())};
    fill_box(ui, all, ui.palette.ground.with_alpha(0.6f));
    line_box(ui, all, ui.palette.line);
    const Face face = face_of_segments(ui, words, segments);
    int clicked = -1;
    float x = start.x, y = start.y;
    for (int i = 0; i < static_cast<int>(words.size()); ++i) {
        const auto number = static_cast<std::size_t>(i);
        const float each = segments.widths[number];
        const bool begins_row = std::find(segments.ends.begin(), segments.ends.end(), number) != segments.ends.end();
        if (begins_row) x = start.x, y += row;
        ImGui::SetCursorScreenPos({x, y});
        x += each;
        const Item at = item(ui, std::string(id) + "." + std::to_string(i + 1), {each, row});
        const float inset = ui.px(spacing::tight);
        const Rect inner{at.rect.x + inset, at.rect.y + inset, at.rect.w - 2 * inset, at.rect.h - 2 * inset};
        const bool on = i == chosen;
        if (on) {
            fill_box(ui, inner, mix(ui.palette.panel, ui.palette.accent, 0.20f));
            line_box(ui, inner, ui.palette.accent.with_alpha(0.8f));
        }
        const Colour colour = on ? ui.palette.text : mix(ui.palette.second_text, ui.palette.text, at.warmth);
        const auto word = words[number];
        put_centred(ui, {at.middle_x(), at.middle_y() - line_height(ui, face) / 2}, word, colour, face);
        tooltip(ui, at, how);
        if (at.pressed && !on) clicked = i;
    }
    return clicked;
}

namespace {

float key_cap_height(const Ui& ui, Face face) { return ui.px(face == Face::label ? 14 : 18); }

}  // namespace

float key_cap_width(const Ui& ui, std::string_view words, Face face) {
    return std::max(text_width(ui, face, words) + ui.px(10), key_cap_height(ui, face));
}

float key_cap(const Ui& ui, ImVec2 at, std::string_view words, Face face) {
    const float w = key_cap_width(ui, words, face), h = key_cap_height(ui, face);
    const Rect cap{at.x, at.y - h / 2, w, h};
    fill_box(ui, cap, ui.palette.raised);
    line_box(ui, cap, ui.palette.line);
    put_centred(ui, {cap.x + w / 2, at.y - line_height(ui, face) / 2}, words, ui.palette.text, face);
    return w;
}

bool radio_row(Ui& ui, std::string_view id, std::string_view words, bool chosen, bool enabled, std::string_view how,
               std::string_view key) {
    constexpr float narrow = 230, low = 640;  // layout pixels: such a card is low, too; of the window
    const float width = card_width(ui), left = ui.px(34);
    ImFont* f = font(ui, Face::text);
    const float cap = key.empty() ? 0 : key_cap_width(ui, key) + ui.px(8);
    const float wrap = width - left - ui.px(10) - cap;
    const std::string lines = wrapped_at_spaces(ui, Face::text, words, wrap);
    const char *begin = lines.c_str(), *end = begin + lines.size();
    const ImVec2 text = f->CalcTextSizeA(compat::size_of(f), 1e9f, wrap, begin, end);
    const bool is_close = width < ui.px(narrow) || ImGui::GetIO().DisplaySize.y < ui.px(low);
    const float top = std::max(ui.px(is_close ? 4 : 7), (ui.px(ui.finger) - text.y) / 2);
    const Item at = item(ui, id, {width, text.y + 2 * top}, enabled);
    const Palette& p = ui.palette;
    fill_box(ui, at.rect, chosen ? mix(p.panel, p.accent, 0.16f) : mix(p.panel, p.line, at.warmth * 0.6f));
    line_box(ui, at.rect, chosen ? p.accent.with_alpha(0.8f) : mix(p.line, p.second_text, enabled ? 0.5f : 0.0f));
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 dot{at.rect.x + ui.px(18), at.rect.y + top + line_height(ui, Face::text) / 2};
    draw.AddCircle(dot, ui.px(7), paint(chosen ? p.accent : p.second_text), 0, ui.px(1.5f));
    if (chosen) draw.AddCircleFilled(dot, ui.px(3.5f), paint(p.accent));
    {
        const WholeLines whole(at.rect.y + top, line_height(ui, Face::text));
        put_on(draw, ui, {at.rect.x + left, at.rect.y + top}, lines, enabled || chosen ? p.text : p.second_text,
               Face::text, wrap);
    }
    if (cap > 0) key_cap(ui, {at.rect.x + width - cap, at.middle_y()}, key);
    tooltip(ui, at, how);
    return at.pressed;
}

bool fold_row(Ui& ui, std::string_view id, std::string_view words, bool& open, std::string_view how) {
    const Item at = item(ui, id, {card_width(ui), ui.px(ui.tall(24))});
    const Colour colour = mix(ui.palette.second_text, ui.palette.text, at.warmth);
    const WholeLines whole(at.middle_y() - line_height(ui, Face::text) / 2, line_height(ui, Face::text));
    put_icon(ui, {at.rect.x + ui.px(8), at.middle_y()}, open ? icon::unfolded : icon::folded, colour);
    put(ui, {at.rect.x + ui.px(20), at.middle_y() - line_height(ui, Face::text) / 2}, words, colour);
    tooltip(ui, at, how);
    if (at.pressed) open = !open;
    return open;
}

float chip_width(const Ui& ui, std::string_view words) { return text_width(ui, Face::small, words) + ui.px(16); }

void chip(const Ui& ui, ImVec2 at, std::string_view words) {
    const float h = ui.px(22);
    const Rect r{at.x, at.y - h / 2, chip_width(ui, words), h};
    fill_box(ui, r, ui.palette.raised, Corner::round);
    line_box(ui, r, ui.palette.line, Corner::round);
    put_centred(ui, {r.x + r.w / 2, at.y - line_height(ui, Face::small) / 2}, words, ui.palette.text, Face::small);
}

}  // namespace braitenlab::ui
