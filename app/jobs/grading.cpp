#include "app/jobs/grading.h"

#include "core/lesson/gain.h"

namespace braitenlab {

namespace {

constexpr int ticks_per_step = 60;  // about a millisecond

}  // namespace

Job<Grade> submit_grading(Jobs& jobs, const std::shared_ptr<const Exercise>& exercise, const Submission& submission,
                          std::uint64_t first_seed) {
    const auto begin = [exercise, submission, first_seed](std::size_t start) {
        return
            [trial = Trial(*exercise, submission, first_seed + start)]() mutable { return trial.run(ticks_per_step); };
    };
    return jobs.submit(static_cast<std::size_t>(exercise->starts), begin,
                       [exercise](std::vector<StartResult> starts) { return grade_of(*exercise, std::move(starts)); });
}

Job<std::vector<float>> submit_gains(Jobs& jobs, const std::shared_ptr<const Exercise>& exercise,
                                     const Submission& submission, const SensorPair& pair) {
    const auto tries = std::make_shared<const std::vector<Submission>>(tries_of(*exercise, submission, pair));
    const auto begin = [exercise, tries](std::size_t each) {
        return
            [trial = Trial(*exercise, (*tries)[each], exercise->seed)]() mutable { return trial.run(ticks_per_step); };
    };
    return jobs.submit(tries->size(), begin, [](const std::vector<StartResult>& runs) { return gains_of(runs); });
}

}  // namespace braitenlab
