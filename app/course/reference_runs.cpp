#include "app/course/reference_runs.h"

#include <algorithm>
#include <cmath>

#include "core/brain/brain.h"
#include "core/lesson/path_distance.h"
#include "core/lesson/submission.h"

namespace braitenlab {

namespace {

std::size_t ticks_of(double seconds) { return static_cast<std::size_t>(std::lround(seconds / tick_seconds)); }

constexpr double ahead = 10;  // s that the run with the solution is computed before they are shown

std::size_t start_of_path(const Exercise& exercise) {
    const auto& starts = exercise.scene.starts;
    const auto found = std::find_if(starts.begin(), starts.end(),
                                    [&](const Start& each) { return each.name == exercise.prediction.path_of; });
    return static_cast<std::size_t>(found - starts.begin());
}

void compare_drawn_path(Lesson& lesson, Jobs& jobs) {
    constexpr std::size_t step = 6;  // ticks: ten points a second
    const Attempt::Answers& answers = lesson.attempt.answers;
    Attempt::Work& work = lesson.attempt.work;
    if (!work.outcome_known || answers.drawn_path.empty() || !work.real_path.empty()) return;
    const std::size_t ticks = ticks_of(static_cast<double>(lesson.exercise->prediction.after));
    lesson.shipped_path.follow(jobs, lesson.exercise, as_shipped(*lesson.exercise), start_of_path(*lesson.exercise),
                               answers.drawn_seed, ticks);
    work.real_path = positions(lesson.shipped_path.path(), ticks + 1, step);
    work.path_difference = path_distance(answers.drawn_path, work.real_path);
    work.path_reversed = runs_against(answers.drawn_path, work.real_path);
}

}  // namespace

void update_reference_runs(Workspace& space, Jobs& jobs) {
    if (!space.document.lesson) return;
    Lesson& lesson = *space.document.lesson;
    compare_drawn_path(lesson, jobs);
    if (!lesson.attempt.work.compares) return;
    const Session& session = space.document.session;
    const double seconds =
        std::max(session.snapshot().seconds + ahead, static_cast<double>(lesson.exercise->seconds) + ahead);
    // In steps of `ahead`, so that a running lab does not ask every tick.
    const std::size_t ticks = ticks_of(std::ceil(seconds / ahead) * ahead);
    lesson.solution_path.follow(jobs, lesson.exercise, with_solution(*lesson.exercise), 0, session.seed(), ticks);
}

std::optional<GhostView> ghost_of(const Workspace& space) {
    if (!space.document.lesson) return std::nullopt;
    const Lesson& lesson = *space.document.lesson;
    const Session& session = space.document.session;
    const BackgroundPath& run = lesson.solution_path;
    if (!lesson.attempt.work.compares || referee_of(space.document).by_hand() || run.seed() != session.seed())
        return std::nullopt;
    return ghost_at(space, run.path(), lesson.exercise->solution.submission.body);
}

}  // namespace braitenlab
