// The card of the open exercise: goal, reason, prediction, steps with live check marks, hints in stages and the grade.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <imgui.h>

#include "ui/imgui_compat.h"
#include "ui/panels/cards.h"
#include "ui/panels/course/exercise_names.h"
#include "ui/panels/course/exercise_rows.h"
#include "ui/panels/course/lesson_text.h"
#include "ui/panels/course/pages.h"
#include "ui/panels/course/prediction.h"
#include "ui/panels/offered.h"
#include "ui/panels/panels.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/whole_lines.h"
#include "ui/words/measure_text.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr float gauge_height = 12;             // layout pixels
constexpr float least_height_with_head = 400;  // layout pixels, of the card: below it title and goal scroll
constexpr float narrow_foot = 230;             // layout pixels: its buttons are small

std::string numbered(const char* stem, std::size_t index) { return stem + std::to_string(index + 1); }

bool has_passed(const LessonView& lesson) { return lesson.grade && lesson.grade->good; }

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

// A value of a step: its name at the left and, at the right or below the name, the value with what is needed. While the
// step is not done, a gauge is below, and once the run has begun a sign left of it tells that this value is as needed,
// so that those without one are what is missing. `left` is the left edge of the step.
void step_value(const Measure& measure, bool done, bool has_begun, float left, Ui& ui) {
    const std::string words = measure_text(ui.strings, measure, done), title = measure_name(ui, measure);
    if (words.empty()) return;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float line = line_height(ui, Face::small), width = left + card_width(ui) - at.x;
    const bool is_met = measure.met && has_begun && !done;
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
    if (measure.needed <= 0) return;
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

void step(const LessonView& lesson, std::size_t index, ExerciseRows& rows, Ui& ui) {
    const Step& asked = lesson.exercise->steps[index];
    const bool known = index < lesson.verdicts.size();
    const bool done = known && lesson.verdicts[index].done;
    const std::string id = numbered("exercise.step.", index);
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
            if (std::isfinite(measure.value)) step_value(measure, done, !lesson.at_start, start.x, ui);
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

// After passing: the tested starts at once in the scene, and back to the exercise.
void together_button(const LessonView& lesson, Ui& ui) {
    const bool on = lesson.together;
    ButtonLook look{on ? icon::undo : icon::play, ui.strings(on ? "exercise.back" : "exercise.together")};
    look.emphasis = on ? Emphasis::primary : Emphasis::plain;
    const Item at = button(ui, "exercise.together", look);
    tooltip(ui, at, ui.strings(on ? "exercise.back_how" : "exercise.together_how"));
    if (at.pressed) ui.outbox.emplace_back(TogetherRequest{!on});
}

// The brain that the student's progress has, while the vehicle has another one.
void kept_button(const LabView& view, Ui& ui) {
    const LessonView& lesson = *view.lesson;
    if (!lesson.standing.has_kept || has_passed(lesson) || !view.documents.students) return;
    const ExerciseProgress* kept = find_progress(view.documents.students->student(), lesson.key);
    if (!kept) return;
    paragraph(ui,
              fill(ui.strings(kept->passed ? "exercise.passed_before" : "exercise.tried_before"),
                   {std::to_string(kept->best), std::to_string(kept->starts)}),
              ui.palette.second_text, Face::small);
    const Item at = button(ui, "exercise.kept", {{}, ui.strings("exercise.kept")});
    tooltip(ui, at, ui.strings("exercise.kept_how"));
    if (at.pressed) ui.outbox.emplace_back(KeptRequest{});
    gap(ui, 12);
}

// The key of what the grade says.
std::string_view next_words(const LessonView& lesson) {
    const Grade& grade = *lesson.grade;
    if (!grade.good) return grade.count == 0 ? "exercise.not_yet_none" : "exercise.not_yet_next";
    if (lesson.attempt.work.solution_shown) return "exercise.passed_shown";
    return static_cast<std::size_t>(grade.count) == grade.starts.size() ? "exercise.passed_all"
                                                                        : "exercise.passed_next";
}

void result(const LabView& view, Ui& ui) {
    const LessonView& lesson = *view.lesson;
    if (const auto& count = lesson.standing.starts_tested) {
        const std::string tested = std::to_string(*count), of = std::to_string(lesson.exercise->starts);
        paragraph(ui, fill(ui.strings("exercise.testing"), {tested, of}), ui.palette.text, Face::strong);
        gap(ui, 12);
    }
    if (!lesson.grade) return;
    const Grade& grade = *lesson.grade;
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const std::string passed = std::to_string(grade.count), of = std::to_string(grade.starts.size());
    if (grade.good) {
        paragraph(ui, fill(ui.strings("exercise.passed"), {passed, of}),
                  legible(ui.palette.accent, ui.palette.panel, ui.palette.text), Face::title);
    } else {
        const std::string needed = std::to_string(lesson.exercise->needed);
        paragraph(ui, fill(ui.strings("exercise.not_yet"), {passed, of, needed}), ui.palette.text, Face::strong);
    }
    if (!grade.good && lesson.standing.passed_before)
        paragraph(ui, ui.strings("exercise.stays_passed"), ui.palette.second_text, Face::small);
    start_pictures(view, ui);
    median_rows(lesson, ui);
    if (grade.good) together_button(lesson, ui);
    paragraph(ui, ui.strings(next_words(lesson)), ui.palette.second_text, Face::small);
    const ImVec2 end = ImGui::GetCursorScreenPos();
    mark(ui, "exercise.grade", {start.x, start.y, card_width(ui), end.y - start.y - ui.px(8)});
    gap(ui, 12);
}

void hint_text(const LessonView& lesson, std::size_t index, PanelState& state, Ui& ui) {
    const ImVec2 start = ImGui::GetCursorScreenPos();
    begin_row(state.exercise.rows);
    ImGui::Indent(ui.px(12));
    paragraph(ui, fill(ui.strings("exercise.hint_number"), {std::to_string(index + 1)}), ui.palette.second_text,
              Face::small);
    paragraph_with_terms(ui, state.glossary, translated(ui, lesson.exercise->hints[index].text), ui.palette.text);
    ImGui::Unindent(ui.px(12));
    const float height = ImGui::GetCursorScreenPos().y - start.y - ui.px(8);
    ImGui::GetWindowDrawList()->AddRectFilled({start.x, start.y}, {start.x + ui.px(3), start.y + height},
                                              paint(ui.palette.accent), ui.px(radius::bar));
}

// In the wiring editor the newest is the first, because the card is low there.
void hints(const LabView& view, PanelState& state, Ui& ui, bool below_steps) {
    const LessonView& lesson = *view.lesson;
    ExerciseRows& rows = state.exercise.rows;
    const std::size_t count = lesson.exercise->hints.size();
    const auto shown = std::min(static_cast<std::size_t>(std::max(0, lesson.attempt.answers.hints_shown)), count);
    const bool newest_first = view.mode == Mode::wiring;
    for (std::size_t i = 0; i < shown; ++i) {
        const std::size_t index = newest_first ? shown - 1 - i : i;
        const float top = ImGui::GetCursorPosY();
        hint_text(lesson, index, state, ui);
        if (index + 1 == shown) rows.newest_hint = {top, ImGui::GetCursorPosY()};
    }
    // While the button is not available, how long that lasts.
    if (!lesson.attempt.answers.hint_ready && lesson.hint_in > 0 && !has_passed(lesson))
        paragraph(ui,
                  fill(ui.strings(shown < count ? "exercise.hint_in" : "exercise.show_me_in"),
                       {std::to_string(lesson.hint_in)}),
                  ui.palette.second_text, Face::small);
    if (!newest_first) rows.newest_hint.end = ImGui::GetCursorPosY();
    // Scrolls to a new hint, and to the newest where the order changes.
    const bool is_new = std::exchange(state.exercise.hints_seen, shown) < shown;
    const bool is_first_now = std::exchange(state.exercise.hints_first, newest_first) != newest_first && newest_first;
    using Aim = ExerciseRows::Aim;
    if (is_new || is_first_now) aim_at(rows, is_new && below_steps ? Aim::newest_hint : Aim::top);
}

// After the last hint: gives the vehicle the solution.
void show_me_button(const LessonView& lesson, Ui& ui) {
    ButtonLook look{icon::hint, ui.strings("exercise.show_me")};
    look.enabled = lesson.attempt.answers.hint_ready;
    const Item at = button(ui, "exercise.show_me", look);
    if (at.pressed) ui.outbox.emplace_back(ShowMeRequest{});
    tooltip(ui, at, ui.strings(look.enabled ? "exercise.show_me_how" : "exercise.hint_wait"));
}

void hint_button(const LessonView& lesson, bool compact, Ui& ui) {
    const std::size_t count = lesson.exercise->hints.size();
    const bool left = static_cast<std::size_t>(lesson.attempt.answers.hints_shown) < count;
    if (!left) return show_me_button(lesson, ui);
    ButtonLook look{icon::hint, ui.strings("exercise.hint")};
    look.compact = compact;
    look.enabled = lesson.attempt.answers.hint_ready;
    const Item at = button(ui, "exercise.hint", look);
    if (at.pressed) ui.outbox.push_back(Action::hint);
    tooltip(ui, at, ui.strings(look.enabled ? "exercise.hint_how" : "exercise.hint_wait"),
            key_name(Action::hint, ui.strings));
}

// Opens the next exercise, or the list of files after the last one.
void next_button(const LabView& view, PanelState& state, Ui& ui, bool compact = false) {
    const CatalogueEntry* next = next_exercise(view);
    const Emphasis emphasis = has_passed(*view.lesson) ? Emphasis::primary : Emphasis::plain;
    ButtonLook look{{}, ui.strings(next_exercise_key(view)), emphasis};
    look.compact = compact;
    const Item at = button(ui, "exercise.next", look);
    tooltip(ui, at, next ? entry_words(view, ui, *next) : std::string(ui.strings("exercise.more_how")),
            key_name({key::enter}, ui.strings));
    if (!at.pressed) return;
    if (next) return ui.outbox.push_back(OpenRequest{.path = next->path, .next_exercise = true});
    begin_files(state.sheets.files, false);
    state.sheet = Sheet::files;
}

// True while the question stands first: it can be answered. Else the steps do, so that an outcome, which comes by
// itself, moves no row above it.
bool is_question_first(const LabView& view) {
    return is_asked(view.lesson->exercise->prediction) && view.may.open_prediction &&
           !view.lesson->attempt.work.outcome_known && !has_passed(*view.lesson);
}

// Of the foot of the card, which does not scroll: the next step, and what the student hands in.
void exercise_buttons(const LabView& view, PanelState& state, Ui& ui, float width) {
    const bool passed = has_passed(*view.lesson), narrow = width < ui.px(narrow_foot);
    const float right = ImGui::GetCursorScreenPos().x + width;
    if (passed)
        next_button(view, state, ui);
    else
        hint_button(*view.lesson, narrow, ui);
    if (!passed && view.lesson->standing.passed_before) {  // with another brain, or at another time
        ButtonLook next{{}, ui.strings(next_exercise(view) ? "exercise.next" : "exercise.more")};
        next.compact = narrow;
        beside_or_below(ui, button_width(ui, next), right);
        next_button(view, state, ui, narrow);
    }
    ButtonLook reset{{}, ui.strings("exercise.reset")};  // sentences of the card name it by its words
    reset.compact = narrow || ImGui::GetItemRectMax().x + ui.px(8) + button_width(ui, reset) > right;
    const float above = ImGui::GetItemRectMin().y;
    beside_or_below(ui, button_width(ui, reset), right);
    // The answers to a question need the room of another row; the menu has this action, too.
    if (!narrow || !is_question_first(view) || ImGui::GetCursorScreenPos().y <= above) {
        const Item at = button(ui, "exercise.reset", reset);
        if (at.pressed) ui.outbox.push_back(Action::exercise_reset);
        tooltip(ui, at, ui.strings("exercise.reset_how"));
    }
    if (!view.pages) exercise_files(view, state, ui, width);  // nobody hands in on a page of a lecture
}

// Forgets what the card of another exercise has scrolled to, and goes back to its top, on a page of a lecture that asks
// its question to the end of that.
void follow_exercise(const LessonView& lesson, PanelState& state) {
    if (state.exercise.id == lesson.exercise->id) return;
    state.exercise.id = lesson.exercise->id;
    state.exercise.outcome_seen = state.exercise.grade_seen = state.exercise.why_open = state.exercise.note_open =
        false;
    state.exercise.steps_open = true;
    state.exercise.hints_seen = 0;
    CardState& sensors = state.card(Card::sensors);  // open, it would take the room of the question
    sensors.folded = traits(Card::sensors).folded, sensors.opened_by_user = false;
    aim_at(state.exercise.rows, state.lecture.asks_prediction ? ExerciseRows::Aim::outcome : ExerciseRows::Aim::top);
}

// Once the exercise is passed they can be folded.
void steps(const LabView& view, PanelState& state, Ui& ui) {
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
    comparison(view, ui, heading);
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
    const float space = ui.px(has_passed(lesson) ? spacing::tight : spacing::small);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(spacing::small), space});
    for (std::size_t i = 0; i < lesson.exercise->steps.size(); ++i) step(lesson, i, rows, ui);
    ImGui::PopStyleVar();
    gap(ui, 12);
}

