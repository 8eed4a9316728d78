#include "app/jobs/robots.h"

#include <optional>
#include <utility>
#include <vector>

#include "core/lesson/grade.h"
#include "core/lesson/submission.h"

namespace braitenlab {

namespace {

using insight::RobotResult;
using insight::Robots;

constexpr std::size_t robot_ticks_per_step = 200;  // about half a millisecond

// The run of one robot, and its trial by the exercise.
class RobotPiece {
public:
    RobotPiece(insight::JudgedRun run, std::uint64_t seed, std::size_t ticks, const Exercise* exercise)
        : run_(std::move(run)), seed_(seed), ticks_(ticks) {
        if (exercise) trial_.emplace(*exercise, as_shipped(*exercise), seed);
    }

    std::optional<RobotResult> operator()() {
        if (trial_ && !tried_) {
            tried_ = trial_->run(static_cast<int>(robot_ticks_per_step));
            if (!tried_) return std::nullopt;
        }
        if (!run_.advance(robot_ticks_per_step)) return std::nullopt;
        RobotResult result = insight::result_of(run_, seed_, ticks_);
        if (!tried_) return result;
        result.works = tried_->passed;
        result.seconds = tried_->seconds;
        if (!result.works) result.failed_step = static_cast<int>(failed_step(*tried_));
        return result;
    }
    float progress() const { return run_.progress(); }

private:
    insight::JudgedRun run_;
    std::uint64_t seed_;
    std::size_t ticks_;
    std::optional<Trial> trial_{};
    std::optional<StartResult> tried_{};
};

std::shared_ptr<const Exercise> with_scene(const std::shared_ptr<const Exercise>& exercise, const Scene& scene) {
    if (!exercise) return nullptr;
    auto made = std::make_shared<Exercise>(*exercise);
    made->scene = scene;
    return made;
}

}  // namespace

Job<insight::RobotsReport> submit_robots(Jobs& jobs, const std::shared_ptr<const Robots>& robots,
                                         const std::shared_ptr<const Exercise>& exercise) {
    const auto real = with_scene(exercise, robots->scene()), ideal = with_scene(exercise, robots->ideal_scene());
    const auto begin = [robots, real, ideal](std::size_t part) {
        const insight::RobotsQuestion& question = robots->question();
        if (part == 0) return RobotPiece(robots->ideal_run(), question.seed, question.ticks, ideal.get());
        const int robot = static_cast<int>(part) - 1;
        return RobotPiece(robots->run(robot), robots->seed_of(robot), question.ticks, real.get());
    };
    const bool judged = exercise != nullptr;
    return jobs.submit(static_cast<std::size_t>(robots->question().robots) + 1, begin,
                       [judged](std::vector<RobotResult> results) {
                           RobotResult first = std::move(results.front());
                           results.erase(results.begin());
                           return insight::report_of(std::move(first), std::move(results), judged);
                       });
}

}  // namespace braitenlab
