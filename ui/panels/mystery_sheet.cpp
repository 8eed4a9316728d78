// The sheet of the mystery brain: hide a brain, build another in the same body, and compare both on starts that were
// not seen.
#include <algorithm>
#include <string>
#include <vector>

#include <imgui.h>

#include "ui/panels/panels.h"
#include "ui/panels/scene_picture.h"
#include "ui/panels/sheets.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

using insight::MysteryScore;
using insight::MysteryStart;

// Layout pixels.
constexpr float between_starts = spacing::small, most_start = 150;
constexpr std::size_t starts_per_row = 5;

std::vector<maths::vec2> places(const insight::Path& path) {
    constexpr std::size_t ticks_per_place = 6;
    std::vector<maths::vec2> all;
    for (std::size_t i = 0; i < path.size(); ++i)
        if (i % ticks_per_place == 0 || i + 1 == path.size()) all.push_back({path[i].x, path[i].y});
    return all;
}

// Not across the seam of a torus. Dashes: every second piece.
void draw_places(const std::vector<maths::vec2>& all, const FloorMap& map, Colour colour, float width, bool dashed) {
    constexpr float jump = 2;  // m
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    for (std::size_t i = 1; i < all.size(); ++i)
        if (maths::distance(all[i - 1], all[i]) < jump && (!dashed || i / 3 % 2 == 0))
            draw.AddLine(map(all[i - 1]), map(all[i]), paint(colour), width);
    if (!all.empty()) draw.AddCircleFilled(map(all.back()), 1.5f * width, paint(colour));
}

void start_of_mystery(const Scene& scene, const MysteryStart& start, std::size_t number, Ui& ui, ImVec2 size) {
    const Item at = item(ui, "mystery.start." + std::to_string(number + 1), size, false);
    fill_box(ui, at.rect, ui.palette.raised, Corner::box);
    line_box(ui, at.rect, ui.palette.line, Corner::box);
    const float inset = ui.px(spacing::tight);
    const Rect inner{at.rect.x + inset, at.rect.y + inset, at.rect.w - 2 * inset, at.rect.h - 2 * inset};
    const maths::vec2 half{scene.arena.width / 2, scene.arena.height / 2};
    const FloorMap map({-half, half}, inner);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.PushClipRect({inner.x, inner.y}, {inner.x + inner.w, inner.y + inner.h}, true);
    draw_floor(ui, scene, map);
    draw_places(places(start.hidden), map, ui.palette.slot_a, ui.px(2.5f), false);
    draw_places(places(start.rebuilt), map, ui.palette.slot_b, ui.px(2), true);
    draw.PopClipRect();
    if (at.hovered)
        tooltip(ui, at,
                fill(ui.strings("mystery.start_how"), {fixed(ui, start.gap, 1), fixed(ui, start.random_gap, 1)}));
}

void starts_of_mystery(const MysteryView& view, Ui& ui) {
    const Arena& arena = view.scene->arena;
    const float space = ui.px(between_starts);
    const auto count = static_cast<float>(starts_per_row);
    const float width = std::min((card_width(ui) - (count - 1) * space) / count, ui.px(most_start));
    const ImVec2 size{width, width * std::clamp(arena.height / arena.width, 0.5f, 1.0f)};
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {space, space});
    for (std::size_t i = 0; i < view.score->starts.size(); ++i) {
        if (i % starts_per_row != 0) ImGui::SameLine();
        start_of_mystery(*view.scene, view.score->starts[i], i, ui, size);
    }
    ImGui::PopStyleVar();
}

// "72 of 100", and what it is made of.
void score_of_mystery(const MysteryScore& score, Ui& ui) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const std::string words = fill(ui.strings("mystery.score"), {std::to_string(score.score)});
    const float height = line_height(ui, Face::display), width = text_width(ui, Face::display, words);
    put(ui, at, words, ui.palette.text, Face::display);
    mark(ui, "mystery.score", {at.x, at.y, width, height});
    ImGui::Dummy({width, height});
    paragraph(ui,
              fill(ui.strings("mystery.made_of"),
                   {fixed(ui, score.gap, 2), fixed(ui, score.random_gap, 2), fixed(ui, score.still_gap, 2)}),
              ui.palette.second_text, Face::small);
}