// Asked after the exercise is passed, never graded.
void question(const LessonView& lesson, PanelState& state, Ui& ui) {
    if (lesson.exercise->question.empty()) return;
    subheading(ui, ui.strings("exercise.question"));
    paragraph_with_terms(ui, state.glossary, translated(ui, lesson.exercise->question), ui.palette.text);
    gap(ui, 12);
}

// The reason, and a button for each page of the manual that it names.
void why(std::string_view text, PanelState& state, Ui& ui) {
    paragraph_with_terms(ui, state.glossary, text, ui.palette.second_text);
    for (const std::string& page : pages_in(text)) {
        const Item at = button(ui, "exercise.page", {{}, fill(ui.strings("exercise.page"), {page})});
        if (at.pressed) ui.outbox.emplace_back(PageRequest{page});
        tooltip(ui, at, ui.strings("exercise.page_how"));
    }
}

void goal(const LessonView& lesson, PanelState& state, Ui& ui) {
    paragraph_with_terms(ui, state.glossary, translated(ui, lesson.exercise->goal), ui.palette.text);
}

// The student has passed the exercise, with another brain than the present one.
void passed_mark(Ui& ui) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float line = line_height(ui, Face::small), left = ui.px(22);
    put_icon(ui, {at.x + ui.px(8), at.y + line / 2}, icon::check, ui.palette.success, Face::small);
    ImGui::Indent(left);
    paragraph(ui, ui.strings("exercise.passed_mark"), ui.palette.success, Face::small);
    ImGui::Unindent(left);
    mark(ui, "exercise.passed_mark", {at.x, at.y, card_width(ui), line});
}

