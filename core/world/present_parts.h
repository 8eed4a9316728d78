// The brains and sensors of a running world, for the limits of its scene. Inside core/world and core/io only.
#pragma once

#include "core/scene/size_limits.h"
#include "core/world/state.h"

namespace braitenlab::world {

// Null for the brain of the kind, also if the vehicle has it compiled for sensors of its own.
inline const BrainGraph* own_graph(const SharedBrain& brain, const SharedBrain& of_kind) {
    return brain == of_kind || brain->graph == of_kind->graph ? nullptr : &brain->graph;
}

// of_vehicles: by row. Points into the state.
inline PresentParts present_parts(const State& s) {
    PresentParts parts;
    for (const SharedBrain& brain : s.kind_brains) parts.of_kinds.push_back(&brain->graph);
    const Vehicles& v = s.vehicles;
    for (std::size_t row = 0; row < v.size(); ++row)
        parts.of_vehicles.push_back({own_graph(v.brain[row], s.kind_brains[static_cast<std::size_t>(v.kind[row])]),
                                     v.design[row] ? &v.design[row]->kind.sensors : nullptr});
    return parts;
}

}  // namespace braitenlab::world
