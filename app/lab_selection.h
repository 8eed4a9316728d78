// The selection: a vehicle, and optionally a source, an obstacle or a zone in addition.
#pragma once

#include <map>
#include <vector>

#include "app/workspace.h"

namespace braitenlab {

const VehicleView* selected_vehicle(const Workspace&);  // null when there is none

void select(Workspace&, const SceneObject&);
// Selects nothing; keep_selection() then selects no vehicle by itself.
void select_none(Workspace&);
// Selects a source, an obstacle or a zone, or none; the selected vehicle stays selected.
void select_object(Workspace&, const SceneObject&);
// Selects these objects and no others (see SelectObjectsRequest).
void select_objects(Workspace&, const std::vector<SceneObject>&);
// Selects the vehicle `step` places further in the order of ids.
void select_neighbour(Workspace&, int step);

// Selects the lamp, obstacle or zone `step` places further in the order of the scene; the vehicle stays selected.
void select_next_object(Workspace&, int step);

// Makes the selection valid again: in place of a vehicle that no longer exists selects the first one of its kind, else
// the first one, unless Workspace::deselected. Call after anything that may have added or removed vehicles, sources,
// obstacles or zones.
void keep_selection(Workspace&);

// If the selected vehicle has died in this tick, selects the nearest one of its kind and shows a notice. Selects none
// if there is none of its kind, or during a drag, which then ends. `selected` is the vehicle one tick ago.
void reselect_after_death(Workspace&, const VehicleView& selected);

// Says so if the vehicle, the selected one, has fallen over an open edge in this tick and starts again.
void tell_fall(Workspace&, VehicleId);

// Removes the notice of reselect_after_death() and of tell_fall(): another vehicle is selected, or the run is at
// another tick.
void forget_vehicle_notice(Workspace&);

// The vehicle with the same start or the same number in the population as this one of `now`, in a world that begins
// with the scene. no_vehicle: there is none.
VehicleId id_at_start(const Scene&, std::uint64_t seed, const Snapshot& now, const VehicleView&);

// The selection in a run whose vehicles have other ids. new_ids: by the old ones.
void renumber_selection(Selection&, const std::map<VehicleId, VehicleId>& new_ids);

}  // namespace braitenlab
