// The sheet of preferences: language, theme, type size, motion, picture quality.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <imgui.h>

#include "ui/panels/cards.h"
#include "ui/panels/panels.h"
#include "ui/panels/sheets.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/paint.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr std::array<float, 4> type_sizes{1, 1.25f, 1.5f, 2};

// A choice below its heading. The index that was clicked, or -1.
int choose(Ui& ui, std::string_view id, std::string_view heading, std::span<const std::string_view> words, int chosen,
           std::string_view how) {
    subheading(ui, heading);
    const int clicked = segments(ui, id, words, chosen, card_width(ui), how);
    gap(ui, 12);
    return clicked;
}

void language_choice(const LabView& view, Ui& ui, Preferences& wanted) {
    if (!view.program.languages || view.program.languages->empty()) return;
    std::vector<std::string_view> names;
    int chosen = -1;
    for (const Language& each : *view.program.languages) {
        if (each.code == wanted.language) chosen = static_cast<int>(names.size());
        names.push_back(each.name);
    }
    const int clicked = choose(ui, "settings.language", ui.strings("settings.language"), names, chosen,
                               ui.strings("settings.language_how"));
    if (clicked >= 0) wanted.language = (*view.program.languages)[static_cast<std::size_t>(clicked)].code;
}

void theme_choice(Ui& ui, Preferences& wanted) {
    const std::array<std::string_view, 2> words{ui.strings("settings.dark"), ui.strings("settings.light")};
    const int clicked = choose(ui, "settings.theme", ui.strings("settings.theme"), words,
                               wanted.theme == Theme::light ? 1 : 0, ui.strings("settings.theme_how"));
    if (clicked >= 0) wanted.theme = clicked == 1 ? Theme::light : Theme::dark;
}

std::string percent(float share) { return std::to_string(std::lround(100 * share)); }

void type_size_choice(const LabView& view, Ui& ui, Preferences& wanted) {
    constexpr std::array<std::string_view, 4> words{"100 %", "125 %", "150 %", "200 %"};
    int chosen = -1;
    for (std::size_t i = 0; i < type_sizes.size(); ++i)
        if (wanted.type_size == type_sizes[i]) chosen = static_cast<int>(i);
    const int clicked =
        choose(ui, "settings.type", ui.strings("settings.type"), words, chosen, ui.strings("settings.type_how"));
    if (view.program.type_size > 0) {
        paragraph(
            ui, fill(ui.strings("settings.type_reduced"), {percent(view.program.type_size), percent(wanted.type_size)}),
            colour_of(NoticeKind::notice, ui.palette), Face::small);
        gap(ui, 12);
    }
    if (clicked >= 0) wanted.type_size = type_sizes[static_cast<std::size_t>(clicked)];
}

void motion_choice(Ui& ui, Preferences& wanted) {
    const std::array<std::string_view, 2> words{ui.strings("settings.full_motion"), ui.strings("settings.less_motion")};
    const int clicked = choose(ui, "settings.motion", ui.strings("settings.motion"), words,
                               wanted.reduce_motion ? 1 : 0, ui.strings("settings.motion_how"));
    if (clicked >= 0) wanted.reduce_motion = clicked == 1;
}

void quality_choice(const LabView& view, Ui& ui, Preferences& wanted) {
    const std::array<std::string_view, 4> words{ui.strings("settings.quality_auto"), ui.strings("settings.quality_low"),
                                                ui.strings("settings.quality_medium"),
                                                ui.strings("settings.quality_high")};
    const int chosen = wanted.quality ? 1 + static_cast<int>(*wanted.quality) : 0;
    subheading(ui, ui.strings("settings.quality"));
    const int clicked =
        segments(ui, "settings.quality", words, chosen, card_width(ui), ui.strings("settings.quality_how"));
    const std::array<std::string_view, 3> levels{ui.strings("settings.quality_is_low"),
                                                 ui.strings("settings.quality_is_medium"),
                                                 ui.strings("settings.quality_is_high")};
    const std::string about = wanted.quality
                                  ? std::string(levels[static_cast<std::size_t>(*wanted.quality)])
                                  : fill(ui.strings("settings.quality_now"),
                                         {std::string(words[1 + static_cast<std::size_t>(view.program.quality)])});
    gap(ui, 4);
    paragraph(ui, about, ui.palette.second_text, Face::small);
    gap(ui, 12);
    if (clicked >= 0) wanted.quality = clicked == 0 ? std::nullopt : std::optional(static_cast<Quality>(clicked - 1));
}

// Resets preferences and cards to their state at the first start. A second button restores the preferences.
void reset_all(const LabView& view, PanelState& state, Ui& ui, Preferences& wanted) {
    Preferences fresh;
    fresh.language = view.program.native_language;
    if (wanted != fresh) state.sheets.before_reset.reset();  // changed since the reset
    ImGui::SameLine(0, ui.px(spacing::small));
    if (state.sheets.before_reset) {
        if (push_button(ui, "settings.restore", {{}, ui.strings("settings.restore")},
                        ui.strings("settings.restore_how"))) {
            wanted = *state.sheets.before_reset;
            state.sheets.before_reset.reset();
        }
        return;
    }
    ButtonLook look{{}, ui.strings("settings.reset")};
    look.enabled = wanted != fresh;
    if (!push_button(ui, "settings.reset", look, ui.strings("settings.reset_how"))) return;
    state.sheets.before_reset = wanted;
    wanted = fresh;
    reset_cards(state);
    state.prompts.followed = {};
}

}  // namespace

void settings_card(const LabView& view, PanelState& state, Ui& ui, Rect window) {
    Preferences wanted = view.program.preferences;
    SheetState& sheet = open_sheet(state, ui, Sheet::settings, window);
    language_choice(view, ui, wanted);
    theme_choice(ui, wanted);
    type_size_choice(view, ui, wanted);
    motion_choice(ui, wanted);
    quality_choice(view, ui, wanted);
    sheet_buttons(ui, sheet);
    const bool closed = close_button(ui, "settings.close");
    reset_all(view, state, ui, wanted);
    if (wanted != view.program.preferences) ui.outbox.push_back(PreferencesRequest{wanted});
    if (end_sheet(sheet) || closed) state.sheet = Sheet::none;
}

}  // namespace braitenlab::ui
