// Which offered control brings a submission nearer to passing: other values of each are tried in runs of their own.
#pragma once

#include <cstddef>
#include <vector>

#include "core/brain/four_neurons.h"
#include "core/lesson/exercise.h"
#include "core/lesson/grade.h"

namespace braitenlab {

// What a run lacks of passing: 0.01..1 for each step that is not done, so 0 if it has passed.
float lacking(const StartResult&);

inline constexpr std::size_t values_tried = 13;  // of each control, evenly over its range

// The submission, then for each of offered_dials() the submission with each value tried. `pair`: whose wires the dials
// are.
std::vector<Submission> tries_of(const Exercise&, const Submission&, const SensorPair& pair);

// For each of offered_dials() the share of what the submission lacks that the best value tried gains, 0..1; 0 for all
// where it passes. `runs`: of tries_of(), from one start.
std::vector<float> gains_of(const std::vector<StartResult>& runs);

}  // namespace braitenlab
