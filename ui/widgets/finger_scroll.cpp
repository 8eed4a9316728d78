#include "ui/widgets/finger_scroll.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>
#include <imgui_internal.h>

#include "ui/widgets/ui.h"

namespace braitenlab::ui {

namespace {

constexpr float scroll_begins = 10;  // layout pixels; a shorter way is a press

// The part below the pointer that can be scrolled up or down; 0: none.
unsigned part_below_pointer() {
    const ImGuiWindow* part = ImGui::GetCurrentContext()->HoveredWindow;
    while (part && part->ScrollMax.y <= 0) part = part->ParentWindow;
    return part ? part->ID : 0;
}

}  // namespace

void scroll_by_finger(FingerScroll& state, const Ui& ui, bool free) {
    const ImGuiIO& io = ImGui::GetIO();
    if (ui.finger <= 0 || !io.MouseDown[0]) {
        state = {};
        return;
    }
    if (ImGui::IsMouseClicked(0)) state = {part_below_pointer(), false};
    ImGuiWindow* const part = ImGui::FindWindowByID(state.part);
    if (!part || !free) return;
    const float across = std::fabs(io.MousePos.x - io.MouseClickedPos[0].x);
    const float down = std::fabs(io.MousePos.y - io.MouseClickedPos[0].y);
    if (!state.moves && down > ui.px(scroll_begins) && down > across) {
        state.moves = true;
        ImGui::ClearActiveID();  // the widget that was pressed
    }
    if (state.moves) ImGui::SetScrollY(part, std::clamp(part->Scroll.y - io.MouseDelta.y, 0.0f, part->ScrollMax.y));
}

}  // namespace braitenlab::ui
