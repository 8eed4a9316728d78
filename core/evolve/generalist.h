// The selection of Opponents::generalist, which keeps those that are better against all opponents instead of those that
// are better against some and worse against others. After L. Simione, S. Nolfi, "Long-term progress and behavior
// complexification in competitive coevolution" (2020), whose opponents differ in what they score, not in their genes.
#pragma once

#include <cstddef>
#include <vector>

#include "core/evolve/breeding.h"

namespace braitenlab::evolve {

// Indices of the scores, the best first; of equal ones the first in their order.
std::vector<std::size_t> ranks_of(const std::vector<float>& scores);

// The individuals that stay, the best first. The first `parents` individuals are those that stayed before. Each other
// one, the best first, takes the place of the worst that stays if it is better against an opponent and worse against
// none. `scores`: of each individual against each opponent; `means` of them.
std::vector<std::size_t> generalists(const std::vector<std::vector<float>>& scores, const std::vector<float>& means,
                                     std::size_t parents);

// The first genome, then each time the one whose nearest chosen one is farthest, by the sum of the squared differences
// as shares of the ranges of the genes. When all are chosen, from the first one on again.
std::vector<Genome> most_different(const std::vector<Genome>&, const Breed&, std::size_t count);

}  // namespace braitenlab::evolve
