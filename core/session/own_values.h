// Values of single vehicles in place of those of their kind: brain, sensors, driver and look.
#pragma once

#include <vector>

#include "core/scene/scene.h"
#include "core/world/snapshot.h"

namespace braitenlab {

// The numbers that the vehicles without a start have in the population of the scene, in their order; from
// Ecology::population on: such a vehicle is not in the scene. Where the world has more vehicles than the population,
// one with values of its own takes the number of one without.
std::vector<int> numbers_in_population(const Snapshot&);

// Writes the brains, sensors, drivers and looks of single vehicles to the scene's starts and members. A successor of a
// starved vehicle with a start has no place in the population, so its values are not written.
void add_own_values(Scene&, const Snapshot&);

}  // namespace braitenlab
