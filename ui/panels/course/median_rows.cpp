// Two rows of dots: what a step has measured in each start as shipped and in each start of the submission, with the
// medians. Both rows have the same seeds and the same axis.
#include <algorithm>
#include <string>

#include <imgui.h>

#include "ui/panels/panels.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/measure_text.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

struct DotRow {
    const std::vector<float>& values;
    float most;  // value at the right end
    Colour colour;
    std::string_view words;  // key of a string with one gap, for the median
};

// A line of words, and below it the dots, spread over the height so that equal values are visible. The median is a bar
// through the row.
void draw_row(Ui& ui, const DotRow& row, const Measure& unit) {
    Measure middle = unit;
    middle.value = median(row.values);
    paragraph(ui, fill(ui.strings(row.words), {value_text(ui.strings, middle)}), ui.palette.text, Face::small);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = card_width(ui), height = ui.px(18), radius = ui.px(3), y = at.y + height / 2;
    const auto x_of = [&](float value) {
        return at.x + radius + std::clamp(value / row.most, 0.0f, 1.0f) * (width - 2 * radius);
    };
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddLine({at.x, y}, {at.x + width, y}, paint(ui.palette.line), ui.px(1));
    for (std::size_t i = 0; i < row.values.size(); ++i) {
        const float spread = (static_cast<float>(i % 5) - 2) / 2 * (height / 2 - radius);
        draw.AddCircleFilled({x_of(row.values[i]), y + spread}, radius, paint(row.colour.with_alpha(0.55f)));
    }
    const float x = x_of(middle.value);
    draw.AddLine({x, at.y}, {x, at.y + height}, paint(ui.palette.text), ui.px(2));
    ImGui::Dummy({width, height});
}

}  // namespace

void median_rows(const LessonView& lesson, Ui& ui) {
    if (!lesson.grade || !lesson.shipped_grade || lesson.shipped_grade->starts.empty()) return;
    const MedianRule& rule = lesson.exercise->median;
    const std::vector<float> shipped = measured_values(rule, lesson.shipped_grade->starts),
                             own = measured_values(rule, lesson.grade->starts);
    const auto& verdicts = lesson.shipped_grade->starts.front().verdicts;
    if (own.empty() || verdicts.empty()) return;
    const Measure& unit = verdicts[static_cast<std::size_t>(rule.step) - 1].measures.front();
    const float most = std::max({*std::max_element(shipped.begin(), shipped.end()),
                                 *std::max_element(own.begin(), own.end()), unit.needed, 1e-3f});
    const ImVec2 start = ImGui::GetCursorScreenPos();
    draw_row(ui, {shipped, most, ui.palette.second_text, "exercise.median_shipped"}, unit);
    draw_row(ui, {own, most, ui.palette.accent, "exercise.median_own"}, unit);
    const ImVec2 end = ImGui::GetCursorScreenPos();
    mark(ui, "exercise.medians", {start.x, start.y, card_width(ui), end.y - start.y});
    gap(ui, 8);
}

}  // namespace braitenlab::ui
