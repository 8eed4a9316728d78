// Simulated time: ticks, and going back in time.
#pragma once

#include <functional>

#include "app/lab.h"

namespace braitenlab {

// Runs one tick in any mode.
void tick(Lab&);

// Advances by wall time: runs the ticks that are due while playing and no sheet is open. No tick begins after 12 ms;
// those that are due then are dropped, so that a slow computer runs in slow motion and the debt does not grow. A tick
// that has begun is finished: what one may cost is limited by size_fault() (core/scene/size_limits.h). Where vehicles
// gather during a run it can cost more: after half a second of processor time in ticks of more than 0.1 s each, one
// after the other, the run pauses with a notice, and goes on when the person wants it. On the way to a recorded tick
// the run goes on there first. `seen` gets the shown snapshot after each tick.
void advance(Lab&, double wall_seconds, const std::function<void(const Snapshot&)>& seen = {});

}  // namespace braitenlab
