#include "ui/panels/course/prediction.h"

#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/lesson/path_distance.h"
#include "ui/panels/course/exercise_keys.h"
#include "ui/panels/course/exercise_rows.h"
#include "ui/panels/course/glossary.h"
#include "ui/panels/panels.h"
#include "ui/scene_input/path_drawing.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/whole_lines.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

// A sign and a sentence: whether the chosen option is the one that the run has shown. It is not graded, so that neither
// colour is a warning.
void came_true(const LessonView& lesson, Ui& ui) {
    const bool right = lesson.attempt.answers.prediction == lesson.exercise->prediction.answer;
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float left = ui.px(26), radius = ui.px(8);
    const ImVec2 middle{start.x + ui.px(9), start.y + line_height(ui, Face::text) / 2};
    ImGui::Indent(left);
    paragraph(ui, ui.strings(right ? "exercise.came_true" : "exercise.not_true"), ui.palette.text, Face::strong);
    ImGui::Unindent(left);
    mark(ui, "exercise.came_true", {start.x, start.y, card_width(ui), ImGui::GetCursorScreenPos().y - start.y});
    const WholeLines whole(start.y, line_height(ui, Face::text));
    if (right) {
        check_mark(ui, middle, radius, true, 1);
    } else {
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        const ImU32 ink = paint(ui.palette.second_text);
        const float r = radius * 0.4f;
        draw.AddCircle(middle, radius, ink, 0, ui.px(1.5f));
        draw.AddLine({middle.x - r, middle.y - r}, {middle.x + r, middle.y + r}, ink, ui.px(1.8f));
        draw.AddLine({middle.x - r, middle.y + r}, {middle.x + r, middle.y - r}, ink, ui.px(1.8f));
    }
}

// The button that begins the drawing of a path, and what has been drawn.
void draw_button(const LabView& view, PanelState& state, Ui& ui) {
    const LessonView& lesson = *view.lesson;
    const Prediction& asked = lesson.exercise->prediction;
    const bool drawn = !lesson.attempt.answers.drawn_path.empty(), enabled = vehicle_to_draw_for(view) != nullptr;
    const std::string words = fill(ui.strings(asked.options.empty() ? "exercise.draw_only" : "exercise.draw_or"),
                                   {fixed(ui, asked.after, 0)});
    const bool is_low = has_close_rows(view, ui);  // then the steps below need the room
    if (!is_low) paragraph(ui, words, ui.palette.second_text, Face::small);
    ButtonLook look{drawn ? icon::check : std::string_view{},
                    ui.strings(drawn ? "exercise.draw_again" : "exercise.draw")};
    PathDrawing& drawing = state.scene_input.path;
    look.on = drawing.on;
    look.enabled = enabled;
    const Item at = button(ui, "exercise.draw", look);
    if (at.pressed) {
        drawing = {.on = !drawing.on, .held = false, .points = {}};
        if (drawing.on && ui.keyboard) ui.keyboard->focus.clear();  // the arrow keys draw
    }
    const std::string how(ui.strings(enabled ? "exercise.draw_how" : "exercise.draw_at_start"));
    tooltip(ui, at, is_low ? words + "\n" + how : how);
}

// True in the body of a low card, which has no room for notes below the answers.
bool is_in_low_body(const Ui& ui) {
    constexpr float low_body = 400;  // layout pixels
    return ImGui::GetWindowHeight() < ui.px(low_body);
}

// Says, once Play has pointed to the question, how to answer or to skip it.
void answer_first(const LabView& view, const PanelState& state, Ui& ui) {
    if (!is_play_held(view, state)) return;
    const Prediction& asked = view.lesson->exercise->prediction;
    const std::string_view key = asked.options.empty()   ? "exercise.draw_first"
                                 : asked.path_of.empty() ? "exercise.answer_first"
                                                         : "exercise.answer_or_draw_first";
    const ImVec2 start = ImGui::GetCursorScreenPos();
    paragraph(ui, fill(ui.strings(key), {key_name(Action::play_pause, ui.strings)}),
              colour_of(NoticeKind::notice, ui.palette), is_in_low_body(ui) ? Face::small : Face::strong);
    mark(ui, "exercise.answer_first", {start.x, start.y, card_width(ui), ImGui::GetCursorScreenPos().y - start.y});
}

