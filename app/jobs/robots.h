// A trial of many robots as a background job.
#pragma once

#include <memory>

#include "app/jobs/jobs.h"
#include "core/insight/robustness.h"
#include "core/lesson/exercise.h"

namespace braitenlab {

// Runs the ideal robot and every robot of the trial, with one part per robot. With an exercise a robot works if it
// passes all steps; the exercise's scene is then that of the question, and only its steps and seconds are used. Null:
// none.
Job<insight::RobotsReport> submit_robots(Jobs&, const std::shared_ptr<const insight::Robots>&,
                                         const std::shared_ptr<const Exercise>&);

}  // namespace braitenlab
