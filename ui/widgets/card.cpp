#include "ui/widgets/card.h"

#include <algorithm>
#include <cmath>

#include "ui/imgui_compat.h"
#include "ui/widgets/item.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/whole_lines.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr float bottom_padding = spacing::medium, above_footer = spacing::small, below_head = spacing::small;
constexpr float card_heading = 36, heading_button_height = 24;  // layout pixels
constexpr float narrow_heading = 180;                           // layout pixels, of two in a row
constexpr float unmeasured_head = 200;                          // at most, layout pixels
constexpr ImGuiWindowFlags plain_window = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBackground |
                                          ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                          ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoScrollWithMouse;

void begin_window(const char* name, Rect r, ImGuiWindowFlags flags = plain_window) {
    ImGui::SetNextWindowPos({r.x, r.y});
    ImGui::SetNextWindowSize({r.w, r.h});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::Begin(name, nullptr, flags);
    ImGui::PopStyleVar(2);
}

// A button with its right end at `right`; with its icon where its words would reach beyond `left`. Returns its left
// end.
float heading_button(Ui& ui, HeadingButton& extra, float left, float right, float y) {
    const float with_words = text_width(ui, Face::small, extra.words) + ui.px(spacing::large);
    const bool by_icon = has_icons(ui) && !extra.icon.empty() && right - with_words < left;
    const std::string_view shown = by_icon ? extra.icon : extra.words;
    const float w = by_icon ? ui.px(ui.tall(heading_button_height)) : with_words;
    const float h = ui.px(ui.tall(heading_button_height));
    ImGui::SetCursorScreenPos({right - w, y + (ui.px(ui.tall(card_heading)) - h) / 2});
    const Item at = item(ui, extra.id, {w, h});
    const Palette& p = ui.palette;
    // The room for a finger is as high as the heading; the box is not.
    const float inset = std::max(0.0f, (h - ui.px(ui.tall(card_heading)) + 2 * ui.px(spacing::tight)) / 2);
    const Rect box{at.rect.x, at.rect.y + inset, at.rect.w, at.rect.h - 2 * inset};
    fill_box(ui, box, extra.on ? mix(p.panel, p.accent, 0.16f + 0.08f * at.warmth) : mix(p.raised, p.line, at.warmth));
    line_box(ui, box, extra.on ? p.accent.with_alpha(0.8f) : p.line);
    put_centred(ui, {at.middle_x(), at.middle_y() - line_height(ui, Face::small) / 2}, shown, ui.palette.text,
                Face::small);
    tooltip(ui, at, extra.tooltip, extra.shortcut);
    extra.pressed = at.pressed;
    extra.hovered = at.hovered;
    return at.rect.x;
}

// True if the left button went down when the heading had just come to its place, where another one was before: the
// press was meant for that one, or is the second of two fast ones.
bool is_pressed_too_soon(Rect heading) {
    constexpr double too_soon = 0.5;  // s
    ImGuiStorage& memory = *ImGui::GetStateStorage();
    const ImGuiID x = ImGui::GetID("heading x"), y = ImGui::GetID("heading y"), since = ImGui::GetID("heading since");
    const bool has_moved = memory.GetFloat(x, heading.x) != heading.x || memory.GetFloat(y, heading.y) != heading.y;
    memory.SetFloat(x, heading.x), memory.SetFloat(y, heading.y);
    if (has_moved) memory.SetFloat(since, static_cast<float>(ImGui::GetTime()));
    const double came = memory.GetFloat(since, -1);
    return came >= 0 && ImGui::IsMouseReleased(0) && ImGui::GetIO().MouseClickedTime[0] < came + too_soon;
}

