#include "ui/widgets/whole_lines.h"

#include <algorithm>
#include <cmath>

#include "ui/imgui_compat.h"
#include "ui/widgets/paint.h"

namespace braitenlab::ui {

WholeLines::WholeLines(float top, float line) {
    constexpr float above = 0.2f, below = 0.04f;  // of the height of a line, without letters
    const ImGuiWindow& window = *ImGui::GetCurrentWindowRead();
    if (window.ScrollMax.y <= 0 || line <= 0) return;
    const ImVec2 low = window.DrawList->GetClipRectMin(), high = window.DrawList->GetClipRectMax();
    const float first = std::max(0.0f, std::ceil((low.y - top) / line - above));
    const float end = std::floor((high.y - top) / line + below);
    const ImVec2 from{low.x, std::max(low.y, top + first * line)}, to{high.x, std::min(high.y, top + end * line)};
    ImGui::PushClipRect(from, {to.x, std::max(from.y, to.y)}, true);
    narrowed_ = true;
}

WholeLines::~WholeLines() {
    if (narrowed_) ImGui::PopClipRect();
}

void shade_edges(const Ui& ui) {
    const ImGuiWindow& window = *ImGui::GetCurrentWindowRead();
    const float height = ui.px(20), hidden = ui.px(4);  // what is less than this is space below the content
    const ImVec2 low = window.InnerClipRect.Min, high = window.InnerClipRect.Max;
    if (window.ScrollMax.y <= hidden || high.y - low.y < 3 * height) return;
    const ImU32 full = paint(ui.palette.panel), none = paint(ui.palette.panel.with_alpha(0));
    if (window.Scroll.y > hidden)
        window.DrawList->AddRectFilledMultiColor(low, {high.x, low.y + height}, full, full, none, none);
    if (window.ScrollMax.y - window.Scroll.y > hidden)
        window.DrawList->AddRectFilledMultiColor({low.x, high.y - height}, high, none, none, full, full);
}

}  // namespace braitenlab::ui
