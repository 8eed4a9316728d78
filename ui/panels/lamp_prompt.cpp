// A pulsing ring round the lamp that a newcomer may drag.
#include <imgui.h>

#include "render/view/pick.h"
#include "ui/panels/panels.h"
#include "ui/prompts.h"
#include "ui/theme.h"
#include "ui/widgets/paint.h"

namespace braitenlab {

void point_to_lamp(const LabView& view, Ui& ui) {
    if (ui.highlight != lamp_anchor || !view.sight || view.now->sources.empty()) return;
    const SourceView& lamp = view.now->sources.front();
    const auto at = project(*view.sight, {lamp.x, lamp.y}, bulb_height);
    if (!at) return;
    const float radius = ui.px(18 + 4 * ui.pulse);
    ImGui::GetBackgroundDrawList()->AddCircle(
        {at->x, at->y}, radius, paint(ui.palette.accent.with_alpha(0.4f + 0.6f * ui.pulse)), 48, ui.px(2.5f));
    ui.anchors.record(lamp_anchor, {at->x - radius, at->y - radius, 2 * radius, 2 * radius});
}

}  // namespace braitenlab