void heading_row(Ui& ui, CardState& state, std::string_view words, Rect r, std::span<HeadingButton> extras) {
    // Buttons first: of two widgets under the pointer Dear ImGui chooses the earlier one.
    const float padding = r.w < ui.px(narrow_heading) ? spacing::small : side_padding;
    const float left = r.x + ui.px(padding) + text_width(ui, Face::small, words) + ui.px(spacing::small);
    float right = r.x + r.w - ui.px(padding + 16);
    if (!state.folded)
        for (HeadingButton& extra : extras) right = heading_button(ui, extra, left, right, r.y) - ui.px(6);
    ImGui::SetCursorScreenPos({r.x, r.y});
    constexpr float fold_sign = 12;  // layout pixels, with the space before it
    const Item row = item(ui, state.fold_id, {r.w, std::min(r.h, ui.px(ui.tall(card_heading)))}, true,
                          {around_button.across, around_button.down, padding + fold_sign});
    const Colour colour = mix(ui.palette.second_text, ui.palette.text, row.warmth);
    const float y = row.rect.y + row.rect.h / 2;
    const float begin = r.x + ui.px(padding);
    put(ui, {begin, y - line_height(ui, Face::small) / 2}, shortened(ui, words, Face::small, right - begin), colour,
        Face::small);
    put_icon(ui, {r.x + r.w - ui.px(padding + 4), y}, state.folded ? icon::folded : icon::unfolded, colour);
    const bool on_a_button = std::any_of(extras.begin(), extras.end(), [](const auto& extra) { return extra.hovered; });
    tooltip(ui, row, on_a_button ? std::string_view{} : ui.strings(state.folded ? "card.unfold" : "card.fold"));
    const bool is_in_row = r.h < ui.px(ui.tall(card_heading));  // of headings that take each other's places
    const bool too_soon = is_pressed_too_soon(r) && is_in_row;
    if (row.pressed && !too_soon) state.folded = !state.folded;
}

void begin_part(const Ui& ui, const char* name, ImVec2 size, ImGuiWindowFlags flags) {
    compat::begin_child(name, size, flags);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(spacing::small), ui.px(spacing::small)});
    ImGui::BeginGroup();
}

// Returns its height.
float end_part() {
    compat::end_group();
    const float height = ImGui::GetItemRectSize().y;
    ImGui::PopStyleVar();
    compat::end_child();
    return height;
}

// The scrollbar is in the right padding; it does not move the content.
float width_of_parts(const Ui& ui, Rect card) { return card.w - ui.px(side_padding) - ui.px(card_scrollbar_inset); }

// The head is cut where it would cover the footer.
float height_of_head(const Ui& ui, const CardState& state, Rect r) {
    const float room = r.h - ui.px(ui.tall(card_heading) + bottom_padding) - state.footer;
    return std::max(1.0f, std::min(state.head.value_or(0.0f), room));
}

void begin_body(const Ui& ui, CardState& state, Rect r) {
    const float top = ui.px(ui.tall(card_heading)) + (state.head ? height_of_head(ui, state, r) : 0),
                bottom = ui.px(bottom_padding) + state.footer;
    ImGui::SetCursorPos({ui.px(side_padding), top});
    // Dear ImGui moves the line below a text to a whole pixel before it subtracts the spacing, so a measured height is
    // up to a pixel less than that of its texts.
    const float height = std::ceil(std::max(1.0f, r.h - top - bottom));
    begin_part(ui, "body", {width_of_parts(ui, r), height}, ImGuiWindowFlags_NoNav);
    if (state.head && ImGui::GetScrollY() > 0)
        ImGui::GetWindowDrawList()->AddLine({r.x + ui.px(side_padding), r.y + top},
                                            {r.x + r.w - ui.px(side_padding), r.y + top}, paint(ui.palette.line),
                                            ui.px(1));
    state.in_body = true;
}

void measure(CardState& state, float& height, float measured) {
    state.is_cut |= measured > height + 1;
    height = measured;
}

void end_body(const Ui& ui, CardState& state) {
    if (!state.in_body) return;
    shade_edges(ui);
    measure(state, state.content, end_part());
    state.in_body = false;
}

}  // namespace

float folded_height(const Ui& ui) { return ui.px(ui.tall(card_heading)); }

float wanted_height(const Ui& ui, const CardState& state) {
    if (state.folded) return folded_height(ui);
    // Before a body below a head is measured it needs room: Dear ImGui does not lay out what is outside the card.
    const float head = state.head ? *state.head + (state.content > 0 ? 0 : ui.px(unmeasured_head)) : 0;
    return ui.px(ui.tall(card_heading) + bottom_padding) + head + state.content + state.footer;
}

