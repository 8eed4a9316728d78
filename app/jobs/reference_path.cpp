#include "app/jobs/reference_path.h"

#include <algorithm>
#include <optional>

#include "core/lesson/reference.h"

namespace braitenlab {

namespace {

// The run as a part of a job, some ticks per step.
class PathStep {
public:
    PathStep(const Exercise& exercise, const Submission& submission, std::size_t start, std::uint64_t seed,
             std::size_t ticks)
        : run_(exercise, submission, start, seed), ticks_(ticks) {}

    std::optional<ReferencePath> operator()() {
        constexpr std::size_t ticks_at_once = 60;  // about a millisecond
        known_ = std::min(known_ + ticks_at_once, ticks_);
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
    if (seed != this->seed()) run_.forget();
    run_.take();
    const std::size_t asked = run_.question() ? run_.question()->ticks : 0;
    const bool left_the_scene = asked > 0 && path().size() <= asked;
    if (run_.is_computing() || ticks <= asked || left_the_scene) return;
    run_.ask({seed, std::max(ticks, 2 * asked)});  // a longer run is computed from its start again
    run_.begin([&](const Run& run) {
        const auto begin = [exercise, submission, start, run](std::size_t) {
            return PathStep(*exercise, submission, start, run.seed, run.ticks);
        };
        return jobs.submit(1, begin, [](std::vector<ReferencePath> paths) { return std::move(paths.front()); });
    });
}

const ReferencePath& BackgroundPath::path() const {
    static const ReferencePath none;
    return run_.answer() ? *run_.answer() : none;
}

}  // namespace braitenlab
