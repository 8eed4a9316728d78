#include "app/course/lab_children.h"

#include <algorithm>
#include <utility>

#include "app/lab_edits.h"
#include "app/lab_reset.h"

namespace braitenlab {

namespace {

// The vehicle's brain now.
BrainGraph present_brain(const Lab& lab) {
    return submission_of(*lab.document.lesson->exercise, lab.document.session.snapshot()).brain;
}

void forget_runs(Lesson& lesson) {
    lesson.selecting->job.cancel();
    lesson.selecting->parent_run.reset();
    lesson.selecting->child_runs.clear();
    lesson.selecting->child_stays.clear();
}

// Each selection from the first generation on has other children.
void begin_selecting(Lab& lab) {
    Lesson& lesson = *lab.document.lesson;
    const std::uint64_t start = lab.document.session.seed();
    const Parent first{as_shipped(*lesson.exercise).brain, start * 1000 + ++lesson.selections};
    lesson.selecting = Selecting{.parents = {first}, .start = start};
    forget_runs(lesson);
}

// After an undo, a redo or an edit by hand.
void follow_brain(Lesson& lesson, const BrainGraph& now) {
    std::vector<Parent>& parents = lesson.selecting->parents;
    if (same_wiring(parents.back().brain, now)) return;
    std::vector<Parent>& undone = lesson.selecting->undone;
    const auto has_brain = [&](const Parent& parent) { return same_wiring(parent.brain, now); };
    const auto earlier = std::find_if(parents.rbegin(), parents.rend(), has_brain);
    const auto later = std::find_if(undone.begin(), undone.end(), has_brain);
    if (earlier != parents.rend()) {
        undone.insert(undone.begin(), earlier.base(), parents.end());
        parents.erase(earlier.base(), parents.end());
    } else if (later != undone.end()) {
        parents.insert(parents.end(), undone.begin(), later + 1);
        undone.erase(undone.begin(), later + 1);
    } else {
        parents.back().brain = now;
    }
    forget_runs(lesson);
}

// The run of the parent at the shown start, then those of each of its children there and at other_starts more.
constexpr std::size_t starts_of_a_child = 1 + other_starts;

Job<std::vector<StartResult>> submit_runs(Jobs& jobs, const Lesson& lesson) {
    constexpr int ticks_per_step = 60;  // about a millisecond
    const Parent& parent = lesson.selecting->parents.back();
    std::vector<BrainGraph> brains = children_of(*lesson.exercise, parent);
    brains.insert(brains.begin(), parent.brain);
    const std::size_t count = 1 + (brains.size() - 1) * starts_of_a_child;
    const auto begin = [exercise = lesson.exercise, brains = std::move(brains),
                        start = lesson.selecting->start](std::size_t part) {
        const std::size_t brain = part == 0 ? 0 : 1 + (part - 1) / starts_of_a_child;
        const std::uint64_t seed = part == 0 ? start : start + (part - 1) % starts_of_a_child;
        return [trial = Trial(*exercise, with_brain(*exercise, brains[brain]), seed)]() mutable {
            return trial.run(ticks_per_step);
        };
    };
    return jobs.submit(count, begin);
}

void take_runs(Lesson& lesson, const std::vector<StartResult>& runs) {
    Selecting& selecting = *lesson.selecting;
    selecting.parent_run = runs.front();
    for (std::size_t first = 1; first < runs.size(); first += starts_of_a_child) {
        selecting.child_runs.push_back(runs[first]);
        const auto others = runs.begin() + static_cast<std::ptrdiff_t>(first) + 1;
        selecting.child_stays.push_back(static_cast<int>(std::count_if(
            others, others + other_starts, [&](const auto& run) { return !has_fallen(*lesson.exercise, run); })));
    }
}

void give_brain(Lab& lab, const BrainGraph& brain) {
    const int kind = subject_kind(lab.document.lesson->exercise->scene);
    const auto index = static_cast<std::size_t>(kind);
    if (index >= lab.document.session.snapshot().scene->kinds.size()) return;  // it was removed
    if (!same_wiring(present_brain(lab), brain)) apply(lab, SetBrain{{.kind = kind}, brain}, new_gesture(lab));
    reset(lab);
}

}  // namespace

void update_children(Lab& lab, Jobs& jobs) {
    if (!lab.document.lesson || !offers_selection(*lab.document.lesson->exercise)) return;
    Lesson& lesson = *lab.document.lesson;
    if (!lesson.selecting) begin_selecting(lab);
    follow_brain(lesson, present_brain(lab));
    const std::uint64_t start = lab.document.session.seed();
    if (std::exchange(lesson.selecting->start, start) != start) forget_runs(lesson);
    Job<std::vector<StartResult>>& job = lesson.selecting->job;
    Selecting& selecting = *lesson.selecting;
    if (auto result = job.take()) {
        if (!*result) {
            selecting.parent_run.emplace();  // not tried again before the brain or the start changes
            return say(lab, result->error());
        }
        take_runs(lesson, **result);
    } else if (!selecting.parent_run && !job.active()) {
        job = submit_runs(jobs, lesson);
    }
}

void choose_child(Lab& lab, int child) {
    if (!lab.document.lesson || !lab.document.lesson->selecting) return;
    Lesson& lesson = *lab.document.lesson;
    if (lesson.selecting->child_runs.empty()) return;  // they are computed
    const int count = static_cast<int>(lesson.selecting->child_runs.size());
    const int generations = static_cast<int>(lesson.selecting->parents.size()) - 1;
    if (child < -1 || child >= count || generations >= lesson.exercise->selection.generations) return;
    const Parent& parent = lesson.selecting->parents.back();
    const std::size_t index = child < 0 ? static_cast<std::size_t>(count) : static_cast<std::size_t>(child);
    const BrainGraph brain = child < 0 ? parent.brain : children_of(*lesson.exercise, parent)[index];
    lesson.selecting->parents.push_back(chosen(parent, brain, index));
    lesson.selecting->undone.clear();
    forget_runs(lesson);
    give_brain(lab, brain);
}

void take_choice_back(Lab& lab) {
    if (!lab.document.lesson || !lab.document.lesson->selecting) return;
    Lesson& lesson = *lab.document.lesson;
    if (lesson.selecting->parents.size() < 2) return;
    lesson.selecting->parents.pop_back();
    forget_runs(lesson);
    give_brain(lab, BrainGraph(lesson.selecting->parents.back().brain));
}

}  // namespace braitenlab
