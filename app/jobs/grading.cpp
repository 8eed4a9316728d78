#include "app/jobs/grading.h"

namespace braitenlab {

Job<Grade> submit_grading(Jobs& jobs, const std::shared_ptr<const Exercise>& exercise, const Submission& submission,
                          std::uint64_t first_seed) {
    constexpr int ticks_per_step = 60;  // about a millisecond
    const auto begin = [exercise, submission, first_seed](std::size_t start) {
        return
            [trial = Trial(*exercise, submission, first_seed + start)]() mutable { return trial.run(ticks_per_step); };
    };
    return jobs.submit(static_cast<std::size_t>(exercise->starts), begin,
                       [exercise](std::vector<StartResult> starts) { return grade_of(*exercise, std::move(starts)); });
}

}  // namespace braitenlab
