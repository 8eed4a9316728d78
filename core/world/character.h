// Character of a vehicle: how its brain responds to stimuli of each pair of its sensors, given its other readings at
// this tick.
#pragma once

#include <vector>

#include "core/brain/recogniser.h"
#include "core/scene/sensor_pairs.h"
#include "core/world/snapshot.h"

namespace braitenlab {

// Current readings of the sensors without a pair: energy, bumper, omnidirectional photocell. Pairs are omitted: a
// stimulus on one side would make the response of every brain asymmetric. Precondition: the vehicle is in the snapshot.
std::vector<Reading> readings_beside_pairs(const Snapshot&, const VehicleView&);

// Which of the pairs a brain reads, and its response to each.
struct PairCharacter {
    KindPair pair;
    bool is_wired = false;  // a wire leads from one of its sensors
    Character character = Character::still;
};

// One entry for each pair of the vehicle's kind, in their order. Can change with `meanwhile`, e.g. with the energy.
std::vector<PairCharacter> characters_of(const BrainGraph&, const Kind&, std::span<const Reading> meanwhile = {});

// The result for the first wired pair; Character::indifferent or still for a brain that reads no pair.
Character character_of(const Snapshot&, const VehicleView&);

// Sensors that the brain reads and the kind does not have, in the order of the brain's nodes.
std::vector<std::string> missing_sensors(const BrainGraph&, const Kind&);

}  // namespace braitenlab
