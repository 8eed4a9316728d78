// Runs of the open exercise that are computed in the background: the one with the solution, which is shown beside the
// student's, and the one with the shipped brain, which a drawn prediction is compared with.
#pragma once

#include "app/workspace.h"

namespace braitenlab {

// Call once per turn, after Jobs::deliver. Asks for the runs that the lesson needs and writes the real path and its
// distance to the drawn one to the attempt. Without an open exercise does nothing.
void update_reference_runs(Workspace&, Jobs&);

// The vehicle of the run with the solution at the displayed time. nullopt while it is not compared or not known, once
// it has left the scene, and while the student's run does not count, because its start or scene was changed by hand.
std::optional<GhostView> ghost_of(const Workspace&);

}  // namespace braitenlab
