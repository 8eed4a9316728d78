#include "app/course/lab_lesson.h"

#include <algorithm>
#include <map>
#include <utility>

#include "app/course/lesson_view.h"
#include "app/jobs/grading.h"
#include "app/lab_edits.h"
#include "app/lab_selection.h"
#include "core/lesson/grade.h"
#include "core/lesson/selection.h"

namespace braitenlab {

namespace {

// True if the kind and all its vehicles have the brain of the exercise's file.
bool is_as_shipped(const Snapshot& now, std::size_t kind, const BrainGraph& shipped) {
    return kind < now.kind_brains.size() && *now.kind_brains[kind] == shipped &&
           std::all_of(now.vehicles.begin(), now.vehicles.end(), [&](const VehicleView& v) {
               return static_cast<std::size_t>(v.kind) != kind ||
                      *now.brains[static_cast<std::size_t>(v.brain)] == shipped;
           });
}

bool has_sensors(const Snapshot& now, std::size_t kind, const std::vector<Sensor>& sensors) {
    return now.scene->kinds[kind].sensors == sensors &&
           std::all_of(now.vehicles.begin(), now.vehicles.end(), [&](const VehicleView& v) {
               return static_cast<std::size_t>(v.kind) != kind || kind_of(now, v).sensors == sensors;
           });
}

// True if this moment of a run shows what the prediction asks for: what the scene does as given, with every brain,
// sensor and body of the file and with nothing moved. A run with the student's changes does not show it, also where the
// question is about another vehicle, because its options may compare both.
bool shows_outcome(const Exercise& exercise, const Snapshot& now, const Referee& referee) {
    return now.tick > 0 && now.seconds >= static_cast<double>(exercise.prediction.after) && !referee.by_hand() &&
           referee.as_given();
}

}  // namespace

void watch(Lab& lab) {
    if (!lab.document.lesson) return;
    Lesson& lesson = *lab.document.lesson;
    bool& known = lesson.attempt.work.outcome_known;
    // A prediction about a selection is about its end, not about the first run.
    if (!known && !offers_selection(*lesson.exercise))
        known = shows_outcome(*lesson.exercise, lab.document.session.snapshot(), referee_of(lab.document));
}

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

// Whether the steps that are done say what the present submission does. `passed`: they are done in this run.
void note_changes(Lesson& lesson, const Submission& now, std::uint64_t seed, bool passed) {
    if (!passed)
        lesson.done_with.reset();
    else if (!lesson.done_with)
        lesson.done_with = now;
    lesson.standing.changed_since_done = lesson.done_with && (*lesson.done_with != now || fails_here(lesson, seed));
}

}  // namespace

void update_grading(Lab& lab, Jobs& jobs) {
    if (!lab.document.lesson) return;
    Lesson& lesson = *lab.document.lesson;
    const bool passed = referee_of(lab.document).passed();
    update_shipped_grade(lesson, jobs);
    if (!lesson.grading && !lesson.graded && !passed) {
        Standing& none = lesson.standing;
        none.outside_offers = none.too_many_changes = none.changed_since_done = false;
        lesson.done_with.reset();
        return;
    }
    Submission now = submission_of(*lesson.exercise, lab.document.session.snapshot());
    Standing& standing = lesson.standing;
    standing.is_graded = lesson.graded && lesson.graded->submission == now;
    note_changes(lesson, now, lab.document.session.seed(), passed);
    if (lesson.was_shown && now == with_solution(*lesson.exercise)) lesson.attempt.work.solution_shown = true;
    standing.outside_offers = !outside_offers(*lesson.exercise, now).empty();
    standing.too_many_changes = changes_too_many(*lesson.exercise, now);
    const bool is_allowed = !standing.outside_offers && !standing.too_many_changes;
    const bool is_due = passed && !standing.is_graded && is_allowed;
    if (lesson.grading && lesson.grading->submission != now) lesson.grading.reset();
    if (!lesson.grading && is_due) {
        auto job = submit_grading(jobs, lesson.exercise, now);
        lesson.grading = Grading{now, std::move(job)};
    }
    standing.starts_tested.reset();
    if (!lesson.grading) return;
    auto result = lesson.grading->job.take();
    if (lesson.grading->job.active()) standing.starts_tested = lesson.grading->job.progress().done;
    if (!result) return;
    if (!*result) return say(lab, result->error());  // try again after an edit
    if ((*result)->good || !lesson.grading->run_was_reset) {
        lesson.graded = GradedSubmission{std::move(now), std::move(**result)};
        standing.is_graded = true;
        lesson.attempt.work.outcome_known |= lesson.graded->grade.good;
    }
    lesson.grading.reset();
}

void reset(Lab& lab) { reset(lab, lab.document.session.seed()); }

void reset(Lab& lab, std::uint64_t seed) {
    record_paths(lab);
    LeftRun ended = present_run(lab);
    const auto new_ids = lab.document.session.restart(seed, lab.document.lesson ? Keep::submission : Keep::edits);
    keep_run(lab, std::move(ended), new_ids);
    renumber_selection(lab.view.selection, new_ids);
    lab.steered = {};  // a new run has no steering command
    lab.playback.previous.clear();
    lab.playback.debt = 0;
    forget_vehicle_notice(lab);
    if (auto& lesson = lab.document.lesson; lesson && !has_passed(*lesson)) lesson->graded.reset();
    if (lab.document.lesson && lab.document.lesson->grading) lab.document.lesson->grading->run_was_reset = true;
    watch(lab);
    keep_selection(lab);
    if (const auto& error = lab.document.session.last_reset_error()) say(lab, *error);
}

