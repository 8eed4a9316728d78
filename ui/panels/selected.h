// What panels ask about the selected vehicle: its brain, its kind, and whom an edit of it is for.
#pragma once

#include <memory>

#include "core/world/command.h"
#include "ui/lab_view.h"

namespace braitenlab {

// Precondition of all: the vehicle is in the snapshot.
inline const std::shared_ptr<const BrainGraph>& brain_of(const Snapshot& now, const VehicleView& vehicle) {
    return now.brains[static_cast<std::size_t>(vehicle.brain)];
}

inline const Kind& kind_of(const Snapshot& now, const VehicleView& vehicle) {
    return now.scene->kinds[static_cast<std::size_t>(vehicle.kind)];
}

// Its kind as the file has it, before all edits; null when nobody knows.
inline const Kind* filed_kind(const LabView& view, const VehicleView& vehicle) {
    const auto kind = static_cast<std::size_t>(vehicle.kind);
    return view.file && kind < view.file->kinds.size() ? &view.file->kinds[kind] : nullptr;
}

inline Target target_of(const LabView& view, const VehicleView& vehicle) {
    return view.settings.selection.whole_kind ? Target{no_vehicle, vehicle.kind} : Target{vehicle.id, -1};
}

}  // namespace braitenlab
