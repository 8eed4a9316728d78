#include "app/lab_reset.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "app/course/lesson_view.h"
#include "app/lab_edits.h"
#include "app/lab_selection.h"
#include "core/lesson/submission.h"

namespace braitenlab {

void reset(Lab& lab) { reset(lab, lab.document.session.seed()); }

void reset(Lab& lab, std::uint64_t seed) {
    record_paths(lab.last_run, lab);
    LeftRun ended = present_run(lab.last_run, lab);
    const auto new_ids = lab.document.session.restart(seed, lab.document.lesson ? Keep::submission : Keep::edits);
    keep_run(lab.last_run, lab, std::move(ended), new_ids);
    renumber_selection(lab.view.selection, new_ids);
    lab.steered = {};  // a new run has no steering command
    forget_motion(lab);
    forget_vehicle_notice(lab);
    if (auto& lesson = lab.document.lesson; lesson && !has_passed(*lesson)) lesson->graded.reset();
    if (lab.document.lesson && lab.document.lesson->grading) lab.document.lesson->grading->run_was_reset = true;
    watch(lab);
    keep_selection(lab);
    if (const auto& error = lab.document.session.last_reset_error()) say(lab, *error);
}

namespace {

// True if the kind and all its vehicles have the brain of the exercise's file.
bool is_as_shipped(const Snapshot& now, std::size_t kind, const BrainGraph& shipped) {
    return kind < now.kind_brains.size() && *now.kind_brains[kind] == shipped &&
           std::all_of(now.vehicles.begin(), now.vehicles.end(), [&](const VehicleView& v) {
               return static_cast<std::size_t>(v.kind) != kind || *brain_of(now, v) == shipped;
           });
}

bool has_sensors(const Snapshot& now, std::size_t kind, const std::vector<Sensor>& sensors) {
    return now.scene->kinds[kind].sensors == sensors &&
           std::all_of(now.vehicles.begin(), now.vehicles.end(), [&](const VehicleView& v) {
               return static_cast<std::size_t>(v.kind) != kind || kind_of(now, v).sensors == sensors;
           });
}

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
    const std::uint64_t gesture = new_gesture(lab);
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
    LeftRun before = run_before_start_over(lab.last_run, lab);
    begin_again(lab);
    if (graded && graded->grade.good) lab.document.lesson->graded = std::move(graded);  // undo brings its grade back
    if (!has_generations && lab.document.session.hash() == hash) return;                // there is nothing to take back
    keep_for_undo(lab.last_run, lab, std::move(before));
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

bool give_submission(Lab& lab, const Submission& submission) {
    if (!lab.document.lesson) return false;
    const Exercise& exercise = *lab.document.lesson->exercise;
    const auto kind = static_cast<std::size_t>(subject_kind(exercise.scene));
    if (kind >= lab.document.session.snapshot().scene->kinds.size()) return false;  // it was removed
    Kind given = exercise.scene.kinds[kind];
    given.brain = submission.brain, given.sensors = submission.sensors, given.body = submission.body;
    give_to_kind(lab, kind, given, new_gesture(lab));
    reset(lab);
    return true;
}

void show_solution(Lab& lab) {
    if (!lab.document.lesson) return;
    if (give_submission(lab, with_solution(*lab.document.lesson->exercise)))
        lab.document.lesson->attempt.work.solution_shown = lab.document.lesson->was_shown = true;
}

}  // namespace braitenlab
