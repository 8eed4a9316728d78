#include "app/jobs/grading.h"

namespace braitenlab {

Job<Grade> submit_grading(Jobs& jobs, const std::shared_ptr<const Exercise>& exercise, const Submission& submission) {
    constexpr int ticks_per_step = 60;  // about a millisecond
    const auto begin = [exercise, submission](std::size_t start) {
        return [trial = Trial(*exercise, submission, start + 1)]() mutable { return trial.run(ticks_per_step); };
    };
    return jobs.submit(static_cast<std::size_t>(exercise->starts), begin,
                       [exercise](std::vector<bool> passed) { return grade_of(*exercise, std::move(passed)); });
}

}  // namespace braitenlab
