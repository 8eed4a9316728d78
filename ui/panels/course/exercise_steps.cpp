// The steps of the exercise card: in full, or compact in a low card.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <imgui.h>

#include "ui/imgui_compat.h"
#include "ui/panels/course/exercise_parts.h"
#include "ui/panels/course/exercise_rows.h"
#include "ui/panels/course/lesson_text.h"
#include "ui/panels/course/prediction.h"
#include "ui/panels/panels.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/whole_lines.h"
#include "ui/words/measure_text.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr float gauge_height = 12, compact_row = 24;  // layout pixels

std::string step_id(std::size_t index) { return "exercise.step." + std::to_string(index + 1); }

bool all_steps_ticked(const LessonView& lesson) {
    return !lesson.verdicts.empty() &&
           std::all_of(lesson.verdicts.begin(), lesson.verdicts.end(), [](const Verdict& v) { return v.done; });
}

// A line whose coloured part is what is needed, and a dot at the measured value.
void draw_gauge(const Gauge& gauge, bool is_met, float width, Ui& ui) {
    const float height = ui.px(gauge_height), radius = ui.px(4), bar = ui.px(2);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float y = at.y + height / 2;
    ImGui::Dummy({width, height});
    const WholeLines whole(at.y, height);
    const auto x_of = [&](float share) { return at.x + radius + share * (width - 2 * radius); };
    const auto part = [&](float from, float to, Colour colour) {
        fill_box(ui, {x_of(from), y - bar / 2, x_of(to) - x_of(from), bar}, colour, Corner::square);
    };
    part(0, 1, ui.palette.line);
    part(gauge.from, gauge.to, ui.palette.success);
    const Colour dot = is_met ? ui.palette.success : ui.palette.text;
    ImGui::GetWindowDrawList()->AddCircleFilled({x_of(gauge.value), y}, radius, paint(dot));
}

// True for a count that must stay small: it only grows, so that the end of the run decides.
bool is_decided_at_end(const Measure& measure) {
    return measure.at_most && !measure.best && (measure.unit == "captures" || measure.unit == "contacts");
}

// A value of a step: its name at the left and, at the right or below the name, the value with what is needed. While the
// step is not done, a gauge is below, and once the run has begun a sign left of it tells that this value is as needed,
// so that those without one are what is missing. `left` is the left edge of the step.
void step_value(const Measure& measure, bool done, bool has_begun, float left, bool has_gauge, Ui& ui) {
    const std::string words = measure_text(ui.strings, measure, done), title = measure_name(ui, measure);
    if (words.empty()) return;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float line = line_height(ui, Face::small), width = left + card_width(ui) - at.x;
    const bool is_met = measure.met && has_begun && !done && !is_decided_at_end(measure);
    if (is_met) {
        const WholeLines whole(at.y, line);
        put_icon(ui, {left + ui.px(15), at.y + line / 2}, icon::check, ui.palette.success, Face::small);
    }
    if (!title.empty()) paragraph(ui, title, ui.palette.second_text, Face::small);
    const float words_width = text_width(ui, Face::small, words);
    if (!title.empty() && text_width(ui, Face::small, title) + ui.px(spacing::small) + words_width <= width)
        ImGui::SetCursorScreenPos({at.x + width - words_width, at.y});
    const float y = ImGui::GetCursorScreenPos().y;
    {
        const WholeLines whole(y, line);
        put(ui, ImGui::GetCursorScreenPos(), words, ui.palette.text, Face::small);
    }
    ImGui::SetCursorScreenPos({at.x, y});
    ImGui::Dummy({width, line});
    if (measure.needed <= 0 || !has_gauge) return;
    if (done)
        ImGui::Dummy({width, ui.px(gauge_height)});  // the rows below stay where they are
    else
        draw_gauge(gauge_of(measure), is_met, width, ui);
}

