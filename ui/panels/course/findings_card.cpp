// What the check of an exercise has found, for its author: the same as `braitenctl check` prints.
#include <array>
#include <filesystem>
#include <string>

#include <imgui.h>

#include "ui/panels/cards.h"
#include "ui/panels/panels.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/measure_text.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

// "strike.toml:12: …", without the folder.
std::string words_of_finding(const Finding& finding, const Ui& ui) {
    Notice said = finding.said;
    if (said.error) said.error->file = std::filesystem::path(said.error->file).filename().string();
    std::string words = text_of(said, ui.strings);
    for (const Measure& measure : finding.measures) {
        const std::string value = measure_text(ui.strings, measure, false);
        if (!value.empty()) words += "; " + value;
    }
    return words;
}

void finding_row(const Finding& finding, Ui& ui) {
    constexpr float beside_sign = 20;
    const Colour colour = colour_of(finding.said.kind, ui.palette);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float aside = has_icons(ui) ? ui.px(beside_sign) : 0.0f;
    put_icon(ui, {at.x + ui.px(spacing::small), at.y + line_height(ui, Face::small) / 2}, sign_of(finding.said.kind),
             colour, Face::small);
    ImGui::SetCursorScreenPos({at.x + aside, at.y});
    paragraph(ui, words_of_finding(finding, ui), ui.palette.text, Face::small, card_width(ui) - aside);
    ImGui::SetCursorScreenPos({at.x, ImGui::GetCursorScreenPos().y + ui.px(spacing::tight)});
}

}  // namespace

void findings_card(const LabView& view, PanelState& state, Ui& ui, Rect place, Rect) {
    std::array buttons{HeadingButton{.id = "findings.close",
                                     .words = ui.strings("findings.close"),
                                     .tooltip = ui.strings("findings.close_how"),
                                     .icon = icon::cross}};
    if (open_card(state, ui, Card::findings, place, buttons)) {
        if (view.documents.has_draft) {
            if (push_button(ui, "findings.edit", {{}, ui.strings("findings.edit"), Emphasis::primary},
                            ui.strings("tooltip.edit_again")))
                state.chosen.push_back(Action::edit_again);
            gap(ui, spacing::small);
        }
        for (const Finding& finding : *view.findings) finding_row(finding, ui);
    }
    end_card(ui, state.card(Card::findings));
    if (buttons[0].pressed) ui.outbox.emplace_back(HideFindingsRequest{});
}

}  // namespace braitenlab::ui
