// The two sheets about unsaved edits: before the scene is closed, and after a crash.
#include <ctime>
#include <filesystem>
#include <string>

#include <imgui.h>

#include "ui/panels/exercise_names.h"
#include "ui/panels/panels.h"
#include "ui/panels/sheets.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

// Saves to the file of the scene. If there is none, opens the file browser for a name; of an exercise its brain is
// saved.
void save_before_leaving(const LabView& view, PanelState& state, Ui& ui) {
    const FilesView& files = *view.documents.files;
    if (!files.save_to.empty()) return ui.outbox.push_back(LeaveRequest{Leave::save});
    state.sheets.unsaved.leaving_done = files.done;
    begin_files(state.sheets.files, true, view.lesson ? FileKind::brain : FileKind::scene);
    state.sheet = Sheet::files;
}

// Handles the end of the file browser, with or without a saved file.
void after_naming(const FilesView& files, PanelState& state, Ui& ui) {
    const bool saved = state.sheets.unsaved.leaving_done >= 0 && files.done > state.sheets.unsaved.leaving_done;
    state.sheets.unsaved.leaving_done = -1;
    state.sheet = saved ? Sheet::leaving : Sheet::none;  // the sheet opens again if edits are still unsaved
    ui.outbox.push_back(LeaveRequest{saved ? Leave::saved : Leave::stay});
}

void leaving_question(const LabView& view, Ui& ui) {
    const FilesView& files = *view.documents.files;
    const Leaving& leaving = *files.leaving;
    const Palette& p = ui.palette;
    if (leaving.passed) paragraph(ui, ui.strings("leaving.passed"), p.text);
    if (!leaving.passed)
        paragraph(ui,
                  leaving.next.empty() ? fill(ui.strings("leaving.exit"), {known_title(view, ui, leaving.title)})
                                       : fill(ui.strings("leaving.open"), {known_title(view, ui, leaving.title),
                                                                           known_title(view, ui, leaving.next_title)}),
                  p.text);
    if (view.lesson && !leaving.passed) paragraph(ui, ui.strings("leaving.of_exercise"), p.second_text, Face::small);
    if (files.refused) paragraph(ui, text_of(*files.refused, ui.strings), legible(p.warning, p.panel, p.text));
}

// "2026-03-01", local time.
std::string local_day() {
    char text[16] = {};
    const std::time_t now = std::time(nullptr);
    if (const std::tm* local = std::localtime(&now)) std::strftime(text, sizeof text, "%Y-%m-%d", local);
    return text;
}

// The name of a file; the pointer over it shows its folder.
void file_row(Ui& ui, const std::string& path) {
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const std::string name = std::filesystem::path(path).filename().string();
    const Item at = item(ui, "recovery.file", {card_width(ui), line_height(ui, Face::small)}, false);
    put(ui, start, shortened(ui, name, Face::small, at.rect.w), ui.palette.second_text, Face::small);
    tooltip(ui, at, path);
}

}  // namespace

std::string time_words(const Ui& ui, const std::string& when, const std::string& today) {
    constexpr std::size_t day = 10, minute = 16;  // characters
    if (when.size() < minute) return when;
    const std::string clock = when.substr(day + 1, minute - day - 1);
    if (when.starts_with(today)) return fill(ui.strings("recovery.today"), {clock});
    return fill(ui.strings("recovery.day"), {when.substr(0, day), clock});
}

void follow_leaving(const LabView& view, PanelState& state, Ui& ui) {
    if (!view.documents.files || !view.documents.files->leaving) {
        if (state.sheet == Sheet::leaving) state.sheet = Sheet::none;
        state.sheets.unsaved.leaving_asked = false;
        return;
    }
    if (!state.sheets.unsaved.leaving_asked)
        state.sheets.unsaved.leaving_asked = true, state.sheets.unsaved.leaving_done = -1, state.sheet = Sheet::leaving;
    if (state.sheet == Sheet::files && state.sheets.unsaved.leaving_done >= 0) return;  // a name is being typed
    if (state.sheet != Sheet::leaving) after_naming(*view.documents.files, state, ui);
}

void leaving_sheet(const LabView& view, PanelState& state, Ui& ui, Rect window) {
    const FilesView& files = *view.documents.files;
    SheetState& sheet = open_sheet(state, ui, Sheet::leaving, window);
    leaving_question(view, ui);
    sheet_buttons(ui, sheet);
    const bool yes =
        push_button(ui, "leaving.save",
                    {{}, ui.strings(files.save_to.empty() ? "leaving.save_as" : "leaving.save"), Emphasis::primary},
                    files.save_to.empty() ? ui.strings("leaving.save_how") : std::string_view(files.save_to));
    ImGui::SameLine(0, ui.px(spacing::small));
    const bool no =
        push_button(ui, "leaving.discard", {{}, ui.strings("leaving.discard")}, ui.strings("leaving.discard_how"));
    ImGui::SameLine(0, ui.px(spacing::small));
    const Item stay = button(ui, "leaving.stay", {{}, ui.strings("files.cancel"), Emphasis::quiet});
    tooltip(ui, stay, ui.strings("leaving.stay_how"), key_name({key::escape}, ui.strings));
    const bool beside = end_sheet(sheet);
    if (yes)
        save_before_leaving(view, state, ui);
    else if (no)
        ui.outbox.push_back(LeaveRequest{Leave::discard});
    else if (stay.pressed || beside)
        ui.outbox.push_back(LeaveRequest{Leave::stay});
}

void follow_recovery(const LabView& view, PanelState& state, Ui&) {
    if (!view.documents.recovery) state.sheets.unsaved.recovery_asked = false;
    if (view.lecture) {  // asked after the lecture
        if (state.sheet == Sheet::recovery) state.sheet = Sheet::none, state.sheets.unsaved.recovery_asked = false;
        return;
    }
    if (view.documents.recovery && !state.sheets.unsaved.recovery_asked)
        state.sheets.unsaved.recovery_asked = true, state.sheet = Sheet::recovery;
    if (!view.documents.recovery && state.sheet == Sheet::recovery) state.sheet = Sheet::none;
}

void recovery_sheet(const LabView& view, PanelState& state, Ui& ui, Rect window) {
    SheetState& sheet =
        open_sheet(state, ui, Sheet::recovery, window,
                   ui.strings(view.documents.recovery->ended ? "recovery.heading_ended" : "recovery.heading"));
    paragraph(ui,
              fill(ui.strings("recovery.what"), {known_title(view, ui, view.documents.recovery->title),
                                                 time_words(ui, view.documents.recovery->when, local_day())}),
              ui.palette.text);
    if (!view.documents.recovery->file.empty()) file_row(ui, view.documents.recovery->file);
    sheet_buttons(ui, sheet);
    const bool take = push_button(ui, "recovery.take", {{}, ui.strings("recovery.take"), Emphasis::primary},
                                  ui.strings("recovery.take_how"));
    ImGui::SameLine(0, ui.px(spacing::small));
    const bool discard =
        push_button(ui, "recovery.discard", {{}, ui.strings("recovery.discard")}, ui.strings("recovery.discard_how"));
    ImGui::SameLine(0, ui.px(spacing::small));
    const bool later = push_button(ui, "recovery.later", {{}, ui.strings("recovery.later"), Emphasis::quiet},
                                   ui.strings("recovery.later_how"), key_name({key::escape}, ui.strings));
    if (take || discard) ui.outbox.push_back(RecoverRequest{take});
    (void)end_sheet(sheet);  // a click beside it decides nothing
    if (later) state.sheet = Sheet::none;
}

}  // namespace braitenlab::ui
