// Grading as a background job.
#pragma once

#include <memory>
#include <vector>

#include "app/jobs/jobs.h"
#include "core/brain/four_neurons.h"
#include "core/lesson/grade.h"

namespace braitenlab {

// Grades the submission as grade() does, with one part per start.
Job<Grade> submit_grading(Jobs&, const std::shared_ptr<const Exercise>&, const Submission&,
                          std::uint64_t first_seed = 1);

// gains_of() the offered controls from the start that Play shows, with one part per value tried.
Job<std::vector<float>> submit_gains(Jobs&, const std::shared_ptr<const Exercise>&, const Submission&,
                                     const SensorPair&);

}  // namespace braitenlab
