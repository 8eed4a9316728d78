#include "ui/panels/course/exercise_rows.h"

#include <algorithm>

#include <imgui.h>

namespace braitenlab::ui {

float row_to_stop_at(std::span<const float> tops, float wanted, float latest) {
    float stop = 0;
    for (const float top : tops) {
        if (stop >= wanted || top > latest) break;
        stop = top;
    }
    return stop;
}

void begin_rows(ExerciseRows& rows) {
    rows.tops.clear();
    rows.first_open_step.reset();
    rows.outcome = rows.newest_hint = {};
}

float begin_row(ExerciseRows& rows) { return rows.tops.emplace_back(ImGui::GetCursorPosY()); }

void aim_at(ExerciseRows& rows, ExerciseRows::Aim aim) {
    constexpr int frames = 4;
    rows.aim = aim;
    rows.settling = frames;
}

void scroll_to_aim(const Ui& ui, ExerciseRows& rows) {
    if (rows.settling == 0) return;
    --rows.settling;
    const float above = ui.px(4);  // within the space between two rows
    const ExerciseRows::Part part = rows.aim == ExerciseRows::Aim::outcome       ? rows.outcome
                                    : rows.aim == ExerciseRows::Aim::newest_hint ? rows.newest_hint
                                                                                 : ExerciseRows::Part{};
    const float wanted = part.end - ImGui::GetWindowHeight() + above;
    const float latest = std::min(part.top, ImGui::GetScrollMaxY() + above);
    const float stop = std::max(row_to_stop_at(rows.tops, wanted, latest), std::min(wanted, latest));
    ImGui::SetScrollY(std::max(0.0f, stop - above));
}

}  // namespace braitenlab::ui