// The text of a step has the room that its bold letters need once it is done.
void step_text(std::string_view words, bool done, Ui& ui) {
    const float top = ImGui::GetCursorPosY(), width = card_width(ui) - ImGui::GetCursorPosX();
    paragraph(ui, words, ui.palette.text, done ? Face::strong : Face::text);
    const auto lines = static_cast<float>(lines_of_words(ui, words, Face::strong, width).size());
    const float space = ImGui::GetStyle().ItemSpacing.y;
    const float missing = top + lines * line_height(ui, Face::strong) + space - ImGui::GetCursorPosY();
    if (missing > 1 + space) ImGui::Dummy({1, missing - space});
}

void step(const LessonView& lesson, std::size_t index, ExerciseRows& rows, bool has_gauges, Ui& ui) {
    const Step& asked = lesson.exercise->steps[index];
    const bool known = index < lesson.verdicts.size();
    const bool done = known && lesson.verdicts[index].done;
    const std::string id = step_id(index);
    const float top = begin_row(rows);
    if (!done && !rows.first_open_step) rows.first_open_step = top;
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float left = ui.px(26);
    ImGui::BeginGroup();
    ImGui::Indent(left);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(spacing::small), ui.px(spacing::hair)});
    step_text(translated(ui, asked.text), done, ui);
    const bool has_verdict = known && lesson.attempt.work.has_run;
    if (has_verdict && !(done && has_passed(lesson)))  // then the result has the room of the values
        for (const Measure& measure : lesson.verdicts[index].measures)
            if (std::isfinite(measure.value)) step_value(measure, done, !lesson.at_start, start.x, has_gauges, ui);
    if (has_verdict && lesson.verdicts[index].lost)
        paragraph(ui, ui.strings("exercise.lost"), colour_of(NoticeKind::notice, ui.palette), Face::small);
    ImGui::PopStyleVar();
    ImGui::Unindent(left);
    compat::end_group();
    const float height = ImGui::GetItemRectSize().y;
    mark(ui, id, {start.x, start.y, card_width(ui), height});
    const WholeLines whole(start.y, line_height(ui, Face::text));
    check_mark(ui, {start.x + ui.px(9), start.y + line_height(ui, Face::text) / 2}, ui.px(8), done,
               eased(ui, id, done ? 1.0f : 0.0f, 0.2f));
}

// Why the ticks or the grade do not count, or which run they are of.
void notes_on_run(const LessonView& lesson, Ui& ui) {
    if (lesson.by_hand && !all_steps_ticked(lesson))
        paragraph(ui, ui.strings("exercise.by_hand"), colour_of(NoticeKind::notice, ui.palette), Face::small);
    const Standing& standing = lesson.standing;
    if (standing.too_many_changes && !standing.outside_offers)
        paragraph(ui, fill(ui.strings("exercise.too_many_changes"), {std::to_string(lesson.exercise->changes)}),
                  colour_of(NoticeKind::notice, ui.palette), Face::small);
    if (standing.outside_offers)
        paragraph(ui, ui.strings("exercise.outside_offers"), ui.palette.second_text, Face::small);
    if (standing.changed_since_done)
        paragraph(ui, ui.strings("exercise.ticks_before"), colour_of(NoticeKind::notice, ui.palette), Face::small);
    else if (has_passed(lesson) && !all_steps_ticked(lesson))
        paragraph(ui, ui.strings("exercise.ticks_of_run"), ui.palette.second_text, Face::small);
}

