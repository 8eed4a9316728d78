#include "ui/widgets/card.h"

#include <algorithm>
#include <string>

#include "ui/imgui_compat.h"
#include "ui/strings.h"
#include "ui/theme.h"
#include "ui/widgets/item.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/paint.h"

namespace braitenlab {

namespace {

constexpr float side_padding = 16, heading_height = 36, bottom_padding = 12;  // layout pixels
constexpr float scrollbar_inset = 3;                                          // from the card's edge
constexpr ImGuiWindowFlags quiet = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBackground |
                                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoScrollWithMouse;

void begin_window(const char* name, Rect r) {
    ImGui::SetNextWindowPos({r.x, r.y});
    ImGui::SetNextWindowSize({r.w, r.h});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::Begin(name, nullptr, quiet);
    ImGui::PopStyleVar(2);
}

void heading_row(Ui& ui, CardState& state, std::string_view id, std::string_view words, Rect r) {
    const Item row = item(ui, std::string(id) + ".fold", {r.w, std::min(r.h, ui.px(heading_height))});
    const Colour colour = mix(ui.palette.second_text, ui.palette.text, row.warmth);
    const float y = row.rect.y + ui.px(heading_height) / 2;
    put(ui, {r.x + ui.px(side_padding), y - line_height(ui, Face::small) / 2}, words, colour, Face::small);
    put_icon(ui, {r.x + r.w - ui.px(side_padding + 4), y}, state.folded ? icon::folded : icon::unfolded, colour);
    tooltip(ui, row, ui.strings(state.folded ? "card.unfold" : "card.fold"));
    if (row.pressed) state.folded = !state.folded;
}

}  // namespace

float folded_height(const Ui& ui) { return ui.px(heading_height); }

float wanted_height(const Ui& ui, const CardState& state) {
    return state.folded ? folded_height(ui) : ui.px(heading_height + bottom_padding) + state.content;
}

void card_ground(const Ui& ui, Rect r, float rounding) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.PushClipRectFullScreen();
    for (int ring = 3; ring >= 1; --ring) {
        const float grown = ui.px(static_cast<float>(ring) * 2), lowered = ui.px(2);
        fill_box(ui, {r.x - grown, r.y - grown + lowered, r.w + 2 * grown, r.h + 2 * grown},
                 ui.palette.shadow.with_alpha(ui.palette.shadow.a * 0.10f), rounding + static_cast<float>(ring) * 2);
    }
    fill_box(ui, r, ui.palette.panel.with_alpha(0.92f), rounding);
    line_box(ui, r, ui.palette.line, rounding);
    draw.PopClipRect();
}

bool begin_card(Ui& ui, CardState& state, std::string_view id, std::string_view heading, Rect r) {
    begin_stops(ui.keyboard);
    begin_window(std::string(id).c_str(), r);
    card_ground(ui, r);
    mark(ui, id, r);
    heading_row(ui, state, id, heading, r);
    if (state.folded) return false;
    const float top = ui.px(heading_height), bottom = ui.px(bottom_padding);
    ImGui::SetCursorPos({ui.px(side_padding), top});
    // The scrollbar stands in the right padding, so that it never pushes the content.
    compat::begin_child("body",
                        {r.w - ui.px(side_padding) - ui.px(scrollbar_inset), std::max(1.0f, r.h - top - bottom)},
                        ImGuiWindowFlags_NoNav);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(8), ui.px(8)});
    ImGui::BeginGroup();
    return true;
}

void end_card(Ui& ui, CardState& state, bool open) {
    if (open) {
        ImGui::EndGroup();
        state.content = ImGui::GetItemRectSize().y;
        ImGui::PopStyleVar();
        ImGui::EndChild();
    }
    ImGui::End();
    (void)ui;
}

void begin_bar(Ui& ui, const char* name, Rect r) {
    begin_stops(ui.keyboard);
    begin_window(name, r);
    card_ground(ui, r, 0);
}

void end_bar() { ImGui::End(); }

float card_width(const Ui& ui) { return ImGui::GetWindowWidth() - ui.px(side_padding - scrollbar_inset); }

void gap(const Ui& ui, float layout_pixels) { ImGui::Dummy({1, std::max(0.0f, ui.px(layout_pixels) - ui.px(8))}); }

void subheading(Ui& ui, std::string_view words) { paragraph(ui, words, ui.palette.second_text, Face::small); }

}  // namespace braitenlab
