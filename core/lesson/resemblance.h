// How alike the behaviour of two graded submissions is, for feedback: whatever their brains are.
#pragma once

#include <optional>
#include <vector>

#include "core/lesson/grade.h"

namespace braitenlab {

// 0: the same behaviour from every start; 1: nothing in common. The mean over the starts of three differences: the
// share of steps that only one of the two has done (half of the weight), the distance between the paths, and the
// relative difference of the measured values (a quarter each). Both grades are of the same exercise and seeds.
float behaviour_distance(const Grade&, const Grade&);

// Behaviours below this distance are alike. Tuned on the course: the wrong answers of its exercises with their weights
// changed by 5 % are below it.
inline constexpr float alike = 0.2f;

// Index of the grade that is nearest to the first one and alike; nullopt if none is.
std::optional<std::size_t> most_alike(const Grade&, const std::vector<Grade>&);

}  // namespace braitenlab
