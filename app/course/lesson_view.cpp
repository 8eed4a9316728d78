#include "app/course/lesson_view.h"

#include <algorithm>
#include <cmath>

#include "app/course/lab_lesson.h"

namespace braitenlab {

namespace {

const Exercise* open_exercise(const Lab& lab) {
    return lab.document.lesson ? lab.document.lesson->exercise.get() : nullptr;
}

bool is_at_start(const Lab& lab) {
    const auto& selecting = lab.document.lesson->selecting;
    return lab.document.session.snapshot().tick == 0 && !(selecting && selecting->parents.size() > 1);
}

// Seconds until the next hint may be shown without a run; 0 if it may be shown now.
int seconds_to_hint(const Lab& lab) {
    const Lesson& lesson = *lab.document.lesson;
    if (lesson.attempt.answers.hint_ready) return 0;
    return static_cast<int>(std::ceil(seconds_between_hints - (lab.wall_seconds - lesson.last_hint_at)));
}

}  // namespace

Disclosure disclosure_of(const Lab& lab) {
    Known known;
    if (const auto& lesson = lab.document.lesson) {
        const Attempt::Work& work = lesson->attempt.work;
        known.predicted = has_predicted(lesson->attempt.answers);
        known.outcome = work.outcome_known, known.has_run = work.has_run, known.free_play = work.free_play;
        known.passed = has_passed(*lesson);
        known.at_start = is_at_start(lab);
        known.as_given = referee_of(lab.document).as_given();
        known.together = lab.together.has_value();
    }
    if (lab.pages) {
        known.page_asks = !lab.pages->current().question.options.empty();
        known.page_answers = lab.pages->shows(PagePart::answer);
    }
    known.brain_revealed = lab.view.revealed.brain;
    known.character_revealed = lab.view.revealed.character;
    return disclosure_of(open_exercise(lab), known);
}

bool is_secret(const Lab& lab, int kind) { return is_secret(open_exercise(lab), *shown_snapshot(lab).scene, kind); }

bool shows_driving_brain(const Lab& lab, const Disclosure& may, const VehicleView& vehicle) {
    return vehicle.driver == Driver::brain && may.brains && !is_secret(lab, vehicle.kind);
}

LessonView lesson_view_of(const Lab& lab) {
    const Lesson& lesson = *lab.document.lesson;
    const Attempt::Answers& answers = lesson.attempt.answers;
    const Attempt::Work& work = lesson.attempt.work;
    const Standing& standing = lesson.standing;
    const Referee& referee = referee_of(lab.document);
    LessonView view{.exercise = lesson.exercise.get(), .key = lesson.key};
    view.verdicts = referee.verdicts();
    view.by_hand = referee.by_hand();
    view.as_given = referee.as_given();
    view.at_start = is_at_start(lab);
    view.together = lab.together.has_value();
    view.prediction = answers.prediction, view.drawn_path = answers.drawn_path;
    view.hints_shown = answers.hints_shown, view.hint_ready = answers.hint_ready;
    view.hint_in = seconds_to_hint(lab);
    view.has_run = work.has_run, view.runs = work.runs, view.outcome_known = work.outcome_known;
    view.free_play = work.free_play, view.solution_shown = work.solution_shown, view.compares = work.compares;
    view.written = work.written;
    view.real_path = work.real_path;
    view.path_difference = work.path_difference, view.path_reversed = work.path_reversed;
    view.notes = lesson.attempt.notes;
    if (const Grade* grade = grade_of(lesson)) view.grade = *grade;
    view.shipped_grade = lesson.shipped_grade;
    view.starts_tested = standing.starts_tested, view.changed_since_done = standing.changed_since_done;
    view.outside_offers = standing.outside_offers, view.too_many_changes = standing.too_many_changes;
    view.passed_before = standing.passed_before, view.has_kept = standing.has_kept;
    if (const auto& selecting = lesson.selecting)
        view.selection = SelectionView{.generation = static_cast<int>(selecting->parents.size()) - 1,
                                       .parent = selecting->parent_run,
                                       .children = selecting->child_runs};
    return view;
}

}  // namespace braitenlab
