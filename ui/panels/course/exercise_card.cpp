// The card of the open exercise: goal, reason, prediction, steps with live check marks, hints in stages and the grade.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <imgui.h>

#include "ui/imgui_compat.h"
#include "ui/panels/cards.h"
#include "ui/panels/course/exercise_parts.h"
#include "ui/panels/course/exercise_rows.h"
#include "ui/panels/course/pages.h"
#include "ui/panels/course/prediction.h"
#include "ui/panels/exercise_names.h"
#include "ui/panels/offered.h"
#include "ui/panels/panels.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/whole_lines.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

// Layout pixels, of the card's height: below the first the steps are compact, below the second the goal is, too, below
// the third title and goal scroll.
constexpr float low_card = 660, lower_card = 520, least_height_with_head = 400;
constexpr std::size_t few_steps = 3;       // more are a line each in the lower card
constexpr float room_for_full_step = 330;  // layout pixels, height above the foot

// False if the vehicles of all tested starts begin at one place: shown at once they are one.
bool starts_differ(const Grade& grade) {
    constexpr float apart = 0.05f;  // m
    return std::none_of(grade.starts.begin(), grade.starts.end(), [](const auto& run) { return !run.path.empty(); }) ||
           std::any_of(grade.starts.begin(), grade.starts.end(), [&](const StartResult& run) {
               return !run.path.empty() && !grade.starts.front().path.empty() &&
                      maths::distance(run.path.front(), grade.starts.front().path.front()) > apart;
           });
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

// How many of the starts have passed.
void result_title(const LessonView& lesson, Ui& ui) {
    const Grade& grade = *lesson.grade;
    const std::string passed = std::to_string(grade.count), of = std::to_string(grade.starts.size());
    if (grade.good)
        return paragraph(ui, fill(ui.strings("exercise.passed"), {passed, of}),
                         legible(ui.palette.accent, ui.palette.panel, ui.palette.text), Face::title);
    const std::string needed = std::to_string(lesson.exercise->needed);
    paragraph(ui, fill(ui.strings("exercise.not_yet"), {passed, of, needed}), ui.palette.text, Face::strong);
}

void result(const LabView& view, Ui& ui, bool has_title) {
    const LessonView& lesson = *view.lesson;
    if (const auto& count = lesson.standing.starts_tested) {
        const std::string tested = std::to_string(*count), of = std::to_string(lesson.exercise->starts);
        paragraph(ui, fill(ui.strings("exercise.testing"), {tested, of}), ui.palette.text, Face::strong);
        gap(ui, 12);
    }
    if (!lesson.grade) return;
    const Grade& grade = *lesson.grade;
    const ImVec2 start = ImGui::GetCursorScreenPos();
    if (has_title) result_title(lesson, ui);
    if (!grade.good && lesson.standing.passed_before)
        paragraph(ui, ui.strings("exercise.stays_passed"), ui.palette.second_text, Face::small);
    start_pictures(view, ui);
    median_rows(lesson, ui);
    if (grade.good && (starts_differ(grade) || lesson.together)) together_button(lesson, ui);
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

// True while the question stands first: it can be answered. Else the steps do, so that an outcome, which comes by
// itself, moves no row above it.
bool is_question_first(const LabView& view) {
    return is_asked(view.lesson->exercise->prediction) && view.may.open_prediction &&
           !view.lesson->attempt.work.outcome_known && !has_passed(*view.lesson);
}

// Opens the card that has given way to another one.
void open_again(PanelState& state) {
    CardState& card = state.card(Card::exercise);
    if (!card.folded || !card.gave_way) return;
    card.folded = false;
    state.is_unsettled = true;
}

// True while a button is held or the pointer is over the column: no card may change place then. A finger is lifted
// where it touched last, which is no pointer there.
bool is_in_use(const LabView& view, Rect column) {
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    return ImGui::IsMouseDown(0) || (!view.program.touch && column.contains(pointer.x, pointer.y));
}

// True once for each outcome, grade and hint.
bool has_news(const LessonView& lesson, ExerciseNews& told) {
    const ExerciseNews before = told;
    told = {is_asked(lesson.exercise->prediction) && lesson.attempt.work.outcome_known, lesson.grade.has_value(),
            static_cast<std::size_t>(lesson.attempt.answers.hints_shown)};
    return (told.outcome && !before.outcome) || (told.grade && !before.grade) || told.hints > before.hints;
}

// Forgets what the card of another exercise has scrolled to, and goes back to its top, on a page of a lecture that asks
// its question to the end of that. Outside of a lecture the card opens: its question comes before Play.
void follow_exercise(const LabView& view, PanelState& state) {
    const LessonView& lesson = *view.lesson;
    if (state.exercise.id == lesson.exercise->id) return;
    state.exercise.id = lesson.exercise->id;
    state.exercise.outcome_seen = state.exercise.grade_seen = state.exercise.why_open = state.exercise.note_open =
        false;
    state.exercise.steps_open = true;
    state.exercise.goal_open = state.exercise.more_open = state.exercise.reset_asked = false;
    state.exercise.hand_in.asks = false;
    state.exercise.step_in_full = -1;
    state.exercise.hints_seen = 0;
    state.exercise.told = {};
    if (CardState& card = state.card(Card::exercise); card.folded && !view.lecture)
        card.folded = false, state.is_unsettled = true;
    CardState& sensors = state.card(Card::sensors);  // open, it would take the room of the question
    sensors.folded = traits(Card::sensors).folded, sensors.opened_by_user = false;
    aim_at(state.exercise.rows, state.lecture.asks_prediction ? ExerciseRows::Aim::outcome : ExerciseRows::Aim::top);
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

// All of it where the card has room, else at most so many lines; a click then shows all. `spare`: height that the card
// had left in the last frame, window pixels; below 0 its body scrolls.
void goal_in_lines(const LessonView& lesson, PanelState& state, Ui& ui, std::size_t most, float spare) {
    const std::string_view words = translated(ui, lesson.exercise->goal);
    const std::size_t lines = lines_of_words(ui, words, Face::text, card_width(ui)).size();
    const float missing = line_height(ui, Face::text) * static_cast<float>(lines > most ? lines - most : 0);
    const bool fits = spare + 0.5f >= (state.exercise.is_goal_cut ? missing : 0.0f) || lines <= most;
    const bool is_cut = !fits && !state.exercise.goal_open;
    state.exercise.is_goal_cut = is_cut;
    if (!is_cut) goal(lesson, state, ui);
    if (fits) return;
    if (state.exercise.goal_open) {
        if (small_push_button(ui, {"exercise.goal", icon::unfolded, ui.strings("exercise.goal_less")},
                              ui.strings("exercise.goal_less")))
            state.exercise.goal_open = false;
        return;
    }
    const Item row =
        item(ui, "exercise.goal", {card_width(ui), static_cast<float>(most) * line_height(ui, Face::text)});
    int* const counted = std::exchange(ui.shortened, nullptr);  // a row to unfold is no text that lacks its end
    put_lines(ui, {row.rect.x, row.rect.y}, words, mix(ui.palette.text, ui.palette.accent, 0.4f * row.warmth),
              Face::text, row.rect.w, most);
    ui.shortened = counted;
    tooltip(ui, row, words);
    if (row.pressed) state.exercise.goal_open = true;
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

// In the wiring editor hints and goal are read together.
bool is_goal_short(const LabView& view, const Ui& ui, float card) {
    return card < ui.px(lower_card) && view.mode != Mode::wiring;
}

// True while the title is in the heading of the card: in a lower card the outcome needs its room.
bool has_title_in_heading(const LabView& view, const Ui& ui, float card) {
    const LessonView& lesson = *view.lesson;
    return is_goal_short(view, ui, card) && lesson.attempt.work.outcome_known && !has_passed(lesson) &&
           shows_title(view);
}

// Once the exercise is passed, and where many steps leave no room for the outcome, the goal scrolls.
bool is_goal_below(const LabView& view, const Ui& ui, float card) {
    return has_passed(*view.lesson) ||
           (has_title_in_heading(view, ui, card) && view.lesson->exercise->steps.size() > few_steps);
}

// The heading of the folded card tells how many steps are done.
std::string heading_of_card(const LabView& view, const Ui& ui, bool folded, float card) {
    const std::vector<Verdict>& steps = view.lesson->verdicts;
    std::string words = exercise_heading(view, ui);
    if (!folded && has_title_in_heading(view, ui, card))
        return words + "  ·  " + std::string(translated(ui, view.lesson->exercise->title));
    if (!folded || view.lecture || !view.lesson->attempt.work.has_run || steps.empty()) return words;
    const auto done = std::count_if(steps.begin(), steps.end(), [](const Verdict& each) { return each.done; });
    return words + "  " + std::to_string(done) + "/" + std::to_string(steps.size());
}

// Title and goal, which do not scroll: they are read again while the steps and hints are. Once the exercise is passed,
// the goal is below the result and scrolls. `card`: the height of the card.
void head(const LabView& view, PanelState& state, Ui& ui, float card, float spare) {
    const bool has_short_goal = is_goal_short(view, ui, card);
    if (shows_title(view) && !has_title_in_heading(view, ui, card))
        paragraph(ui, translated(ui, view.lesson->exercise->title), ui.palette.text, Face::title);
    // The answers to a question need the room.
    const bool has_room = !has_close_rows(view, ui) || !view.may.open_prediction;
    if (!has_passed(*view.lesson) && view.lesson->standing.passed_before && has_room) passed_mark(ui);
    if (is_goal_below(view, ui, card)) return;
    const Attempt& attempt = view.lesson->attempt;
    const bool has_question = is_question_first(view), is_begun = attempt.work.has_run;
    const bool has_more = attempt.answers.hints_shown > 0 || attempt.work.outcome_known ||  // that needs the room
                          view.lesson->exercise->steps.size() > few_steps;
    if (has_short_goal && (has_question || is_begun))
        goal_in_lines(*view.lesson, state, ui, has_question ? 2 : has_more ? 1 : 3, spare);
    else
        goal(*view.lesson, state, ui);
}

void reason(const LabView& view, PanelState& state, Ui& ui) {
    const LessonView& lesson = *view.lesson;
    const bool has_reason = !lesson.exercise->why.empty() && shows_title(view);
    if (!has_reason && has_close_rows(view, ui)) return;
    if (has_reason && fold_row(ui, "exercise.why", ui.strings("exercise.why"), state.exercise.why_open,
                               ui.strings("exercise.why_how"))) {
        // It tells the answer to the prediction: the run shows that first.
        const bool is_open = is_asked(lesson.exercise->prediction) && !lesson.attempt.work.outcome_known;
        why(is_open && !has_passed(lesson) ? ui.strings("exercise.why_later") : translated(ui, lesson.exercise->why),
            state, ui);
    }
    gap(ui, 12);
}

// Where hints, what came of the prediction, or questions and answers of the foot, need the room, no step is in full.
StepsLook look_of_steps(const LessonView& lesson, const Ui& ui, float card, float foot) {
    if (card >= ui.px(low_card)) return StepsLook::full;
    const Attempt& attempt = lesson.attempt;
    const bool has_hints = card < ui.px(lower_card) && attempt.answers.hints_shown > 0;
    const bool has_outcome = attempt.work.outcome_known && (lesson.as_given || is_about_end(*lesson.exercise));
    const bool has_many = lesson.exercise->steps.size() > few_steps;
    return has_hints || (card < ui.px(lower_card) && (has_outcome || has_many)) ||
                   card - foot < ui.px(room_for_full_step)
               ? StepsLook::lines
               : StepsLook::compact;
}

}  // namespace

std::string exercise_heading(const LabView& view, const Ui& ui) {
    const Exercise& exercise = *view.lesson->exercise;
    if (exercise.number == 0) return std::string(ui.strings("exercise.heading_unnumbered"));
    return fill(ui.strings("exercise.heading"), {number_words(view, exercise.number, exercise.id)});
}

// Title and goal are visible until the exercise is passed. Then the result and the steps are at the top. The steps keep
// their place during a run, above the prediction, and so do the hints between both. In the wiring editor the hints are
// above the steps, which are judged while the scene plays. In a low card the compact steps do not scroll, and in a
// lower one that has no room for the goal it is one line, which a click unfolds; in the lowest, as in the editor, all
// of the card scrolls, and the steps are first. Once it is passed, a lower card begins with what came of the
// prediction. The buttons of a selection by hand and of a breeding do not scroll: hints that are read below point at
// them.
void exercise_card(const LabView& view, PanelState& state, Ui& ui, Rect place, Rect column) {
    const LessonView& lesson = *view.lesson;
    const bool passed = has_passed(lesson);
    follow_exercise(view, state);
    if (!lesson.grade) state.exercise.grade_seen = false;
    CardState& card = state.card(Card::exercise);
    const bool waits = card.folded && is_in_use(view, column);
    if (!waits && has_news(lesson, state.exercise.told)) open_again(state);
    const bool asks = state.lecture.asks_prediction;  // then the question has the room of the buttons
    if (!asks) card.footer = std::max(card.footer, ui.px(ui.tall(button_height) + 8));
    const bool is_low = place.h < ui.px(low_card), has_head = place.h >= ui.px(least_height_with_head);
    const bool steps_on_top = !has_head && view.mode == Mode::wiring && !passed;
    if (!has_head)
        card.head.reset();
    else if (!card.head)
        card.head = 0;
    const bool open = open_card(state, ui, Card::exercise, place, {}, heading_of_card(view, ui, card.folded, place.h));
    if (open) {
        ExerciseRows& rows = state.exercise.rows;
        const bool question_first = is_question_first(view), hints_first = view.mode == Mode::wiring && !passed;
        const bool hints_need_top = hints_first && has_head;
        const bool steps_in_head = is_low && !question_first && !steps_on_top && !hints_need_top;
        const StepsLook look = look_of_steps(lesson, ui, place.h, card.footer);
        const float spare = card.content > 0 ? place.h - wanted_height(ui, card) : 0;
        if (!has_head) begin_rows(rows);
        if (!steps_on_top) head(view, state, ui, place.h, spare);
        if (passed && is_low) result_title(lesson, ui);
        if (steps_in_head) exercise_steps(view, state, ui, look);
        if (has_head) end_head(ui, card, place), begin_rows(rows);
        if (steps_on_top) gap(ui, spacing::small), exercise_steps(view, state, ui, look);
        if (hints_first) hints(view, state, ui, steps_on_top);
        if (steps_on_top) head(view, state, ui, place.h, spare);
        const bool outcome_first = passed && place.h < ui.px(lower_card);
        if (outcome_first) prediction(view, state, ui);
        result(view, ui, !(passed && is_low));
        const bool outcome_next = passed && is_low && !outcome_first;
        if (outcome_next) prediction(view, state, ui);
        if (passed && !is_low) exercise_steps(view, state, ui, look);
        if (passed) question(lesson, state, ui), goal(lesson, state, ui);
        const bool goal_last = !passed && is_goal_below(view, ui, place.h);
        if (!is_low) reason(view, state, ui);
        if (!hides_outcome(view)) generation_of_selection(view, ui);
        const bool has_steps_here = !passed && !steps_on_top && !steps_in_head;
        if (has_steps_here && !question_first) exercise_steps(view, state, ui, look);
        const bool hints_last = passed || question_first;
        if (!hints_first && !hints_last) hints(view, state, ui, true);
        if (!outcome_first && !outcome_next) prediction(view, state, ui);
        if (has_steps_here && question_first) exercise_steps(view, state, ui, look);
        if (is_low) reason(view, state, ui);
        if (!hints_first && hints_last) hints(view, state, ui, true);
        if (goal_last) goal(lesson, state, ui);
        kept_button(view, ui);
        note_field(view, state, ui);
        if (lesson.grade && !state.exercise.grade_seen) aim_at(rows, ExerciseRows::Aim::top);
        state.exercise.grade_seen = lesson.grade.has_value();
        scroll_to_aim(ui, rows);
        begin_footer(ui, card, place);
        if (!hides_outcome(view)) selection_button(view, state, ui), breeding_button(view, state, ui);
        if (!asks) exercise_foot(view, state, ui, card_width(ui, place));
        end_footer(ui, card);
    }
    end_card(ui, card);
}

}  // namespace braitenlab::ui
