// What a vehicle's brain does to what its eyes see, as things stand with it at this moment.
#pragma once

#include <vector>

#include "core/brain/recogniser.h"
#include "core/world/snapshot.h"

namespace braitenlab {

// What the sensors beside its eyes read now: its energy, its bumper, a photocell that looks all round. Eyes that come
// in pairs (names ending in L and R) are left out: they look at other stimuli, each with a character of its own, and
// one that is met on one side would make every brain seem crooked. Precondition: the vehicle is in the snapshot.
std::vector<Reading> readings_beside_eyes(const Snapshot&, const VehicleView&);

// The recogniser's word for the vehicle's brain with those readings: a fed tortoise is another than a hungry one.
Character character_of(const Snapshot&, const VehicleView&);

}  // namespace braitenlab
