// The selection: a vehicle, and optionally a source, an obstacle or a zone in addition. Manual driving of the selected
// vehicle.
#pragma once

#include <map>
#include <vector>

#include "app/lab.h"

namespace braitenlab {

const VehicleView* selected_vehicle(const Lab&);  // null when there is none

void select(Lab&, const SceneObject&);
// Selects nothing; keep_selection() then selects no vehicle by itself.
void select_none(Lab&);
// Selects a source, an obstacle or a zone, or none; the selected vehicle stays selected.
void select_object(Lab&, const SceneObject&);
// Selects these objects and no others (see SelectObjectsRequest).
void select_objects(Lab&, const std::vector<SceneObject>&);
// Selects the vehicle `step` places further in the order of ids.
void select_neighbour(Lab&, int step);

// Selects the lamp, obstacle or zone `step` places further in the order of the scene; the vehicle stays selected.
void select_next_object(Lab&, int step);

// Makes the selection valid again: selects the first vehicle in place of one that no longer exists, unless
// Lab::deselected. Call after anything that may have added or removed vehicles, sources, obstacles or zones.
void keep_selection(Lab&);

// If the selected vehicle has died in this tick, selects the nearest one of its kind and shows a notice. Selects none
// if there is none of its kind, or during a drag, which then ends. `selected` is the vehicle one tick ago.
void reselect_after_death(Lab&, const VehicleView& selected);

// Says so if the vehicle, the selected one, has fallen over an open edge in this tick and starts again.
void tell_fall(Lab&, VehicleId);

// Removes the notice of reselect_after_death() and of tell_fall(): another vehicle is selected, or the run is at
// another tick.
void forget_vehicle_notice(Lab&);

// The vehicle with the same start or the same number in the population as this one of `now`, in a world that begins
// with the scene. no_vehicle: there is none.
VehicleId id_at_start(const Scene&, std::uint64_t seed, const Snapshot& now, const VehicleView&);

// Switches the selected vehicle between manual driving and the driver of its kind.
void drive(Lab&);

// Drives the selected vehicle by arrow keys; `right` and `ahead` are −1, 0 or 1. Returns false if the vehicle is not
// driven manually: then the arrow keys move the camera.
bool steer_by_keys(Lab&, float right, float ahead);

// The selection in a run whose vehicles have other ids. new_ids: by the old ones.
void renumber_selection(Selection&, const std::map<VehicleId, VehicleId>& new_ids);

}  // namespace braitenlab
