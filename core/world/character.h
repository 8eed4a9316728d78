// Character of a vehicle: how its brain responds to the stimuli of its eyes, given its other readings at this tick.
#pragma once

#include <vector>

#include "core/brain/recogniser.h"
#include "core/world/snapshot.h"

namespace braitenlab {

// Current readings of the sensors that are not eyes: energy, bumper, omnidirectional photocell. Paired eyes (names that
// end in L and R) are omitted: a stimulus on one side would make the response of every brain asymmetric.
// Precondition: the vehicle is in the snapshot.
std::vector<Reading> readings_beside_eyes(const Snapshot&, const VehicleView&);

// The recogniser's result for the vehicle's brain with those readings. It can change with them, e.g. with the energy.
Character character_of(const Snapshot&, const VehicleView&);

}  // namespace braitenlab
