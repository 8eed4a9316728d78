// Interpolates between two ticks, for smooth slow motion and for displays of any refresh rate.
#pragma once

#include <vector>

#include "core/world/snapshot.h"

namespace braitenlab::render {

// Moves every vehicle of `now` to its pose between `before` (t = 0), one tick earlier, and `now` (t = 1). Both are
// sorted by id. Vehicles that are not in `before`, or that moved farther than 1 m, keep their pose.
void stand_between(Snapshot& now, const std::vector<VehicleView>& before, float t);

}  // namespace braitenlab::render
