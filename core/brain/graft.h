// Replaces a brain by a preset and keeps the sensors that the preset does not have.
#pragma once

#include <string>
#include <vector>

#include "core/brain/graph.h"

namespace braitenlab {

// The preset, plus these parts of the brain: sensors that the preset does not have, the neurons that only such sensors
// feed, and the wires from both. All other neurons and wires and the motors' parameters are removed. Equal to the
// preset when nothing is kept. Kept nodes get ids above the preset's, and a new name if the preset uses
// theirs. Nodes keep their positions, but if the preset has neurons, no node of the result has a position.
BrainGraph graft(const BrainGraph& brain, const BrainGraph& preset);

// Names of the wired sensors that graft() keeps, in the brain's order.
std::vector<std::string> kept_by_graft(const BrainGraph& brain, const BrainGraph& preset);

}  // namespace braitenlab
