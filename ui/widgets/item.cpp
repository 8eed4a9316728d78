#include "ui/widgets/item.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <string>

#include "ui/imgui_compat.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/paint.h"

namespace braitenlab::ui {

namespace {

Rect inside_clip(Rect r) {
    const ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 low = draw.GetClipRectMin(), high = draw.GetClipRectMax();
    const float x0 = std::max(r.x, low.x), y0 = std::max(r.y, low.y);
    const float x1 = std::min(r.x + r.w, high.x), y1 = std::min(r.y + r.h, high.y);
    return {x0, y0, std::max(0.0f, x1 - x0), std::max(0.0f, y1 - y0)};
}

// The card, sheet or bar that is being drawn.
Rect card_rect() {
    const ImGuiWindow* window = ImGui::GetCurrentWindowRead();
    if (window->RootWindow) window = window->RootWindow;
    return {window->Pos.x, window->Pos.y, window->Size.x, window->Size.y};
}

Rect grown(Rect r, float across, float down) { return {r.x - across, r.y - down, r.w + 2 * across, r.h + 2 * down}; }

// The part inside the card, at least `edge` from its border.
Rect inside_card(Rect r, float edge) {
    const Rect card = grown(card_rect(), -edge, -edge);
    const float x = std::max(r.x, card.x), y = std::max(r.y, card.y);
    return {x, y, std::max(0.0f, std::min(r.x + r.w, card.x + card.w) - x),
            std::max(0.0f, std::min(r.y + r.h, card.y + card.h) - y)};
}

// A ring around the visible part of a widget, closed also where the card cuts the widget off; the ring itself may
// extend beyond the card's clip rectangle, but not beyond the card. Returns the middle of its line.
Rect ring(const Ui& ui, Rect whole, Colour colour, RingRoom room, float thickness) {
    const Rect r = inside_clip(whole);
    if (r.w <= 0 || r.h <= 0) return {};
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 low = draw.GetClipRectMin(), high = draw.GetClipRectMax();
    const float reach = ui.px(16);
    const Rect line = inside_card(grown(r, ui.px(room.across), ui.px(room.down)), ui.px(thickness / 2 + 1));
    draw.PushClipRect({low.x - reach, low.y - reach}, {high.x + reach, high.y + reach}, false);
    compat::outline(draw, {line.x, line.y}, {line.x + line.w, line.y + line.h}, paint(colour),
                    ui.px(radius::box) + ui.px(std::min(room.across, room.down)) / 2, ui.px(thickness));
    draw.PopClipRect();
    return line;
}

// The usual upper left corner of a tooltip: beside the card, so that it does not cover other widgets; beside the rows
// of a sheet where there is room; below or above the buttons of the toolbar.
ImVec2 usual_tooltip_place(const Ui& ui, const Item& item, ImVec2 size) {
    const ImVec2 window = ImGui::GetIO().DisplaySize, card = ImGui::GetWindowPos();
    const float card_width = ImGui::GetWindowWidth(), away = ui.px(24), edge = ui.px(4);
    const float left = card.x - away - size.x, right = card.x + card_width + away / 2;
    const bool is_row = card_width > window.x / 2 && item.rect.w > ui.px(150);
    const bool fits_beside_row = is_row && item.right() + away + size.x + edge < window.x;
    const bool fits_left = card.x + card_width / 2 > window.x / 2 && left >= edge;
    const bool fits_right = card.x + card_width / 2 <= window.x / 2 && right + size.x + edge <= window.x;
    ImVec2 at{item.right() + away, item.middle_y() - size.y / 2};
    if (!fits_beside_row && card_width <= window.x / 2 && (fits_left || fits_right)) {
        at.x = fits_left ? left : right;
    } else if (!fits_beside_row) {
        const bool above = item.rect.y > window.y / 2;
        at = {item.middle_x() - size.x / 2, above ? item.rect.y - ui.px(10) - size.y : item.bottom() + ui.px(10)};
    }
    return at;
}

// Where a tooltip of this size is: at its usual place, else above or below what is kept free, else beside, below or
// above the item; the first place that covers neither of both. Always inside the window if it fits into it.
Rect tooltip_place(const Ui& ui, const Item& item, ImVec2 size) {
    const ImVec2 window = ImGui::GetIO().DisplaySize, usual = usual_tooltip_place(ui, item, size);
    const float edge = ui.px(4), away = ui.px(10);
    const auto inside = [edge](float low, float length, float room) {
        return std::floor(std::max(edge, std::min(low, room - edge - length)));
    };
    const Rect free = ui.tooltips ? ui.tooltips->kept_free : Rect{};
    const float x = item.middle_x() - size.x / 2, y = item.middle_y() - size.y / 2;
    const float over = free.w > 0 ? free.y - away - size.y : usual.y,
                under = free.w > 0 ? free.y + free.h + away : over;
    const auto placed = [&](ImVec2 at) {
        return Rect{inside(at.x, size.x, window.x), inside(at.y, size.y, window.y), size.x, size.y};
    };
    Rect covers_no_item = placed(usual);
    for (const ImVec2 at : {usual, ImVec2{usual.x, over}, ImVec2{usual.x, under}, ImVec2{item.right() + away, y},
                            ImVec2{item.rect.x - away - size.x, y}, ImVec2{x, item.bottom() + away},
                            ImVec2{x, item.rect.y - away - size.y}}) {
        const Rect place = placed(at);
        if (place.overlaps(item.rect)) continue;
        if (!place.overlaps(free)) return place;
        if (covers_no_item.overlaps(item.rect)) covers_no_item = place;
    }
    return covers_no_item;
}

// Size of the words of a tooltip, wrapped at `width`.
ImVec2 size_of_words(const Ui& ui, std::string_view words, float width) {
    if (words.empty()) return {};
    ImFont* face = font(ui, Face::small);
    const std::string text = wrapped_at_spaces(ui, Face::small, words, width);
    return face->CalcTextSizeA(compat::size_of(face), FLT_MAX, width, text.data(), text.data() + text.size());
}

// True once the pointer has rested on the widget for `hovered` seconds, or if it comes from another tooltip.
bool is_due(const Ui& ui, float hovered) {
    constexpr double rest = 0.5, just_before = 0.25;
    const double now = ImGui::GetTime();
    const double rested = ui.tooltips ? std::min<double>(hovered, now - ui.tooltips->moved_at) : hovered;
    return rested >= rest || (ui.tooltips && ui.tooltips->shown_at >= 0 && now - ui.tooltips->shown_at <= just_before);
}

bool is_visible(Rect r) { return r.w >= 1 && r.h >= 1; }

}  // namespace

Item item(Ui& ui, std::string_view id, ImVec2 size, bool enabled, RingRoom room) {
    Item result;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    result.rect = {at.x, at.y, size.x, size.y};
    result.enabled = enabled;
    if (ui.shown) {
        result.shown = static_cast<int>(ui.shown->size());
        ui.shown->push_back({std::string(id), false, result.rect, enabled});
    }
    ImGui::PushID(id.data(), id.data() + id.size());
    const bool clicked = ImGui::InvisibleButton("##item", {std::max(1.0f, size.x), std::max(1.0f, size.y)});
    ImGui::PopID();
    result.hovered = ImGui::IsItemHovered();
    result.held = enabled && ImGui::IsItemActive();
    result.pressed = enabled && clicked;
    if (enabled && stop_here(ui.keyboard, id)) {
        result.focused = true;
        if (take(*ui.keyboard, key::enter)) result.pressed = result.entered = true;
        if (ui.keyboard->revealed) reveal(ui, result.rect.y, result.bottom());
        if (ui.keyboard->shown) ring(ui, result.rect, ui.palette.accent, {3, 3}, 1.5f);
    }
    if (ui.reveals && *ui.reveals && id == ui.highlight) {
        *ui.reveals = false;
        reveal(ui, result.rect.y, result.bottom());
    }
    result.warmth = eased(ui, id, enabled && (result.hovered || result.held) ? 1.0f : 0.0f);
    mark(ui, id, result.rect, room);
    return result;
}

void reveal(const Ui& ui, float top, float bottom) {
    const ImGuiWindow& window = *ImGui::GetCurrentWindowRead();
    if (window.Flags & ImGuiWindowFlags_NoScrollbar) return;
    // Of the whole part: within a text the clip rectangle is that of its visible lines, and empty if there is none.
    const float around = ui.px(6), low = window.InnerClipRect.Min.y + around,
                high = window.InnerClipRect.Max.y - around;
    const float below = bottom - high, above = low - top;
    if (above > 0 || bottom - top > high - low)
        ImGui::SetScrollY(ImGui::GetScrollY() - above);
    else if (below > 0)
        ImGui::SetScrollY(ImGui::GetScrollY() + below);
}

void mark(Ui& ui, std::string_view id, Rect rect, RingRoom room) {
    const Rect visible = inside_clip(rect);
    if (!is_visible(visible)) return;
    ui.anchors.record(id, visible);
    if (id == ui.highlight && !id.empty()) point_out(ui, rect, room);
}

void point_out(const Ui& ui, Rect rect, RingRoom room) {
    constexpr float widens = 2, thickness = 2, in_margin = 7;  // layout pixels; the last one is a radius
    const Colour colour = ui.palette.accent;
    const RingRoom now{room.across + widens * ui.pulse, room.down + widens * ui.pulse};
    const Rect line = ring(ui, rect, colour.with_alpha(0.9f - 0.4f * ui.pulse), now, thickness);
    if (line.w <= 0) return;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float reach = ui.px(16);
    const ImVec2 low = draw.GetClipRectMin(), high = draw.GetClipRectMax();
    draw.PushClipRect({low.x - reach, low.y - reach}, {high.x + reach, high.y + reach}, false);
    fill_box(ui, line, colour.with_alpha(0.10f + 0.14f * ui.pulse));
    draw.PopClipRect();

    // In the card's margin the badge covers no text of the row above.
    const float right = rect.x + rect.w;
    const bool has_sign = room.before_sign > 0, reaches_the_margin = high.x - right <= ui.px(spacing::large);
    const float radius = ui.px(has_sign || reaches_the_margin ? in_margin : hint_badge_radius);
    const Rect card = grown(card_rect(), -radius - ui.px(1), -radius - ui.px(1));
    ImVec2 middle = reaches_the_margin ? ImVec2{card.x + card.w,
                                                std::min(line.y + line.h / 2, line.y + radius + ui.px(spacing::tight))}
                                       : ImVec2{right + 0.25f * radius, rect.y + 0.1f * radius};
    // On a thing as small as the badge, such as a pin, it would hide it: there it is outside of the node.
    const bool is_small = std::max(rect.w, rect.h) < 3 * radius;
    if (is_small)
        middle = {ui.highlight.ends_with(".in") ? rect.x - 0.6f * radius : right + 0.6f * radius,
                  line.y + line.h + radius};
    middle.x = std::clamp(middle.x, card.x, std::max(card.x, card.x + card.w));
    middle.y = std::clamp(middle.y, card.y, std::max(card.y, card.y + card.h));
    if (has_sign) middle = {right - ui.px(room.before_sign) - radius, rect.y + rect.h / 2};
    hint_badge(ui, draw, middle, radius / ui.scale);
    if (ui.pointed_out) *ui.pointed_out = {line, {middle.x - radius, middle.y - radius, 2 * radius, 2 * radius}};
}

void hint_badge(const Ui& ui, ImDrawList& draw, ImVec2 middle, float layout_radius) {
    if (!has_icons(ui)) return;
    const float radius = ui.px(layout_radius), reach = ui.px(24);
    const ImVec2 low = draw.GetClipRectMin(), high = draw.GetClipRectMax();
    draw.PushClipRect({low.x - reach, low.y - reach}, {high.x + reach, high.y + reach}, false);
    draw.AddCircleFilled(middle, radius, paint(ui.palette.accent), 24);
    // The sign stays inside the disc.
    const float height = std::min(1.7f * radius, line_height(ui, Face::small));
    ImFont* f = font(ui, Face::small);
    const ImVec2 size = f->CalcTextSizeA(height, 1e9f, 0, icon::hint.data(), icon::hint.data() + icon::hint.size());
    record_text(ui, draw, {middle.x - size.x / 2, middle.y - size.y / 2, size.x, size.y}, icon::hint,
                line_height(ui, Face::small));
    draw.AddText(f, height, {middle.x - size.x / 2, middle.y - size.y / 2}, paint(ui.palette.panel), icon::hint.data(),
                 icon::hint.data() + icon::hint.size());
    draw.PopClipRect();
}

void tooltip(Ui& ui, const Item& item, std::string_view words, std::string_view shortcut) {
    if (ui.shown && item.shown >= 0) (*ui.shown)[static_cast<std::size_t>(item.shown)].has_tooltip |= !words.empty();
    const bool is_hidden = ImGui::IsMouseDown(0) || (ui.tooltips && ui.tooltips->hidden);
    if (ui.quiet || !item.hovered || item.held || words.empty() || is_hidden) return;
    // Hidden after 9 s and after a click.
    constexpr float hide_after = 9;
    const float hovered = compat::hovered_seconds();
    const bool pressed_meanwhile = ImGui::GetTime() - ImGui::GetIO().MouseClickedTime[0] < static_cast<double>(hovered);
    if (!is_due(ui, hovered) || hovered > hide_after || pressed_meanwhile) return;
    if (ui.tooltips) ui.tooltips->shown_at = ImGui::GetTime();
    const ImVec2 padding{ui.px(spacing::medium), ui.px(spacing::small)};
    const float space = ui.px(spacing::hair);
    const float widest = std::max(text_width(ui, Face::small, words), text_width(ui, Face::small, shortcut));
    const float width = std::min(ui.px(280), widest) + 1;
    const ImVec2 main = size_of_words(ui, words, width), extra = size_of_words(ui, shortcut, width);
    const float height = main.y + (shortcut.empty() ? 0 : space + extra.y);
    const Rect place =
        tooltip_place(ui, item, {std::max(main.x, extra.x) + 2 * padding.x + 1, height + 2 * padding.y + 1});
    ui.anchors.record("tooltip", place);
    ImGui::SetNextWindowPos({place.x, place.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, space});
    ImGui::BeginTooltip();
    paragraph(ui, words, ui.palette.text, Face::small, width);
    if (!shortcut.empty()) paragraph(ui, shortcut, ui.palette.second_text, Face::small, width);
    compat::end_tooltip();
    ImGui::PopStyleVar(2);
}

float eased(const Ui& ui, std::string_view id, float target, float seconds) {
    float& value = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID(id.data(), id.data() + id.size()), target);
    if (ui.still) return value = target;
    const float most = ImGui::GetIO().DeltaTime / seconds;
    value += std::clamp(target - value, -most, most);
    return value;
}

}  // namespace braitenlab::ui
