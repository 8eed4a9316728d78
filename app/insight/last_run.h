// The paths of the present run, kept at a reset: the last run is shown beside the new one.
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "core/lesson/goal.h"
#include "core/world/snapshot.h"

namespace braitenlab {

struct Lab;
struct GhostView;

// One pose per tick from tick 0 on, by vehicle.
struct RunPaths {
    std::uint64_t run = 0;  // Document::run_id
    std::map<VehicleId, ReferencePath> paths{};
};

struct LastRun {
    RunPaths present, last;
};

// Call before each tick. Records the first 16 vehicles for at most ten minutes, if the run is known from its start on.
void record_paths(Lab&);

// Call at a reset, after record_paths(): the present run becomes the last one unless it is shorter than half a second.
// new_ids: of the vehicles in the new run.
void keep_run(Lab&, const std::map<VehicleId, VehicleId>& new_ids);

// The selected vehicle in the last run, at the displayed time. nullopt: not known, or it is not to be shown.
std::optional<GhostView> last_run_of(const Lab&);

}  // namespace braitenlab