// True once title and reason may be read. While the prediction can be changed they would move the answers under the
// pointer.
bool shows_title(const LabView& view) {
    const bool can_change = is_asked(view.lesson->exercise->prediction) && view.may.open_prediction;
    return !hides_outcome(view) && !hides_open_title(view) && (!can_change || view.pages);
}

// Title and goal, which do not scroll: they are read again while the steps and hints are. Once the exercise is passed,
// the goal is below the result and scrolls.
void head(const LabView& view, PanelState& state, Ui& ui) {
    if (shows_title(view)) paragraph(ui, translated(ui, view.lesson->exercise->title), ui.palette.text, Face::title);
    // The answers to a question need the room.
    const bool has_room = card_width(ui) >= ui.px(narrow_foot) || !view.may.open_prediction;
    if (!has_passed(*view.lesson) && view.lesson->standing.passed_before && has_room) passed_mark(ui);
    if (!has_passed(*view.lesson)) goal(*view.lesson, state, ui);
}

void reason(const LabView& view, PanelState& state, Ui& ui) {
    const LessonView& lesson = *view.lesson;
    const bool has_reason = !lesson.exercise->why.empty() && shows_title(view);
    if (!has_reason && card_width(ui) < ui.px(narrow_foot)) return;
    if (has_reason && fold_row(ui, "exercise.why", ui.strings("exercise.why"), state.exercise.why_open,
                               ui.strings("exercise.why_how"))) {
        // It tells the answer to the prediction: the run shows that first.
        const bool is_open = is_asked(lesson.exercise->prediction) && !lesson.attempt.work.outcome_known;
        why(is_open && !has_passed(lesson) ? ui.strings("exercise.why_later") : translated(ui, lesson.exercise->why),
            state, ui);
    }
    gap(ui, 12);
}

}  // namespace

