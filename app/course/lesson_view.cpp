#include "app/course/lesson_view.h"

#include <cmath>

#include "core/lesson/selection.h"
#include "core/lesson/submission.h"

namespace braitenlab {

namespace {

const Exercise* open_exercise(const Workspace& space) {
    return space.document.lesson ? space.document.lesson->exercise.get() : nullptr;
}

bool is_at_start(const Workspace& space) {
    const auto& selecting = space.document.lesson->selecting;
    return space.document.session.snapshot().tick == 0 && !(selecting && selecting->parents.size() > 1);
}

// Seconds until the next hint may be shown without a run; 0 if it may be shown now.
int seconds_to_hint(const Workspace& space) {
    const Lesson& lesson = *space.document.lesson;
    if (lesson.attempt.answers.hint_ready) return 0;
    return static_cast<int>(std::ceil(seconds_between_hints - (space.wall_seconds - lesson.last_hint_at)));
}

// True if this moment of a run shows what the prediction asks for: what the scene does as given, with every brain,
// sensor and body of the file and with nothing moved. A run with the student's changes does not show it, also where the
// question is about another vehicle, because its options may compare both. Where the student breeds, the question is
// about what was bred: a run with it shows it.
bool shows_outcome(const Exercise& exercise, const Snapshot& now, const Referee& referee) {
    const bool asks_about_given = offered_breeding(exercise).empty();
    return now.tick > 0 && now.seconds >= static_cast<double>(exercise.prediction.after) && !referee.by_hand() &&
           referee.as_given() == asks_about_given;
}

}  // namespace

void watch(Workspace& space) {
    if (!space.document.lesson) return;
    Lesson& lesson = *space.document.lesson;
    bool& known = lesson.attempt.work.outcome_known;
    // A prediction about a selection is about its end, not about the first run.
    if (!known && !offers_selection(*lesson.exercise))
        known = shows_outcome(*lesson.exercise, space.document.session.snapshot(), referee_of(space.document));
}

Disclosure disclosure_of(const Workspace& space) {
    Known known;
    if (const auto& lesson = space.document.lesson) {
        const Attempt::Work& work = lesson->attempt.work;
        known.predicted = has_predicted(lesson->attempt.answers);
        known.outcome = work.outcome_known, known.has_run = work.has_run, known.free_play = work.free_play;
        known.passed = has_passed(*lesson);
        known.at_start = is_at_start(space);
        known.as_given = referee_of(space.document).as_given();
        known.together = space.together.has_value();
    }
    if (space.pages) {
        known.page_asks = !space.pages->current().question.options.empty();
        known.page_answers = space.pages->shows(PagePart::answer);
    }
    known.brain_revealed = space.view.revealed.brain;
    known.character_revealed = space.view.revealed.character;
    return disclosure_of(open_exercise(space), known);
}

bool is_secret(const Workspace& space, int kind) {
    return is_secret(open_exercise(space), *shown_snapshot(space).scene, kind);
}

bool shows_driving_brain(const Workspace& space, const Disclosure& may, const VehicleView& vehicle) {
    return vehicle.driver == Driver::brain && may.brains && !is_secret(space, vehicle.kind);
}

LessonView lesson_view_of(const Workspace& space) {
    const Lesson& lesson = *space.document.lesson;
    const Referee& referee = referee_of(space.document);
    LessonView view{.exercise = lesson.exercise.get(),
                    .key = lesson.key,
                    .attempt = lesson.attempt,
                    .standing = lesson.standing,
                    .verdicts = referee.verdicts(),
                    .at_start = is_at_start(space),
                    .as_given = referee.as_given(),
                    .by_hand = referee.by_hand(),
                    .hint_in = seconds_to_hint(space),
                    .shipped_grade = lesson.shipped_grade,
                    .together = space.together.has_value()};
    if (const Grade* grade = grade_of(lesson)) view.grade = *grade;
    if (lesson.gains.is_computing())
        view.gains.reset();
    else if (const auto* gains = lesson.gains.answer())
        view.gains = *gains;
    if (const auto& selecting = lesson.selecting)
        view.selection = SelectionView{.generation = static_cast<int>(selecting->parents.size()) - 1,
                                       .parent = selecting->parent_run,
                                       .children = selecting->child_runs,
                                       .stays = selecting->child_stays};
    return view;
}

}  // namespace braitenlab
