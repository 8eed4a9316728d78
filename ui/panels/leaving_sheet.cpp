// Before unsaved edits are left behind: save them, let them go, or stay.
#include <string>

#include <imgui.h>

#include "ui/panels/panels.h"
#include "ui/strings.h"
#include "ui/theme.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/sheet.h"

namespace braitenlab {

namespace {

std::string file_name(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

// Into the file that the scene came from, or under a name that the person gives first.
void save(const FilesView& files, PanelState& state, Ui& ui) {
    if (!files.save_to.empty()) return ui.outbox.push_back(LeaveRequest{Leave::save});
    state.leaving_done = files.done;
    begin_files(state.files, true);
    state.sheet = Sheet::files;
}

// The sheet for a name has come and gone: with what was asked for, or without.
void after_naming(const FilesView& files, PanelState& state, Ui& ui) {
    const bool saved = state.leaving_done >= 0 && files.done > state.leaving_done;
    state.leaving_done = -1;
    state.sheet = saved ? Sheet::leaving : Sheet::none;  // what is still unsaved is asked about again
    ui.outbox.push_back(LeaveRequest{saved ? Leave::saved : Leave::stay});
}

void words(const FilesView& files, Ui& ui) {
    const Leaving& leaving = *files.leaving;
    const Palette& p = ui.palette;
    paragraph(ui,
              leaving.next.empty() ? fill(ui.strings("leaving.exit"), {leaving.name})
                                   : fill(ui.strings("leaving.open"), {leaving.name, file_name(leaving.next)}),
              p.text);
    if (!files.refused.empty()) paragraph(ui, files.refused, legible(p.warning, p.panel, p.text));
}

}  // namespace

void leaving_sheet(const LabView& view, PanelState& state, Ui& ui, Rect window) {
    if (!view.files || !view.files->leaving) {
        if (state.sheet == Sheet::leaving) state.sheet = Sheet::none;
        state.leaving_asked = false;
        return;
    }
    const FilesView& files = *view.files;
    if (!state.leaving_asked) state.leaving_asked = true, state.leaving_done = -1, state.sheet = Sheet::leaving;
    if (state.sheet == Sheet::files && state.leaving_done >= 0) return;  // a name is being typed
    if (state.sheet != Sheet::leaving) return after_naming(files, state, ui);

    begin_sheet(ui, state.leaving, "card.leaving", ui.strings("leaving.heading"), 480, window);
    words(files, ui);
    sheet_buttons(ui, state.leaving);
    const Item yes =
        button(ui, "leaving.save",
               {{}, ui.strings(files.save_to.empty() ? "leaving.save_as" : "leaving.save"), Emphasis::primary});
    tooltip(ui, yes, files.save_to.empty() ? ui.strings("leaving.save_how") : std::string_view(files.save_to));
    ImGui::SameLine(0, ui.px(8));
    const Item no = button(ui, "leaving.discard", {{}, ui.strings("leaving.discard")});
    tooltip(ui, no, ui.strings("leaving.discard_how"));
    ImGui::SameLine(0, ui.px(8));
    const Item stay = button(ui, "leaving.stay", {{}, ui.strings("files.cancel"), Emphasis::quiet});
    tooltip(ui, stay, ui.strings("leaving.stay_how"), key_name({key::escape}, ui.strings));
    const bool beside = end_sheet(state.leaving);
    if (yes.pressed)
        save(files, state, ui);
    else if (no.pressed)
        ui.outbox.push_back(LeaveRequest{Leave::discard});
    else if (stay.pressed || beside)
        ui.outbox.push_back(LeaveRequest{Leave::stay});
}

}  // namespace braitenlab