void open_prediction(const LabView& view, PanelState& state, Ui& ui) {
    const LessonView& lesson = *view.lesson;
    const Prediction& asked = lesson.exercise->prediction;
    paragraph(ui, translated(ui, asked.question), ui.palette.text, Face::strong);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(spacing::small), ui.px(spacing::tight)});
    if (!asked.path_of.empty()) draw_button(view, state, ui);
    const bool shows_keys = digits_choose_answer(view) && !view.program.touch;
    for (std::size_t i = 0; i < asked.options.size(); ++i) {
        const bool is_chosen = static_cast<int>(i) == lesson.attempt.answers.prediction;
        const std::string id = "exercise.predict." + std::to_string(i + 1);
        const std::string key = shows_keys ? std::to_string(i + 1) : "";
        if (radio_row(ui, id, translated(ui, asked.options[i]), is_chosen, true, ui.strings("exercise.predict_how"),
                      key) &&
            !is_chosen)
            ui.outbox.push_back(PredictRequest{static_cast<int>(i)});
    }
    ImGui::PopStyleVar();
    answer_first(view, state, ui);  // below the answers, which then stay under the pointer
}

// Of the vehicle whose path is drawn, m.
float length_of_vehicle(const Exercise& exercise) {
    for (const Start& start : exercise.scene.starts)
        if (start.name == exercise.prediction.path_of)
            if (const int kind = find_kind(exercise.scene, start.kind); kind >= 0)
                return exercise.scene.kinds[static_cast<std::size_t>(kind)].body.length;
    return Body{}.length;
}

// The chosen option; empty if there is none.
std::string_view chosen_option(const LessonView& lesson) {
    const std::vector<std::string>& options = lesson.exercise->prediction.options;
    const int chosen = lesson.attempt.answers.prediction;
    return chosen >= 0 && static_cast<std::size_t>(chosen) < options.size() ? options[static_cast<std::size_t>(chosen)]
                                                                            : std::string_view{};
}

void you_predicted(const LessonView& lesson, Ui& ui) {
    const std::string_view option = chosen_option(lesson);
    if (option.empty()) return;
    paragraph(ui, fill(ui.strings("exercise.you_predicted"), {translated(ui, option)}), ui.palette.second_text);
}

// How much the path that was drawn differs from that of the run.
void difference_of_paths(const LessonView& lesson, Ui& ui) {
    const Attempt::Work& work = lesson.attempt.work;
    if (work.real_path.empty()) return;
    paragraph(ui,
              fill(ui.strings("exercise.path_differs"),
                   {fixed(ui, work.path_difference, 1), fixed(ui, length_of_vehicle(*lesson.exercise), 1)}),
              ui.palette.text);
    if (work.path_reversed) paragraph(ui, ui.strings("exercise.path_reversed"), ui.palette.text);
}

// What the run has shown.
void outcome(const LessonView& lesson, PanelState& state, Ui& ui) {
    const Prediction& asked = lesson.exercise->prediction;
    if (asked.outcome.empty()) return;
    const bool is_of_this_run = lesson.as_given || is_about_end(*lesson.exercise);
    paragraph_with_terms(ui, state.glossary,
                         fill(ui.strings(is_of_this_run ? "exercise.outcome" : "exercise.outcome_before"),
                              {translated(ui, asked.outcome)}),
                         is_of_this_run ? ui.palette.text : ui.palette.second_text);
}

// The prediction beside the outcome. It is not graded. In a low body the outcome is first: the rest may be below the
// edge.
void judged_prediction(const LessonView& lesson, PanelState& state, Ui& ui) {
    const bool outcome_first = is_in_low_body(ui), is_known = lesson.attempt.work.outcome_known;
    if (!outcome_first) you_predicted(lesson, ui);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    if (is_known && !chosen_option(lesson).empty()) came_true(lesson, ui);
    difference_of_paths(lesson, ui);
    if (is_known) {
        outcome(lesson, state, ui);
        mark(ui, "exercise.outcome",
             {start.x, start.y, card_width(ui),
              ImGui::GetCursorScreenPos().y - start.y - ImGui::GetStyle().ItemSpacing.y});
    }
    if (outcome_first) you_predicted(lesson, ui);
}

// Runs with the student's changes do not judge the prediction.
void ask_for_a_run_as_given(Ui& ui) {
    const ImVec2 start = ImGui::GetCursorScreenPos();
    paragraph(ui, ui.strings("exercise.as_given"), colour_of(NoticeKind::notice, ui.palette), Face::small);
    mark(ui, "exercise.as_given", {start.x, start.y, card_width(ui), ImGui::GetCursorScreenPos().y - start.y});
}

// All of it is in sight or nothing.
void note(Ui& ui, std::string_view key) {
    const std::string_view words = ui.strings(key);
    const float line = line_height(ui, Face::small);
    const WholeLines whole(ImGui::GetCursorScreenPos().y,
                           line * static_cast<float>(lines_of_words(ui, words, Face::small, card_width(ui)).size()));
    paragraph(ui, words, ui.palette.second_text, Face::small);
}

// While a run is not at its start, and its outcome is not known.
void locked_prediction(const LessonView& lesson, bool asks_for_a_run, Ui& ui) {
    const std::string_view question = translated(ui, lesson.exercise->prediction.question);
    paragraph(ui, question, ui.palette.text);  // the steps need the room of the options
    you_predicted(lesson, ui);
    if (asks_for_a_run) return ask_for_a_run_as_given(ui);
    if (is_about_end(*lesson.exercise)) return;
    note(ui, has_predicted(lesson.attempt.answers) ? "exercise.locked" : "exercise.locked_unanswered");
}

}  // namespace