void legend_of_mystery(Ui& ui) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float line = line_height(ui, Face::small), length = ui.px(24), gap_width = ui.px(6);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float y = at.y + line / 2;
    draw.AddLine({at.x, y}, {at.x + length, y}, paint(ui.palette.slot_a), ui.px(2.5f));
    float x = at.x + length + gap_width;
    x += put(ui, {x, at.y}, ui.strings("mystery.hidden_path"), ui.palette.text, Face::small) + ui.px(20);
    for (const float from : {0.0f, 0.6f})
        draw.AddLine({x + from * length, y}, {x + (from + 0.4f) * length, y}, paint(ui.palette.slot_b), ui.px(2));
    put(ui, {x + length + gap_width, at.y}, ui.strings("mystery.rebuilt_path"), ui.palette.text, Face::small);
    ImGui::Dummy({card_width(ui), line});
}

// True where the buttons of a hidden brain are wider than the sheet.
bool is_narrow(const Ui& ui, const SheetState& sheet) {
    float width = 2 * ui.px(side_padding);
    for (const char* words : {"mystery.compare", "mystery.rebuild", "mystery.reveal"})
        width += button_width(ui, {icon::play, ui.strings(words)}) + ui.px(spacing::small);
    return width + button_width(ui, {{}, ui.strings("keys.close")}) > sheet.rect.w;
}

// True if the sheet closes.
bool mystery_buttons(const LabView& lab, Ui& ui, bool compact) {
    const MysteryView& view = lab.features.mystery;
    const bool may_edit = !lab.lesson;
    const auto offer = [&](const char* id, std::string_view sign, MysteryEdit edit, bool enabled, bool primary) {
        ButtonLook look{sign, ui.strings(id), primary ? Emphasis::primary : Emphasis::plain};
        look.enabled = enabled, look.compact = compact;
        const bool pressed = push_button(ui, id, look, ui.strings(std::string(id) + "_how"));
        if (pressed) ui.outbox.emplace_back(MysteryRequest{edit});
        ImGui::SameLine();
        return pressed;
    };
    const bool is_hidden = view.hidden != no_vehicle;
    bool closes = false;
    if (!is_hidden && may_edit)
        offer("mystery.hide", icon::sensors, MysteryEdit::hide, view.rebuilt != no_vehicle, true);
    if (is_hidden) {
        offer("mystery.compare", icon::play, MysteryEdit::score, view.rebuilt != no_vehicle && !view.is_computing,
              view.rebuilt != no_vehicle);
        if (may_edit)
            closes = offer("mystery.rebuild", icon::add, MysteryEdit::rebuild, true, view.rebuilt == no_vehicle);
        if (may_edit) offer("mystery.reveal", icon::sensors, MysteryEdit::reveal, true, false);
    }
    return close_button(ui, "mystery.close", Emphasis::plain) || closes;
}

}  // namespace

void mystery_sheet(const LabView& lab, PanelState& state, Ui& ui, Rect window) {
    const MysteryView& view = lab.features.mystery;
    SheetState& sheet = open_sheet(state, ui, Sheet::mystery, window);
    paragraph(ui, ui.strings(view.hidden == no_vehicle ? "mystery.story" : "mystery.steps"), ui.palette.text);
    if (view.error) paragraph(ui, text_of(*view.error, ui.strings), ui.palette.warning);
    gap(ui, 8);
    if (view.is_computing) {
        paragraph(ui, ui.strings("mystery.computing"), ui.palette.second_text, Face::small);
        progress_bar(ui, view.progress);
    }
    if (view.score && view.scene && !view.is_computing) {
        score_of_mystery(*view.score, ui);
        gap(ui, 8);
        legend_of_mystery(ui);
        starts_of_mystery(view, ui);
    }
    sheet_buttons(ui, sheet);
    const bool closed = mystery_buttons(lab, ui, is_narrow(ui, sheet));
    if (end_sheet(sheet) || closed) state.sheet = Sheet::none;
}

}  // namespace braitenlab::ui
