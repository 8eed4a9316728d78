// The recogniser's word for the selected vehicle, worked out when something changes and not once a frame.
#pragma once

#include <memory>
#include <vector>

#include "core/world/character.h"

namespace braitenlab {

struct Recognised {
    std::shared_ptr<const BrainGraph> brain;
    VehicleId vehicle = no_vehicle;
    std::vector<Reading> readings;  // in twentieths: the word does not hang on less
    double at = 0;                  // wall seconds
    Character character = Character::still;
};

// Another brain or vehicle is looked at at once, other readings four times a second.
Character recognised(Recognised&, const Snapshot&, const VehicleView&, double wall_seconds);

}  // namespace braitenlab
