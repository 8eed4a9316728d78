// A small picture of each graded start: the arena, its sources and the vehicle's path. A click replays the start.
#include <algorithm>
#include <cmath>
#include <string>

#include <imgui.h>

#include "ui/panels/course/lesson_text.h"
#include "ui/panels/panels.h"
#include "ui/panels/path_picture.h"
#include "ui/panels/scene_picture.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr std::size_t few_starts = 10;              // up to this number the pictures are large
constexpr float between_pictures = spacing::small;  // layout pixels

// The same part of the floor for all pictures: that of the scene, and of the paths inside the arena.
FloorArea pictured_area(const Exercise& exercise, const Grade& grade) {
    FloorArea area = occupied_area(exercise.scene);
    for (const StartResult& start : grade.starts) include(area, start.path);
    const maths::vec2 half{exercise.scene.arena.width / 2, exercise.scene.arena.height / 2};
    area.low = {std::max(area.low.x, -half.x), std::max(area.low.y, -half.y)};
    area.high = {std::min(area.high.x, half.x), std::min(area.high.y, half.y)};
    return area;
}

// A check mark or a cross, so that the colour does not tell alone.
void draw_sign(const Ui& ui, ImVec2 c, bool passed, ImU32 colour) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float r = ui.px(3.5f), width = ui.px(1.5f);
    if (passed) {
        draw.PathLineTo({c.x - r, c.y}), draw.PathLineTo({c.x - r * 0.2f, c.y + r * 0.7f});
        draw.PathLineTo({c.x + r, c.y - r * 0.7f});
        return draw.PathStroke(colour, 0, width);
    }
    draw.AddLine({c.x - r, c.y - r}, {c.x + r, c.y + r}, colour, width);
    draw.AddLine({c.x - r, c.y + r}, {c.x + r, c.y - r}, colour, width);
}

// Whether the start passes; else the step that made it fail, and how far that was from being done.
std::string result_text(const Ui& ui, const Exercise& exercise, const StartResult& start) {
    const std::string number = std::to_string(start.seed);
    if (start.passed) return fill(ui.strings("exercise.start_passed"), {number});
    const std::size_t failed = failed_step(start);
    if (failed >= start.verdicts.size()) return fill(ui.strings("exercise.start_invalid"), {number});
    std::string text = fill(ui.strings("exercise.start_failed"), {number, translated(ui, exercise.steps[failed].text)});
    for (const Measure& measure : start.verdicts[failed].measures)
        if (std::isfinite(measure.value)) text += "\n" + measure_text(ui, measure, false);
    return text;
}

void start_picture(const LabView& view, Ui& ui, std::size_t index, ImVec2 size, const FloorArea& area) {
    const Exercise& exercise = *view.lesson->exercise;
    const StartResult& start = view.lesson->grade->starts[index];
    const Item at = item(ui, "exercise.start." + std::to_string(index + 1), size);
    const bool is_shown = view.now->seed == start.seed || view.lesson->together;
    fill_box(ui, at.rect, mix(ui.palette.raised, ui.palette.accent, 0.2f * at.warmth), Corner::box);
    line_box(ui, at.rect, is_shown ? ui.palette.accent : ui.palette.line, Corner::box);
    const float inset = ui.px(spacing::tight);
    const Rect inner{at.rect.x + inset, at.rect.y + inset, at.rect.w - 2 * inset, at.rect.h - 2 * inset};
    const Colour tone = start.passed ? legible(ui.palette.accent, ui.palette.raised, ui.palette.text)
                                     : colour_of(NoticeKind::failure, ui.palette);
    draw_run(ui, exercise, start, FloorMap(area, inner), tone);
    draw_sign(ui, {at.rect.x + at.rect.w - ui.px(7), at.rect.y + ui.px(7)}, start.passed, paint(tone));
    if (wants_tooltip(ui, at))
        tooltip(ui, at, result_text(ui, exercise, start) + "\n" + std::string(ui.strings("exercise.start_how")));
    if (!at.pressed) return;
    ui.outbox.emplace_back(SeedRequest{start.seed});
    if (view.mode == Mode::paused) ui.outbox.emplace_back(Action::play_pause);
}

}  // namespace

void start_pictures(const LabView& view, Ui& ui) {
    const std::size_t count = view.lesson->grade->starts.size();
    const std::size_t per_row = count <= few_starts ? 5 : 8;
    const FloorArea area = pictured_area(*view.lesson->exercise, *view.lesson->grade);
    const float gap = ui.px(between_pictures);
    const float width = (card_width(ui) - gap * static_cast<float>(per_row - 1)) / static_cast<float>(per_row);
    const float least = ui.px(ui.tall(24));  // of a target
    const float height =
        std::max(least, width * std::clamp((area.high.y - area.low.y) / (area.high.x - area.low.x), 0.5f, 1.0f));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
    for (std::size_t i = 0; i < count; ++i) {
        if (i % per_row != 0) ImGui::SameLine();
        start_picture(view, ui, i, {width, height}, area);
    }
    ImGui::PopStyleVar();
    for (const StartResult& start : view.lesson->grade->starts)
        if (!start.passed && start.seed == view.now->seed)
            paragraph(ui, result_text(ui, *view.lesson->exercise, start), ui.palette.second_text, Face::small);
}

}  // namespace braitenlab::ui
