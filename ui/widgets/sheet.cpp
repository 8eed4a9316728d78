#include "ui/widgets/sheet.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <imgui.h>

#include "ui/imgui_compat.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/whole_lines.h"

namespace braitenlab::ui {

namespace {

constexpr float sheet_pad = spacing::large, least_margin = spacing::medium, sheet_scrollbar_inset = 3;  // layout pixels

float sheet_heading(const Ui& ui) { return line_height(ui, Face::title) + ui.px(sheet_pad); }
float sheet_row(const Ui& ui) { return ui.px(ui.tall(button_height) + sheet_pad); }

}  // namespace

void begin_sheet(Ui& ui, SheetState& state, std::string_view id, std::string_view heading, float layout_width,
                 Rect window) {
    const float margin = ui.px(least_margin),
                around = sheet_heading(ui) + state.footer + sheet_row(ui) + 2 * ui.px(sheet_pad);
    const float w = std::min(ui.px(layout_width), window.w - 2 * margin);
    const float h = std::min((state.fixed > 0 ? state.fixed : state.content) + around, window.h - 2 * margin);
    const Rect r{window.x + std::floor((window.w - w) / 2), window.y + std::floor((window.h - h) / 2), w, h};

    begin_bar(ui, std::string(id).c_str(), window, true);
    hold_keyboard(ui.keyboard);
    fill_box(ui, window, ui.palette.ground.with_alpha(0.55f), Corner::square);
    card_ground(ui, r);
    fill_box(ui, r, ui.palette.panel);  // opaque, so that words below do not show through
    line_box(ui, r, ui.palette.line);
    const float room = w - 2 * ui.px(sheet_pad);
    const Face face = text_width(ui, Face::title, heading) <= room ? Face::title : Face::strong;
    put(ui, {r.x + ui.px(sheet_pad), r.y + ui.px(sheet_pad)}, shortened(ui, heading, face, room), ui.palette.text,
        face);
    mark(ui, id, r);
    state.rect = r;
    ImGui::SetCursorScreenPos({r.x + ui.px(sheet_pad), r.y + ui.px(sheet_pad) + sheet_heading(ui)});
    compat::begin_child("body", {w - ui.px(sheet_pad + sheet_scrollbar_inset), std::max(1.0f, h - around)},
                        ImGuiWindowFlags_NoNav);
    const float page = std::max(1.0f, h - around - line_height(ui, Face::text));
    if (const float pages = std::exchange(state.scroll, 0.0f); pages != 0)
        ImGui::SetScrollY(
            std::clamp(ImGui::GetScrollY() + pages * page, 0.0f, std::max(0.0f, state.content - h + around)));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(spacing::small), ui.px(spacing::small)});
    ImGui::BeginGroup();
}

void sheet_buttons(Ui& ui, SheetState& state, std::string_view problem) {
    compat::end_group();
    shade_edges(ui);
    const float measured = ImGui::GetItemRectSize().y;
    state.is_resized = std::abs(measured - std::exchange(state.content, measured)) > 1;
    ImGui::PopStyleVar();
    compat::end_child();
    const Rect& r = state.rect;
    const ImVec2 buttons{r.x + ui.px(sheet_pad), r.y + r.h - ui.px(sheet_pad + ui.tall(button_height))};
    const float width = r.w - 2 * ui.px(sheet_pad), line = line_height(ui, Face::text);
    const auto lines = problem.empty() ? std::vector<std::string>{} : lines_of_words(ui, problem, Face::text, width);
    float y = buttons.y - state.footer;
    for (const std::string& each : lines) {
        put(ui, {buttons.x, y}, each, legible(ui.palette.warning, ui.palette.panel, ui.palette.text));
        y += line;
    }
    const float height = lines.empty() ? 0 : static_cast<float>(lines.size()) * line + ui.px(spacing::small);
    state.is_resized |= std::abs(height - std::exchange(state.footer, height)) > 1;
    ImGui::SetCursorScreenPos(buttons);
}

bool end_sheet(const SheetState& state) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const bool beside = ImGui::IsMouseClicked(0) && !state.rect.contains(mouse.x, mouse.y);
    end_bar();
    return beside;
}

}  // namespace braitenlab::ui
