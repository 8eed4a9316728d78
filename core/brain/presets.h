// The canonical vehicles of V. Braitenberg, "Vehicles: Experiments in Synthetic Psychology" (MIT Press, 1984), and
// W. Grey Walter's tortoise ("An Imitation of Life", Scientific American 182, 1950), as brains.
//
// Every preset has the nodes SL, SR, ML, MR of the sliders. Sensors come in pairs whose names end in L and R: S the
// main stimulus, H heat, N smell, A oxygen (air), Q remembered obstacles. TC is a bumper, EN the vehicle's energy, UP
// an omnidirectional photocell. A sensor that the vehicle does not have reads 0.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/brain/graph.h"

namespace braitenlab {

struct Preset {
    std::string_view name;   // "2a-coward": also the key of its title and story in the string files
    std::string_view scene;  // file stem of the shipped scene with this brain
    BrainGraph brain;        // valid; the scene's vehicle can have more sensors
};

// In the order of the book, then the tortoise, then predator and prey.
std::span<const Preset> presets();

// The preset of this name, or null.
const Preset* find_preset(std::string_view name);

// The preset, plus these parts of the brain: sensors that the preset does not have, the neurons that only such sensors
// feed, and the wires from both. All other neurons and wires and the motors' parameters are removed. Equal to the
// preset when nothing is kept. Kept nodes get ids above the preset's, and a new name if the preset uses
// theirs. Nodes keep their positions, but if the preset has neurons, no node of the result has a position.
BrainGraph graft(const BrainGraph& brain, const BrainGraph& preset);

// Names of the wired sensors that graft() keeps, in the brain's order.
std::vector<std::string> kept_by_graft(const BrainGraph& brain, const BrainGraph& preset);

}  // namespace braitenlab