// Once the exercise is passed they can be folded.
void full_steps(const LabView& view, PanelState& state, Ui& ui) {
    const LessonView& lesson = *view.lesson;
    ImVec2 heading = ImGui::GetCursorScreenPos();
    ExerciseRows& rows = state.exercise.rows;
    if (has_passed(lesson)) {
        const auto done = std::count_if(lesson.verdicts.begin(), lesson.verdicts.end(), [](auto& v) { return v.done; });
        const std::string words = fill(ui.strings("exercise.steps_done"),
                                       {std::to_string(done), std::to_string(lesson.exercise->steps.size())});
        if (!fold_row(ui, "exercise.steps", words, state.exercise.steps_open, ui.strings("exercise.steps_how"))) return;
        heading = ImGui::GetCursorScreenPos();
        // The row stays while all starts are shown at once, which cannot be compared.
        if (can_compare(view) || lesson.together) gap(ui, ui.tall(small_button_height) + spacing::small);
    } else {
        subheading(ui, ui.strings("exercise.steps"));
    }
    comparison(view, ui, heading, card_width(ui));
    notes_on_run(lesson, ui);
    const float space = ui.px(has_passed(lesson) ? spacing::tight : spacing::small);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(spacing::small), space});
    for (std::size_t i = 0; i < lesson.exercise->steps.size(); ++i) step(lesson, i, rows, true, ui);
    ImGui::PopStyleVar();
    gap(ui, 12);
}

// The step whose text and values a low card shows in full: the one that was clicked, else one that can no longer be
// done in this run, else the first open one. nullopt: all are done, or the question before the first run has the room.
std::optional<std::size_t> step_in_full(const LessonView& lesson, int clicked) {
    std::optional<std::size_t> first;
    for (std::size_t i = 0; i < lesson.exercise->steps.size(); ++i) {
        const bool known = i < lesson.verdicts.size();
        if (known && lesson.verdicts[i].done) continue;
        if (static_cast<int>(i) == clicked) return i;
        if (is_asked(lesson.exercise->prediction) && !lesson.attempt.work.has_run) continue;
        const bool lost = known && lesson.verdicts[i].lost;
        if (!first || (lost && !lesson.verdicts[*first].lost)) first = i;
    }
    return first;
}

// Its text in full, and its values.
std::string words_of_step(const Ui& ui, const LessonView& lesson, std::size_t index) {
    std::string words(translated(ui, lesson.exercise->steps[index].text));
    if (index >= lesson.verdicts.size() || !lesson.attempt.work.has_run) return words;
    for (const Measure& measure : lesson.verdicts[index].measures)
        if (const std::string value = measure_text(ui, measure, lesson.verdicts[index].done);
            std::isfinite(measure.value) && !value.empty())
            words += "\n" + value;
    return words;
}

// A tick for each step that is done, in one row from `at` to `right`.
void ticks_of_steps(const LessonView& lesson, ImVec2 at, float right, Ui& ui) {
    const auto count = std::count_if(lesson.verdicts.begin(), lesson.verdicts.end(), [](auto& v) { return v.done; });
    if (count == 0) return;
    const float pitch = std::min(ui.px(compact_row), (right - at.x) / static_cast<float>(count));
    float x = at.x;
    for (std::size_t i = 0; i < std::min(lesson.exercise->steps.size(), lesson.verdicts.size()); ++i) {
        if (!lesson.verdicts[i].done) continue;
        ImGui::SetCursorScreenPos({x, at.y});
        const Item tick = item(ui, step_id(i), {pitch, ui.px(compact_row)}, false);
        const std::string id = step_id(i);
        check_mark(ui, {tick.middle_x(), tick.middle_y()}, std::min(ui.px(8), 0.45f * pitch), true,
                   eased(ui, id, 1.0f, 0.2f));
        tooltip(ui, tick, words_of_step(ui, lesson, i));
        x += pitch;
    }
}

// The first value of an open step alone; empty before the first run, and without one.
std::string value_in_row(const Ui& ui, const LessonView& lesson, std::size_t index) {
    if (index >= lesson.verdicts.size() || !lesson.attempt.work.has_run) return {};
    for (const Measure& measure : lesson.verdicts[index].measures)
        if (std::isfinite(measure.value)) return value_text(ui.strings, measure);
    return {};
}