void card_ground(const Ui& ui, Rect r, Corner corner) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.PushClipRectFullScreen();
    shadow_box(ui, draw, r, corner, {3, 2, 0.10f});
    fill_box(ui, r, ui.palette.panel, corner);
    if (ui.opaque) ui.opaque->push_back(r);
    line_box(ui, r, ui.palette.line, corner);
    draw.PopClipRect();
}

bool begin_card(Ui& ui, CardState& state, std::string_view id, std::string_view heading, Rect r,
                std::span<HeadingButton> extras) {
    begin_stops(ui.keyboard);
    if (state.id != id) state.id = id, state.fold_id = state.id + ".fold";
    state.is_cut = false;
    begin_window(state.id.c_str(), r);
    card_ground(ui, r);
    mark(ui, id, r);
    heading_row(ui, state, heading, r, extras);
    if (state.folded) return false;
    state.in_head = state.head.has_value();
    if (!state.in_head) return begin_body(ui, state, r), true;
    ImGui::SetCursorPos({ui.px(side_padding), ui.px(ui.tall(card_heading))});
    begin_part(ui, "head", {width_of_parts(ui, r), height_of_head(ui, state, r)},
               ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    return true;
}

void end_head(const Ui& ui, CardState& state, Rect r) {
    state.in_head = false;
    measure(state, *state.head, end_part() + ui.px(below_head));
    begin_body(ui, state, r);
}

void begin_footer(Ui& ui, CardState& state, Rect r) {
    end_body(ui, state);
    ImGui::SetCursorScreenPos(
        {r.x + ui.px(side_padding), r.y + r.h - ui.px(bottom_padding) - state.footer + ui.px(above_footer)});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(spacing::small), ui.px(spacing::small)});
    ImGui::BeginGroup();
}

void end_footer(const Ui& ui, CardState& state) {
    compat::end_group();
    ImGui::PopStyleVar();
    measure(state, state.footer, ImGui::GetItemRectSize().y + ui.px(above_footer));
}

void end_card(const Ui& ui, CardState& state) {
    end_body(ui, state);
    compat::end_window();
}

void begin_bar(Ui& ui, const char* name, Rect r, bool covers_cards, Corner corner) {
    begin_stops(ui.keyboard);
    if (covers_cards) ImGui::SetNextWindowFocus();
    begin_window(name, r, covers_cards ? plain_window & ~ImGuiWindowFlags_NoBringToFrontOnFocus : plain_window);
    if (!covers_cards) card_ground(ui, r, corner);
}

void end_bar() { compat::end_window(); }

void begin_overlay(const Ui& ui, const char* name, Rect r, Colour border) {
    constexpr ImGuiWindowFlags only_drawn =
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoBackground |
        ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoBringToFrontOnFocus;
    ImGui::SetNextWindowPos({r.x, r.y});
    ImGui::SetNextWindowSize({r.w, r.h});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::Begin(name, nullptr, only_drawn);
    fill_box(ui, r, ui.palette.panel);  // opaque: lamps and labels below words make them hard to read
    line_box(ui, r, border, Corner::box, 1.25f);
}

void end_overlay() {
    compat::end_window();
    ImGui::PopStyleVar();
}

float card_width(const Ui& ui, Rect card) { return card.w - 2 * ui.px(side_padding); }

void gap(const Ui& ui, float layout_pixels) {
    ImGui::Dummy({1, std::max(0.0f, ui.px(layout_pixels) - ui.px(spacing::small))});
}

void progress_bar(const Ui& ui, float share, float below) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = card_width(ui), height = ui.px(4);
    fill_box(ui, {at.x, at.y, width, height}, ui.palette.raised, Corner::bar);
    if (share > 0) fill_box(ui, {at.x, at.y, width * share, height}, ui.palette.accent, Corner::bar);
    ImGui::Dummy({width, height + ui.px(below)});
}

void subheading(Ui& ui, std::string_view words) {
    // Window pixels: WholeLines lets a line of this height reach beyond the edge by less.
    constexpr float tolerated = 3;
    const float with_text =
        line_height(ui, Face::small) + ui.px(spacing::small) + line_height(ui, Face::text) + tolerated;
    const WholeLines whole(ImGui::GetCursorScreenPos().y, with_text);
    paragraph(ui, words, ui.palette.second_text, Face::small);
}

}  // namespace braitenlab::ui
