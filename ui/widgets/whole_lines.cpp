#include "ui/widgets/whole_lines.h"

#include <algorithm>
#include <cmath>

#include "ui/imgui_compat.h"

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

}  // namespace braitenlab::ui
