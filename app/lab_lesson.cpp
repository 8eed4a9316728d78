// An exercise in the lab: its judge, its hints, and the way back to its start.
#include <algorithm>

#include "app/lab_parts.h"

namespace braitenlab {

namespace {

// What a student is asked to change, or what changes nobody's chances.
bool is_fair(const Command& command) {
    return std::holds_alternative<TurnDial>(command) || std::holds_alternative<SetBrain>(command) ||
           std::holds_alternative<PlaceNodes>(command) || std::holds_alternative<SetSensors>(command) ||
           std::holds_alternative<Steer>(command) || std::holds_alternative<Retitle>(command);
}

// Whether all of the kind have the brain that came with the exercise.
bool is_as_shipped(const Snapshot& now, std::size_t kind, const BrainGraph& shipped) {
    return *now.kind_brains[kind] == shipped &&
           std::all_of(now.vehicles.begin(), now.vehicles.end(), [&](const VehicleView& v) {
               return static_cast<std::size_t>(v.kind) != kind ||
                      *now.brains[static_cast<std::size_t>(v.brain)] == shipped;
           });
}

}  // namespace

void tell_judge(Lab& lab, const Command& command) {
    if (!lab.lesson || is_fair(command)) return;
    const Snapshot& now = lab.session.snapshot();
    if (now.tick > 0) {  // before the first tick the judge sees for itself
        lab.lesson->referee.disturb();
        auto& judged = lab.past.judged;  // who comes back to this moment finds it disturbed
        while (!judged.empty() && judged.back().tick >= now.tick) judged.pop_back();
        judged.push_back({now.tick, lab.lesson->referee});
    }
    watch(lab);
}

void watch(Lab& lab) {
    if (!lab.lesson) return;
    Lesson& lesson = *lab.lesson;
    lesson.referee.watch(lab.session.snapshot());
    lesson.view.verdicts = lesson.referee.verdicts();
    lesson.view.by_hand = lesson.referee.by_hand();
    if (!lesson.referee.passed() || lesson.view.grade) return;
    // Every step is done in this run: now it must hold from the other starts as well.
    lesson.view.grade = grade(*lesson.exercise, submission_of(*lesson.exercise, lab.session.snapshot()));
}

void reset(Lab& lab) {
    lab.session.reset(lab.lesson ? Keep::brains : Keep::edits);
    lab.past.judged.clear();
    lab.before.clear();
    lab.debt = 0;
    if (lab.lesson && !(lab.lesson->view.grade && lab.lesson->view.grade->good)) lab.lesson->view.grade.reset();
    watch(lab);
    keep_selection(lab);
}

// The exercise as it was on opening; the brain comes back by an edit, so that it can be undone.
void restart_exercise(Lab& lab) {
    if (!lab.lesson) return reset(lab);
    Lesson& lesson = *lab.lesson;
    set_mode(lab, Mode::paused);
    for (std::size_t k = 0; k < lesson.exercise->scene.kinds.size(); ++k)
        if (!is_as_shipped(lab.session.snapshot(), k, lesson.exercise->scene.kinds[k].brain))
            apply(lab, SetBrain{{.kind = static_cast<int>(k)}, lesson.exercise->scene.kinds[k].brain});
    lesson.view = {.exercise = lesson.exercise.get()};
    lesson.last_hint_at = lab.wall_seconds;
    lesson.referee = Referee(*lesson.exercise);
    reset(lab);
}

void show_hint(Lab& lab) {
    if (!lab.lesson) return;
    LessonView& view = lab.lesson->view;
    if (!view.hint_ready || view.hints_shown >= static_cast<int>(view.exercise->hints.size())) return;
    ++view.hints_shown;
    view.hint_ready = false;
    lab.lesson->last_hint_at = lab.wall_seconds;
}

}  // namespace braitenlab
