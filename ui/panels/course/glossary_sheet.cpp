// The sheet of the whole glossary: the list of all terms, and the sentence and the picture of the chosen one.
#include <algorithm>
#include <string>

#include <imgui.h>

#include "ui/imgui_compat.h"
#include "ui/panels/panels.h"
#include "ui/panels/sheets.h"
#include "ui/shortcuts.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr float list_width = 190, row_height = 24;  // layout pixels

void term_row(Ui& ui, GlossaryState& state, const GlossaryTerm& term, bool focus_chooses) {
    const std::string name(ui.strings("glossary." + std::string(term.id) + ".name"));
    const Item at = item(ui, "glossary." + std::string(term.id), {ui.px(list_width), ui.px(ui.tall(row_height))});
    const bool chosen = state.shown == term.id;
    if (chosen || at.warmth > 0)
        fill_box(ui, at.rect, mix(ui.palette.raised, ui.palette.accent, chosen ? 0.25f : 0.15f * at.warmth),
                 Corner::box);
    put(ui, {at.rect.x + ui.px(8), at.middle_y() - line_height(ui, Face::text) / 2},
        shortened(ui, name, chosen ? Face::strong : Face::text, at.rect.w - ui.px(16)), ui.palette.text,
        chosen ? Face::strong : Face::text);
    tooltip(ui, at, ui.strings("glossary.show_how"));
    if (at.pressed || (focus_chooses && at.focused)) state.shown = term.id;
}

}  // namespace

void glossary_sheet(const LabView& view, PanelState& panels, Ui& ui, Rect window) {
    GlossaryState& state = panels.glossary;
    if (!find_term(state.shown)) state.shown = terms().front().id;
    SheetState& sheet = open_sheet(panels, ui, Sheet::glossary, window);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(spacing::large), ui.px(spacing::hair)});
    const float top = ImGui::GetCursorPosY();
    ImGui::BeginGroup();
    const bool by_key = ui.keyboard && ui.keyboard->shown;
    for (const GlossaryTerm& term : terms()) term_row(ui, state, term, by_key);
    compat::end_group();
    ImGui::SameLine();
    ImGui::SetCursorPosY(std::max(top, ImGui::GetScrollY()));  // in view while the list scrolls
    ImGui::BeginGroup();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(spacing::small), ui.px(spacing::small)});
    const float width = std::min(ui.px(400), card_width(ui) - ui.px(list_width + 16));
    const GlossaryTerm& shown = *find_term(state.shown);
    paragraph(ui, ui.strings("glossary." + state.shown + ".name"), ui.palette.text, Face::title, width);
    draw_entry(view, ui, shown, width);
    ImGui::PopStyleVar();
    compat::end_group();
    ImGui::PopStyleVar();
    sheet_buttons(ui, sheet);
    const bool closed = close_button(ui, "glossary.close");
    if (end_sheet(sheet) || closed) panels.sheet = Sheet::none;
}

}  // namespace braitenlab::ui
