#include "app/course/reference_runs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/lab.h"
#include "core/brain/brain.h"
#include "core/lesson/path_distance.h"
#include "core/lesson/reference.h"
#include "core/lesson/submission.h"
#include "core/maths/angle.h"

namespace braitenlab {

namespace {

std::size_t ticks_of(double seconds) { return static_cast<std::size_t>(std::lround(seconds / tick_seconds)); }

// The run as a part of a job, some ticks per step.
class PathStep {
public:
    PathStep(const Exercise& exercise, const Submission& submission, std::size_t start, std::uint64_t seed,
             std::size_t ticks)
        : run_(exercise, submission, start, seed), ticks_(ticks) {}

    std::optional<ReferencePath> operator()() {
        constexpr std::size_t ticks_per_step = 60;  // about a millisecond
        known_ = std::min(known_ + ticks_per_step, ticks_);
        const ReferencePath& path = run_.until(known_);
        if (known_ < ticks_ && path.size() > known_) return std::nullopt;
        return path;
    }

private:
    Reference run_;
    std::size_t ticks_, known_ = 0;
};

}  // namespace

void BackgroundPath::follow(Jobs& jobs, const std::shared_ptr<const Exercise>& exercise, const Submission& submission,
                            std::size_t start, std::uint64_t seed, std::size_t ticks) {
    if (seed != seed_) seed_ = seed, asked_ = 0, path_.clear(), job_.reset();
    if (job_)
        if (auto done = job_->take()) {
            if (*done) path_ = std::move(**done);
            job_.reset();
        }
    if (job_ || ticks <= asked_) return;
    const bool left_the_scene = asked_ > 0 && path_.size() <= asked_;
    if (left_the_scene) return;
    asked_ = std::max(ticks, 2 * asked_);  // a longer run is computed from its start again
    const auto begin = [exercise, submission, start, seed, ticks = asked_](std::size_t) {
        return PathStep(*exercise, submission, start, seed, ticks);
    };
    job_ = jobs.submit(1, begin, [](std::vector<ReferencePath> paths) { return std::move(paths.front()); });
}

namespace {

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
    lesson.runs.shipped.follow(jobs, lesson.exercise, as_shipped(*lesson.exercise), start_of_path(*lesson.exercise),
                               answers.drawn_seed, ticks);
    work.real_path = positions(lesson.runs.shipped.path(), ticks + 1, step);
    work.path_difference = path_distance(answers.drawn_path, work.real_path);
    work.path_reversed = runs_against(answers.drawn_path, work.real_path);
}

Pose between(Pose a, Pose b, float t) {
    return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t,
            maths::wrap_angle(a.heading + maths::wrap_angle(b.heading - a.heading) * t)};
}

}  // namespace

void update_reference_runs(Lab& lab, Jobs& jobs) {
    if (!lab.document.lesson) return;
    Lesson& lesson = *lab.document.lesson;
    compare_drawn_path(lesson, jobs);
    if (!lesson.attempt.work.compares) return;
    const Session& session = lab.document.session;
    const double seconds =
        std::max(session.snapshot().seconds + ahead, static_cast<double>(lesson.exercise->seconds) + ahead);
    // In steps of `ahead`, so that a running lab does not ask every tick.
    const std::size_t ticks = ticks_of(std::ceil(seconds / ahead) * ahead);
    lesson.runs.solution.follow(jobs, lesson.exercise, with_solution(*lesson.exercise), 0, session.seed(), ticks);
}

std::optional<GhostView> ghost_at(const Lab& lab, const ReferencePath& path, const Body& body) {
    const auto tick = static_cast<std::size_t>(lab.document.session.snapshot().tick);
    if (tick >= path.size()) return std::nullopt;
    const Pose now = path[tick];
    // As the vehicles are drawn; a vehicle that crosses the seam of a torus is not drawn between two ticks.
    const Pose before = tick > 0 && !lab.playback.previous.empty() ? path[tick - 1] : now;
    const bool jumps = std::hypot(now.x - before.x, now.y - before.y) > 1;
    return GhostView{jumps ? now : between(before, now, between_ticks(lab)), body.length, body.width, &path, tick + 1};
}

std::optional<GhostView> ghost_of(const Lab& lab) {
    if (!lab.document.lesson) return std::nullopt;
    const Lesson& lesson = *lab.document.lesson;
    const Session& session = lab.document.session;
    const BackgroundPath& run = lesson.runs.solution;
    if (!lesson.attempt.work.compares || referee_of(lab.document).by_hand() || run.seed() != session.seed())
        return std::nullopt;
    return ghost_at(lab, run.path(), lesson.exercise->solution.submission.body);
}

}  // namespace braitenlab
