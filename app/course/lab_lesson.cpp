#include "app/course/lab_lesson.h"

#include <algorithm>
#include <utility>

#include "app/course/lesson_view.h"
#include "app/jobs/grading.h"
#include "core/lesson/grade.h"
#include "core/lesson/submission.h"
#include "core/scene/sensor_pairs.h"
#include "core/scene/subject.h"

namespace braitenlab {

namespace {

// The starts as shipped, for an exercise that compares medians, once a submission has a grade.
void update_shipped_grade(Lesson& lesson, Jobs& jobs) {
    if (lesson.exercise->median.step == 0 || !lesson.graded || lesson.shipped_grade) return;
    if (!lesson.shipped_grading)
        lesson.shipped_grading = submit_grading(jobs, lesson.exercise, as_shipped(*lesson.exercise));
    if (auto result = lesson.shipped_grading->take(); result && *result) lesson.shipped_grade = std::move(**result);
}

// True if the grade has the start of the present run as failed: then the brain was changed during the run.
bool fails_here(const Lesson& lesson, std::uint64_t seed) {
    const Grade* grade = grade_of(lesson);
    return grade && std::any_of(grade->starts.begin(), grade->starts.end(),
                                [seed](const StartResult& start) { return start.seed == seed && !start.passed; });
}

// True also if only places in the diagram differ: they change no run.
bool is_same(const Submission& a, const Submission& b) { return a == b || is_same_submission(a, b); }

// Whether the steps that are done say what the present submission does. `passed`: they are done in this run.
void note_changes(Lesson& lesson, const Submission& now, std::uint64_t seed, bool passed) {
    if (!passed)
        lesson.done_with.reset();
    else if (!lesson.done_with)
        lesson.done_with = now;
    lesson.standing.changed_since_done =
        lesson.done_with && (!is_same(*lesson.done_with, now) || fails_here(lesson, seed));
}

}  // namespace

void update_grading(Workspace& space, Jobs& jobs) {
    if (!space.document.lesson) return;
    Lesson& lesson = *space.document.lesson;
    const bool passed = referee_of(space.document).passed();
    update_shipped_grade(lesson, jobs);
    if (!lesson.grading && !lesson.graded && !passed) {
        Standing& none = lesson.standing;
        none.outside_offers = none.too_many_changes = none.changed_since_done = false;
        lesson.done_with.reset();
        return;
    }
    Submission now = submission_of(*lesson.exercise, space.document.session.snapshot());
    Standing& standing = lesson.standing;
    standing.is_graded = lesson.graded && is_same(lesson.graded->submission, now);
    note_changes(lesson, now, space.document.session.seed(), passed);
    if (lesson.was_shown && now == with_solution(*lesson.exercise)) lesson.attempt.work.solution_shown = true;
    standing.outside_offers = !outside_offers(*lesson.exercise, now).empty();
    standing.too_many_changes = changes_too_many(*lesson.exercise, now);
    const bool is_allowed = !standing.outside_offers && !standing.too_many_changes;
    const bool is_due = passed && !standing.is_graded && is_allowed;
    if (lesson.grading && !is_same(lesson.grading->submission, now)) lesson.grading.reset();
    if (!lesson.grading && is_due) {
        auto job = submit_grading(jobs, lesson.exercise, now);
        lesson.grading = Grading{now, std::move(job)};
    }
    standing.starts_tested.reset();
    if (!lesson.grading) return;
    auto result = lesson.grading->job.take();
    if (lesson.grading->job.active()) standing.starts_tested = lesson.grading->job.progress().done;
    if (!result) return;
    if (!*result) return say(space, result->error());  // try again after an edit
    if ((*result)->good || !lesson.grading->run_was_reset) {
        lesson.graded = GradedSubmission{std::move(now), std::move(**result)};
        standing.is_graded = true;
        lesson.attempt.work.outcome_known |= lesson.graded->grade.good;
    }
    lesson.grading.reset();
}

void update_gains(Workspace& space, Jobs& jobs) {
    if (!space.document.lesson) return;
    Lesson& lesson = *space.document.lesson;
    const Snapshot& now = space.document.session.snapshot();
    const bool is_wanted = lesson.attempt.work.has_run && !lesson.attempt.work.free_play && !has_passed(lesson);
    if (!is_wanted || offered_dials(*lesson.exercise).empty()) return;
    const auto kind = static_cast<std::size_t>(subject_kind(*now.scene));
    const GainQuestion question{space.document.edits, now.kind_brains[kind],
                                chosen_pair(now.scene->kinds[kind], space.view.selection.pair)};
    if (!lesson.gains.is_about(question)) lesson.gains.ask(question);
    lesson.gains.follow([&](const GainQuestion& asked) -> Result<Job<std::vector<float>>> {
        return submit_gains(jobs, lesson.exercise, submission_of(*lesson.exercise, now), asked.pair);
    });
}

void predict(Workspace& space, const PredictRequest& request) {
    if (disclosure_of(space).open_prediction) space.document.lesson->attempt.answers.prediction = request.option;
}

void predict(Workspace& space, const PredictPathRequest& request) {
    if (!disclosure_of(space).open_prediction) return;
    if (space.document.lesson->exercise->prediction.path_of.empty()) return;
    Attempt::Answers& answers = space.document.lesson->attempt.answers;
    answers.drawn_path = request.path;
    answers.drawn_seed = space.document.session.seed();
}

void compare(Workspace& space, const CompareRequest& request) {
    if (auto& lesson = space.document.lesson)
        lesson->attempt.work.compares = request.on && disclosure_of(space).solution_run;
}

void show_hint(Workspace& space) {
    if (!space.document.lesson) return;
    Lesson& lesson = *space.document.lesson;
    Attempt::Answers& answers = lesson.attempt.answers;
    if (!answers.hint_ready || answers.hints_shown >= static_cast<int>(lesson.exercise->hints.size())) return;
    ++answers.hints_shown;
    answers.hint_ready = false;
    lesson.last_hint_at = space.wall_seconds;
}

void show_starts_together(Workspace& space) {
    const auto& lesson = space.document.lesson;
    if (!lesson || !has_passed(*lesson)) return;
    Together together = begin_together(*lesson->exercise, lesson->graded->submission, lesson->graded->grade);
    if (!together.worlds.empty()) begin_together(space, std::move(together));
}

}  // namespace braitenlab
