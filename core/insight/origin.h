// What a sensor reads: the source, or the vehicle, that adds most to its reading.
#pragma once

#include <optional>

#include "core/world/snapshot.h"

namespace braitenlab::insight {

struct Origin {
    int source = -1;                 // in Scene::sources; −1: a vehicle or a lamp that it carries
    VehicleId vehicle = no_vehicle;  // no_vehicle: a source
    friend bool operator==(const Origin&, const Origin&) = default;
};

// The origin of more than half of what the sensor would read at the vehicle's present pose, without noise and delay.
// Obstacles hide stimuli as they do for the sensor. Nullopt: none adds more than half, or the channel is not a sum of
// stimuli of sources and vehicles (obstacles, place memory, floor, touch, energy).
// Precondition: the vehicle is in the snapshot.
std::optional<Origin> main_origin(const Snapshot&, const VehicleView&, const Sensor&);

}  // namespace braitenlab::insight
