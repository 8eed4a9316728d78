#include "ui/panels/recognised.h"

#include <cmath>

namespace braitenlab {

namespace {

constexpr double look_again = 0.25;  // wall seconds

std::vector<Reading> in_twentieths(std::vector<Reading> readings) {
    for (Reading& reading : readings) reading.value = std::round(reading.value * 20) / 20;
    return readings;
}

}  // namespace

Character recognised(Recognised& known, const Snapshot& now, const VehicleView& vehicle, double wall_seconds) {
    const auto& brain = now.brains[static_cast<std::size_t>(vehicle.brain)];
    const bool same = known.brain == brain && known.vehicle == vehicle.id;
    if (same && std::fabs(wall_seconds - known.at) < look_again) return known.character;
    auto readings = in_twentieths(readings_beside_eyes(now, vehicle));
    known.at = wall_seconds;
    if (same && readings == known.readings) return known.character;
    known.character = recognise(*brain, {}, readings);
    known.brain = brain;
    known.vehicle = vehicle.id;
    known.readings = std::move(readings);
    return known.character;
}

}  // namespace braitenlab
