// Putting a brain for two eyes into a vehicle that has further senses.
#pragma once

#include <string>
#include <vector>

#include "core/brain/graph.h"

namespace braitenlab {

// The preset in place of what was wired to the sensors it knows, together with what it has no say in: sensors that it
// does not know, their wires to the motors, and the neurons that such sensors alone feed. What it replaces are the
// eyes' wires, the neurons they feed, and the motors' own numbers. Where nothing is to be kept the result is the
// preset. Nodes that are kept get ids after the preset's, and another name where theirs is taken. Eyes and motors stand
// where they stood; a preset with neurons of its own puts nobody anywhere.
BrainGraph graft(const BrainGraph& brain, const BrainGraph& preset);

// Names of the sensors whose wires graft() keeps, in the brain's order; a sensor without wires is none.
std::vector<std::string> kept_by_graft(const BrainGraph& brain, const BrainGraph& preset);

}  // namespace braitenlab
