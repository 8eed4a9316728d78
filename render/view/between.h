// The moment between two ticks, so that slow motion glides and a display of any rate shows an even motion.
#pragma once

#include <vector>

#include "core/world/snapshot.h"

namespace braitenlab::render {

// Moves every vehicle back towards where it stood a tick before: t = 1 leaves it where it is, 0 puts it where it was.
// Vehicles that were not there before (by ascending id, as in the snapshot), or that jumped farther than any vehicle
// drives in a tick, stay.
void stand_between(Snapshot& now, const std::vector<VehicleView>& before, float t);

}  // namespace braitenlab::render