bool is_about_end(const Exercise& exercise) {
    return offers_selection(exercise) || !offered_breeding(exercise).empty();
}

void check_mark(const Ui& ui, ImVec2 c, float radius, bool done, float arrived) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    if (!done) {
        draw.AddCircle(c, radius, paint(ui.palette.second_text), 0, ui.px(1.5f));
        return;
    }
    draw.AddCircleFilled(c, radius * (0.6f + 0.4f * arrived), paint(ui.palette.accent));
    const float r = radius * 0.5f;
    const ImVec2 tick[]{{c.x - r, c.y}, {c.x - r * 0.25f, c.y + r * 0.75f}, {c.x + r, c.y - r * 0.7f}};
    draw.PathLineTo(tick[0]), draw.PathLineTo(tick[1]), draw.PathLineTo(tick[2]);
    draw.PathStroke(paint(ui.palette.on_accent), 0, ui.px(1.8f));
}

void prediction(const LabView& view, PanelState& state, Ui& ui) {
    const LessonView& lesson = *view.lesson;
    const Prediction& asked = lesson.exercise->prediction;
    const bool is_known = lesson.attempt.work.outcome_known, has_answer = has_predicted(lesson.attempt.answers);
    const bool passed = lesson.grade && lesson.grade->good, is_open = !is_known && !passed;
    if (!is_asked(asked) || (!is_open && !has_answer && !is_known)) return;
    const bool asks_for_a_run = needs_start_over(lesson);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    ExerciseRows& rows = state.exercise.rows;
    const float top = begin_row(rows);
    const bool can_choose = is_open && view.may.open_prediction;
    // Above answers and outcomes of a low card, and above the high rows of answers for a finger, it would take their
    // room.
    const bool needs_room =
        can_choose ? has_close_rows(view, ui) || view.program.touch : !is_open && is_in_low_body(ui);
    if (!needs_room) subheading(ui, ui.strings("exercise.predict"));
    if (!can_choose && ui.keyboard && ui.keyboard->focus.starts_with("exercise.predict.")) ui.keyboard->focus.clear();
    if (can_choose) {
        open_prediction(view, state, ui);
        if (asks_for_a_run)
            ask_for_a_run_as_given(ui);
        else if (has_answer && !is_in_low_body(ui))
            note(ui, "exercise.changeable");
    } else if (is_open) {
        locked_prediction(lesson, asks_for_a_run, ui);
    } else {
        judged_prediction(lesson, state, ui);
    }
    const ImVec2 end = ImGui::GetCursorScreenPos();
    if (std::exchange(state.exercise.shows_question, false)) reveal(ui, start.y, end.y);
    mark(ui, "exercise.predict", {start.x - ui.px(6), start.y - ui.px(4), card_width(ui) + ui.px(12), end.y - start.y});
    if (!std::exchange(state.exercise.outcome_seen, is_known) && is_known) aim_at(rows, ExerciseRows::Aim::outcome);
    // With hints between the steps and the outcome, there is no room for both.
    const bool has_hints = lesson.attempt.answers.hints_shown > 0;
    rows.outcome = {has_hints ? top : rows.first_open_step.value_or(top), ImGui::GetCursorPosY()};
    gap(ui, 12);
}

void comparison(const LabView& view, Ui& ui, ImVec2 heading, float room) {
    if (!can_compare(view)) return;
    const LessonView& lesson = *view.lesson;
    const ImVec2 below = ImGui::GetCursorScreenPos();
    const SmallButton look{"exercise.compare", icon::outlines, ui.strings("exercise.compare"),
                           lesson.attempt.work.compares};
    const bool words = small_button_width(ui, look, true) <= room;
    const float w = small_button_width(ui, look, words), h = ui.px(ui.tall(small_button_height));
    ImGui::SetCursorScreenPos({heading.x + card_width(ui) - w, heading.y + (line_height(ui, Face::small) - h) / 2});
    const Item at = small_button(ui, look, words);
    if (at.pressed) ui.outbox.push_back(CompareRequest{!lesson.attempt.work.compares});
    tooltip(ui, at,
            words ? std::string(ui.strings("exercise.compare_how"))
                  : fmt::format("{}. {}", ui.strings("exercise.compare"), ui.strings("exercise.compare_how")));
    ImGui::SetCursorScreenPos(below);
    if (lesson.attempt.work.compares)
        paragraph(ui, ui.strings(lesson.by_hand ? "exercise.compare_by_hand" : "exercise.compare_legend"),
                  ui.palette.second_text, Face::small);
}

}  // namespace braitenlab::ui
