// After a crash: whether to go on with what was kept.
#include <string>

#include <imgui.h>

#include "ui/panels/panels.h"
#include "ui/strings.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/sheet.h"

namespace braitenlab {

void recovery_sheet(const LabView& view, PanelState& state, Ui& ui, Rect window) {
    if (!view.recovery) state.recovery_asked = false;
    if (view.recovery && !state.recovery_asked) state.recovery_asked = true, state.sheet = Sheet::recovery;
    if (state.sheet != Sheet::recovery) return;
    if (!view.recovery) {
        state.sheet = Sheet::none;
        return;
    }
    begin_sheet(ui, state.recovery, "card.recovery",
                ui.strings(view.recovery->ended ? "recovery.heading_ended" : "recovery.heading"), 460, window);
    paragraph(ui, fill(ui.strings("recovery.what"), {view.recovery->name, view.recovery->when}), ui.palette.text);
    sheet_buttons(ui, state.recovery);
    const Item take = button(ui, "recovery.take", {{}, ui.strings("recovery.take"), Emphasis::primary});
    tooltip(ui, take, ui.strings("recovery.take_how"));
    ImGui::SameLine(0, ui.px(8));
    const Item discard = button(ui, "recovery.discard", {{}, ui.strings("recovery.discard")});
    tooltip(ui, discard, ui.strings("recovery.discard_how"));
    ImGui::SameLine(0, ui.px(8));
    const Item later = button(ui, "recovery.later", {{}, ui.strings("recovery.later"), Emphasis::quiet});
    tooltip(ui, later, ui.strings("recovery.later_how"), key_name({key::escape}, ui.strings));
    if (take.pressed || discard.pressed) ui.outbox.push_back(RecoverRequest{take.pressed});
    if (end_sheet(state.recovery) || later.pressed) state.sheet = Sheet::none;
}

}  // namespace braitenlab
