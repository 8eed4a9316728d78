// The kinds of the random population, chosen by the shares.
#pragma once

#include <vector>

#include "core/scene/scene.h"

namespace braitenlab {

// The kind that a further vehicle gets where each kind has this many: the one farthest below its share; of equal kinds,
// the first in the scene.
int most_wanted(const Scene&, const std::vector<int>& counts);

// The kind of each vehicle of the population as a run begins, by its number.
std::vector<int> population_kinds(const Scene&);

// The number of vehicles of each kind as a run begins, in the order of Scene::kinds.
struct StartNumbers {
    std::vector<int> with_start, in_population;
};
StartNumbers start_numbers(const Scene&);

// Replaces the population and the shares such that a run begins with these numbers.
void set_population(Scene&, const std::vector<int>& in_population);

}  // namespace braitenlab
