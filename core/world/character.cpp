#include "core/world/character.h"

#include <algorithm>

namespace braitenlab {

namespace {

bool is_paired(const Kind& kind, const std::string& name) {
    if (name.empty() || (name.back() != 'L' && name.back() != 'R')) return false;
    std::string other = name;
    other.back() = name.back() == 'L' ? 'R' : 'L';
    return std::any_of(kind.sensors.begin(), kind.sensors.end(), [&](const Sensor& s) { return s.name == other; });
}

}  // namespace

std::vector<Reading> readings_beside_eyes(const Snapshot& now, const VehicleView& vehicle) {
    const Kind& kind = now.scene->kinds[static_cast<std::size_t>(vehicle.kind)];
    std::vector<Reading> readings;
    for (std::size_t i = 0; i < kind.sensors.size(); ++i)
        if (const std::string& name = kind.sensors[i].name; !is_paired(kind, name))
            readings.push_back({name, now.sensed[static_cast<std::size_t>(vehicle.first_sensed) + i]});
    return readings;
}

Character character_of(const Snapshot& now, const VehicleView& vehicle) {
    return recognise(*now.brains[static_cast<std::size_t>(vehicle.brain)], {}, readings_beside_eyes(now, vehicle));
}

}  // namespace braitenlab
