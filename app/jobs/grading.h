// Grading as a background job.
#pragma once

#include <memory>

#include "app/jobs/jobs.h"
#include "core/lesson/grade.h"

namespace braitenlab {

// Grades the submission as grade() does, with one part per start.
Job<Grade> submit_grading(Jobs&, const std::shared_ptr<const Exercise>&, const Submission&,
                          std::uint64_t first_seed = 1);

}  // namespace braitenlab