std::string exercise_heading(const LabView& view, const Ui& ui) {
    const Exercise& exercise = *view.lesson->exercise;
    if (exercise.number == 0) return std::string(ui.strings("exercise.heading_unnumbered"));
    return fill(ui.strings("exercise.heading"), {number_words(view, exercise.number, exercise.id)});
}

// Title and goal are visible until the exercise is passed. Then the result and the steps are at the top. The steps keep
// their place during a run, above the prediction, and so do the hints between both. In the wiring editor the hints are
// above the steps, which are judged while the scene plays. In a low window the rest scrolls, in a low card also title
// and goal, which in the editor are then below steps and hints. The buttons of a selection by hand and of a breeding do
// not scroll: hints that are read below point at them.
void exercise_card(const LabView& view, PanelState& state, Ui& ui, Rect place, Rect) {
    const LessonView& lesson = *view.lesson;
    const bool passed = has_passed(lesson);
    follow_exercise(lesson, state);
    CardState& card = state.card(Card::exercise);
    const bool asks = state.lecture.asks_prediction;  // then the question has the room of the buttons
    if (!asks) card.footer = std::max(card.footer, ui.px(ui.tall(button_height) + 8));
    const bool is_low = place.h < ui.px(least_height_with_head);
    const bool steps_on_top = is_low && view.mode == Mode::wiring && !passed;
    if (is_low)
        card.head.reset();
    else if (!card.head)
        card.head = 0;
    const bool open = open_card(state, ui, Card::exercise, place, {}, exercise_heading(view, ui));
    if (open) {
        ExerciseRows& rows = state.exercise.rows;
        if (is_low) begin_rows(rows);
        if (!steps_on_top) head(view, state, ui);
        if (!is_low) end_head(ui, card, place), begin_rows(rows);
        const bool hints_first = view.mode == Mode::wiring && !passed;
        if (steps_on_top) gap(ui, spacing::small), steps(view, state, ui);
        if (hints_first) hints(view, state, ui, steps_on_top);
        if (steps_on_top) head(view, state, ui);
        result(view, ui);
        if (passed) steps(view, state, ui), question(lesson, state, ui), goal(lesson, state, ui);
        reason(view, state, ui);
        if (!hides_outcome(view)) generation_of_selection(view, ui);
        const bool question_first = is_question_first(view), has_steps_here = !passed && !steps_on_top;
        if (has_steps_here && !question_first) steps(view, state, ui);
        const bool hints_last = passed || question_first;
        if (!hints_first && !hints_last) hints(view, state, ui, true);
        prediction(view, state, ui);
        if (has_steps_here && question_first) steps(view, state, ui);
        if (!hints_first && hints_last) hints(view, state, ui, true);
        kept_button(view, ui);
        note_field(view, state, ui);
        if (lesson.grade && !state.exercise.grade_seen) aim_at(rows, ExerciseRows::Aim::top);
        state.exercise.grade_seen = lesson.grade.has_value();
        scroll_to_aim(ui, rows);
        begin_footer(ui, card, place);
        if (!hides_outcome(view)) selection_button(view, state, ui), breeding_button(view, state, ui);
        if (!asks) exercise_buttons(view, state, ui, card_width(ui, place));
        end_footer(ui, card);
    }
    end_card(ui, card);
}

}  // namespace braitenlab::ui
