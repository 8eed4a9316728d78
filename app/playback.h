// Simulated time: ticks, and going back in time.
#pragma once

#include <cstdint>
#include <functional>

#include "app/lab.h"

namespace braitenlab {

// Runs one tick in any mode.
void tick(Lab&);

// Advances by wall time: runs the ticks that are due while playing and no sheet is open, for at most 12 ms. Ticks that
// exceed this time are dropped, so that a slow computer runs in slow motion and the debt does not grow. `seen` gets the
// shown snapshot after each tick.
void advance(Lab&, double wall_seconds, const std::function<void(const Snapshot&)>& seen = {});

}  // namespace braitenlab