namespace {

// Gives a kind and its vehicles these sensors, this body and this brain. Calls with the same gesture are one step of
// undo.
void give_to_kind(Lab& lab, std::size_t kind, const Kind& given, std::uint64_t gesture) {
    const Snapshot& now = lab.document.session.snapshot();
    const int index = static_cast<int>(kind);
    if (!has_sensors(now, kind, given.sensors)) apply(lab, SetSensors{{.kind = index}, given.sensors}, gesture);
    if (now.scene->kinds[kind].body != given.body) apply(lab, EditKind{index, given}, gesture);
    if (!is_as_shipped(now, kind, given.brain)) apply(lab, SetBrain{{.kind = index}, given.brain}, gesture);
}

// Gives every kind what it has in the exercise's file, in one step of undo.
void take_changes_back(Lab& lab) {
    const auto& kinds = lab.document.lesson->exercise->scene.kinds;
    const std::uint64_t gesture = gestures::lab + ++lab.gesture;
    for (std::size_t k = 0; k < kinds.size(); ++k) give_to_kind(lab, k, kinds[k], gesture);
}

// The scene as in the exercise's file, at its start, and a view without what the runs have shown.
void begin_again(Lab& lab) {
    Lesson& lesson = *lab.document.lesson;
    set_mode(lab, Mode::paused);
    reset(lab);  // first: kinds may have been added or removed
    take_changes_back(lab);
    lesson.attempt.work = {};
    lesson.standing = {};
    lesson.grading.reset();
    lesson.selecting.reset();
    reset(lab);
}

}  // namespace

void start_over(Lab& lab) {
    if (!lab.document.lesson) return reset(lab);
    std::optional<GradedSubmission> graded = lab.document.lesson->graded;
    const bool has_generations = lab.document.lesson->selecting && lab.document.lesson->selecting->parents.size() > 1;
    const std::uint64_t hash = lab.document.session.hash();
    LeftRun before = run_before_start_over(lab);
    begin_again(lab);
    if (graded && graded->grade.good) lab.document.lesson->graded = std::move(graded);  // undo brings its grade back
    if (!has_generations && lab.document.session.hash() == hash) return;                // there is nothing to take back
    keep_for_undo(lab, std::move(before));
    say(lab, {NoticeKind::done, "notice.started_over"});
}

void restart_exercise(Lab& lab) {
    if (!lab.document.lesson) return reset(lab);
    begin_again(lab);
    lab.last_run.left.reset();  // of another student
    Lesson& lesson = *lab.document.lesson;
    lesson.attempt.answers = unanswered(*lesson.exercise);
    lesson.shipped_grade.reset();
    lesson.shipped_grading.reset();
    lesson.graded.reset();
    lesson.last_hint_at = lab.wall_seconds;
    watch(lab);
}

void predict(Lab& lab, const PredictRequest& request) {
    if (disclosure_of(lab).open_prediction) lab.document.lesson->attempt.answers.prediction = request.option;
}

void predict(Lab& lab, const PredictPathRequest& request) {
    if (!disclosure_of(lab).open_prediction) return;
    if (lab.document.lesson->exercise->prediction.path_of.empty()) return;
    Attempt::Answers& answers = lab.document.lesson->attempt.answers;
    answers.drawn_path = request.path;
    answers.drawn_seed = lab.document.session.seed();
}

void compare(Lab& lab, const CompareRequest& request) {
    if (auto& lesson = lab.document.lesson)
        lesson->attempt.work.compares = request.on && disclosure_of(lab).solution_run;
}

void show_hint(Lab& lab) {
    if (!lab.document.lesson) return;
    Lesson& lesson = *lab.document.lesson;
    Attempt::Answers& answers = lesson.attempt.answers;
    if (!answers.hint_ready || answers.hints_shown >= static_cast<int>(lesson.exercise->hints.size())) return;
    ++answers.hints_shown;
    answers.hint_ready = false;
    lesson.last_hint_at = lab.wall_seconds;
}

bool give_submission(Lab& lab, const Submission& submission) {
    if (!lab.document.lesson) return false;
    const Exercise& exercise = *lab.document.lesson->exercise;
    const auto kind = static_cast<std::size_t>(subject_kind(exercise.scene));
    if (kind >= lab.document.session.snapshot().scene->kinds.size()) return false;  // it was removed
    Kind given = exercise.scene.kinds[kind];
    given.brain = submission.brain, given.sensors = submission.sensors, given.body = submission.body;
    give_to_kind(lab, kind, given, gestures::lab + ++lab.gesture);
    reset(lab);
    return true;
}

void show_solution(Lab& lab) {
    if (!lab.document.lesson) return;
    if (give_submission(lab, with_solution(*lab.document.lesson->exercise)))
        lab.document.lesson->attempt.work.solution_shown = lab.document.lesson->was_shown = true;
}

}  // namespace braitenlab
