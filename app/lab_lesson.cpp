#include "app/lab_lesson.h"

#include <algorithm>

#include "app/lab_requests.h"
#include "app/lab_selection.h"
#include "core/lesson/grade.h"

namespace braitenlab {

namespace {

// True for what the student is asked to change and for commands without effect on the run.
bool is_fair(const Command& command) {
    return std::holds_alternative<TurnDial>(command) || std::holds_alternative<SetBrain>(command) ||
           std::holds_alternative<PlaceNodes>(command) || std::holds_alternative<SetSensors>(command) ||
           std::holds_alternative<Steer>(command) || std::holds_alternative<Retitle>(command);
}

// True if the kind and all its vehicles have the exercise's own brain.
bool is_as_shipped(const Snapshot& now, std::size_t kind, const BrainGraph& shipped) {
    return *now.kind_brains[kind] == shipped &&
           std::all_of(now.vehicles.begin(), now.vehicles.end(), [&](const VehicleView& v) {
               return static_cast<std::size_t>(v.kind) != kind ||
                      *now.brains[static_cast<std::size_t>(v.brain)] == shipped;
           });
}

}  // namespace

void tell_referee(Lab& lab, const Command& command) {
    if (!lab.document.lesson || is_fair(command)) return;
    const Snapshot& now = lab.document.session.snapshot();
    if (now.tick > 0) {  // before the first tick the referee compares the scene itself
        lab.document.lesson->referee.disturb();
        auto& referees = lab.playback.referees;  // going back to this tick finds the run disturbed
        while (!referees.empty() && referees.back().tick >= now.tick) referees.pop_back();
        referees.push_back({now.tick, lab.document.lesson->referee});
    }
    watch(lab);
}

void watch(Lab& lab) {
    if (!lab.document.lesson) return;
    Lesson& lesson = *lab.document.lesson;
    lesson.referee.watch(lab.document.session.snapshot());
    lesson.view.verdicts = lesson.referee.verdicts();
    lesson.view.by_hand = lesson.referee.by_hand();
}

namespace {

Job<Grade> grade_in_background(Jobs& jobs, const std::shared_ptr<const Exercise>& exercise,
                               const Submission& submission) {
    constexpr int ticks_per_step = 60;  // about a millisecond
    const auto begin = [exercise, submission](std::size_t start) {
        return [trial = Trial(*exercise, submission, start + 1)]() mutable { return trial.run(ticks_per_step); };
    };
    return jobs.submit(static_cast<std::size_t>(exercise->starts), begin,
                       [exercise](std::vector<bool> passed) { return grade_of(*exercise, std::move(passed)); });
}

}  // namespace

void update_grading(Lab& lab, Jobs& jobs) {
    if (!lab.document.lesson) return;
    Lesson& lesson = *lab.document.lesson;
    const bool is_due = lesson.referee.passed() && !lesson.view.grade;
    if (!lesson.grading && !is_due) return;
    Submission now = submission_of(*lesson.exercise, lab.document.session.snapshot());
    if (lesson.grading && lesson.grading->submission != now) lesson.grading.reset();
    if (!lesson.grading && is_due) {
        auto job = grade_in_background(jobs, lesson.exercise, now);
        lesson.grading = Grading{std::move(now), std::move(job)};
    }
    lesson.view.starts_tested.reset();
    if (!lesson.grading) return;
    auto result = lesson.grading->job.take();
    if (lesson.grading->job.active()) lesson.view.starts_tested = lesson.grading->job.progress().done;
    if (!result) return;
    if (!*result) return say(lab, {NoticeKind::failure, "", result->error().text()});  // try again after an edit
    if ((*result)->good || !lesson.grading->run_was_reset) lesson.view.grade = std::move(**result);
    lesson.grading.reset();
}

void reset(Lab& lab) {
    lab.document.session.reset(lab.document.lesson ? Keep::brains : Keep::edits);
    lab.playback.referees.clear();
    lab.playback.previous.clear();
    lab.playback.debt = 0;
    if (lab.document.lesson && !(lab.document.lesson->view.grade && lab.document.lesson->view.grade->good))
        lab.document.lesson->view.grade.reset();
    if (lab.document.lesson && lab.document.lesson->grading) lab.document.lesson->grading->run_was_reset = true;
    watch(lab);
    keep_selection(lab);
}

// The brain is replaced by an edit, so that it can be undone.
void restart_exercise(Lab& lab) {
    if (!lab.document.lesson) return reset(lab);
    Lesson& lesson = *lab.document.lesson;
    set_mode(lab, Mode::paused);
    for (std::size_t k = 0; k < lesson.exercise->scene.kinds.size(); ++k)
        if (!is_as_shipped(lab.document.session.snapshot(), k, lesson.exercise->scene.kinds[k].brain))
            apply(lab, SetBrain{{.kind = static_cast<int>(k)}, lesson.exercise->scene.kinds[k].brain});
    lesson.view = {.exercise = lesson.exercise.get()};
    lesson.grading.reset();
    lesson.last_hint_at = lab.wall_seconds;
    lesson.referee = Referee(*lesson.exercise);
    reset(lab);
}

void show_hint(Lab& lab) {
    if (!lab.document.lesson) return;
    LessonView& view = lab.document.lesson->view;
    if (!view.hint_ready || view.hints_shown >= static_cast<int>(view.exercise->hints.size())) return;
    ++view.hints_shown;
    view.hint_ready = false;
    lab.document.lesson->last_hint_at = lab.wall_seconds;
}

}  // namespace braitenlab