// An open step, small, with its value beside it; a click shows it in full. Rows as high as a finger would leave no room
// for the outcome below them on a telephone.
void row_of_step(const LessonView& lesson, std::size_t index, PanelState& state, Ui& ui) {
    const float left = ui.px(26), width = card_width(ui), line = line_height(ui, Face::small);
    const std::string value = value_in_row(ui, lesson, index);
    const float room = width - left - text_width(ui, Face::small, value) - (value.empty() ? 0 : ui.px(6));
    const auto lines = lines_of_words(ui, translated(ui, lesson.exercise->steps[index].text), Face::small, room);
    const float words = line * static_cast<float>(lines.size());
    const Item row = item(ui, step_id(index), {width, std::max(ui.px(compact_row), words + ui.px(4))});
    const float top = row.middle_y() - words / 2;
    const WholeLines whole_row(top, words);  // a line without the others would be another step
    check_mark(ui, {row.rect.x + ui.px(9), top + line / 2}, ui.px(6), false, 0);
    const Colour tone = mix(ui.palette.second_text, ui.palette.text, row.warmth);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const float y = top + line * static_cast<float>(i);
        put(ui, {row.rect.x + left, y}, lines[i], tone, Face::small);
        if (i == 0) put_right(ui, {row.rect.x + row.rect.w, y}, value, ui.palette.text, Face::small);
    }
    tooltip(ui, row, words_of_step(ui, lesson, index));
    if (row.pressed) state.exercise.step_in_full = static_cast<int>(index);
}

// Before the first run there are none, and the steps below the question need the room.
void heading_with_ticks(const LabView& view, Ui& ui) {
    const ImVec2 heading = ImGui::GetCursorScreenPos();
    const float height = ui.px(can_compare(view) ? ui.tall(compact_row) : compact_row);
    const float right = heading.x + card_width(ui);
    const std::string_view words = ui.strings("exercise.steps");
    put(ui, {heading.x, heading.y + (height - line_height(ui, Face::small)) / 2}, words, ui.palette.second_text,
        Face::small);
    const float button = can_compare(view) ? ui.px(28 + spacing::small) : 0.0f;
    const float ticks = heading.x + text_width(ui, Face::small, words) + ui.px(spacing::small);
    ticks_of_steps(*view.lesson, {ticks, heading.y + (height - ui.px(compact_row)) / 2}, right - button, ui);
    ImGui::SetCursorScreenPos(heading);
    ImGui::Dummy({card_width(ui), height});
    const float most_ticks = ui.px(compact_row) * static_cast<float>(view.lesson->exercise->steps.size());
    comparison(view, ui, {heading.x, heading.y + (height - line_height(ui, Face::small)) / 2},
               right - ticks - most_ticks);
}

// In a low card: what is done as ticks beside the heading, one open step in full, of the others a line. Its gauges
// leave their room to the hints.
void compact_steps(const LabView& view, PanelState& state, Ui& ui, bool only_clicked) {
    const LessonView& lesson = *view.lesson;
    if (lesson.attempt.work.has_run) heading_with_ticks(view, ui);
    notes_on_run(lesson, ui);
    const int clicked = state.exercise.step_in_full;
    auto in_full = step_in_full(lesson, clicked);
    if (only_clicked && in_full && static_cast<int>(*in_full) != clicked) in_full.reset();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(spacing::small), ui.px(spacing::hair)});
    for (std::size_t i = 0; i < lesson.exercise->steps.size(); ++i) {
        const bool is_done = i < lesson.verdicts.size() && lesson.verdicts[i].done;
        if (is_done) continue;
        if (i == in_full)
            step(lesson, i, state.exercise.rows, lesson.attempt.answers.hints_shown == 0, ui);
        else
            row_of_step(lesson, i, state, ui);
    }
    ImGui::PopStyleVar();
    gap(ui, spacing::small);
}

}  // namespace

void exercise_steps(const LabView& view, PanelState& state, Ui& ui, StepsLook look) {
    if (look == StepsLook::full) return full_steps(view, state, ui);
    compact_steps(view, state, ui, look == StepsLook::lines);
}

}  // namespace braitenlab::ui
