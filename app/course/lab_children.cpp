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

// Of brains from their starts.
struct RunOfChild {
    std::size_t child = 0;  // 0: the parent, then its children
    std::uint64_t seed = 1;
};

Job<std::vector<StartResult>> submit_runs(Jobs& jobs, const Lesson& lesson, std::vector<RunOfChild> runs) {
    constexpr int ticks_per_step = 60;  // about a millisecond
    const Parent& parent = lesson.selecting->parents.back();
    std::vector<BrainGraph> brains = children_of(*lesson.exercise, parent);
    brains.insert(brains.begin(), parent.brain);
    const std::size_t count = runs.size();
    const auto begin = [exercise = lesson.exercise, brains = std::move(brains),
                        runs = std::move(runs)](std::size_t part) {
        const RunOfChild& run = runs[part];
        return [trial = Trial(*exercise, with_brain(*exercise, brains[run.child]), run.seed)]() mutable {
            return trial.run(ticks_per_step);
        };
    };
    return jobs.submit(count, begin);
}

// The parent and its children at the shown start.
std::vector<RunOfChild> runs_at_shown_start(const Lesson& lesson) {
    const std::size_t children = children_of(*lesson.exercise, lesson.selecting->parents.back()).size();
    std::vector<RunOfChild> runs;
    for (std::size_t child = 0; child <= children; ++child) runs.push_back({child, lesson.selecting->start});
    return runs;
}

// The children that stay at the shown start, where several do, at the other ones: these tell them apart.
std::vector<RunOfChild> runs_at_other_starts(const Lesson& lesson) {
    const Selecting& selecting = *lesson.selecting;
    std::vector<RunOfChild> runs;
    for (std::size_t i = 0; i < selecting.child_runs.size(); ++i)
        for (std::uint64_t other = 1; other <= other_starts; ++other)
            if (!has_fallen(*lesson.exercise, selecting.child_runs[i]))
                runs.push_back({i + 1, selecting.start + other});
    if (runs.size() <= other_starts) runs.clear();
    return runs;
}

void take_stays(Lesson& lesson, const std::vector<StartResult>& results) {
    const std::vector<RunOfChild> runs = runs_at_other_starts(lesson);
    std::vector<int>& stays = lesson.selecting->child_stays;
    stays.assign(lesson.selecting->child_runs.size(), 0);
    for (std::size_t i = 0; i < std::min(runs.size(), results.size()); ++i)
        stays[runs[i].child - 1] += has_fallen(*lesson.exercise, results[i]) ? 0 : 1;
}

// Submits the next runs that are missing.
void submit_missing(Jobs& jobs, Lesson& lesson) {
    Selecting& selecting = *lesson.selecting;
    std::vector<RunOfChild> missing;
    if (!selecting.parent_run)
        missing = runs_at_shown_start(lesson);
    else if (selecting.child_stays.empty())
        missing = runs_at_other_starts(lesson);
    if (!missing.empty()) selecting.job = submit_runs(jobs, lesson, std::move(missing));
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
    Selecting& selecting = *lesson.selecting;
    const auto result = selecting.job.take();
    if (!result) {
        if (!selecting.job.active()) submit_missing(jobs, lesson);
    } else if (!*result) {  // not tried again before the brain or the start changes
        if (!selecting.parent_run) selecting.parent_run.emplace();
        selecting.child_stays.assign(selecting.child_runs.size(), 0);
        return say(lab, result->error());
    } else if (selecting.child_runs.empty()) {
        selecting.parent_run = (**result).front();
        selecting.child_runs.assign((**result).begin() + 1, (**result).end());
        submit_missing(jobs, lesson);
    } else {
        take_stays(lesson, **result);
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
