#include <algorithm>
#include <cmath>
#include <limits>

#include "render/view/camera.h"

namespace braitenlab {

VehicleId pick(const Snapshot& now, const Sight& sight, maths::vec2 pixel) {
    constexpr float generous = 5;    // px beyond the body, and at least the size of a fingertip's tremble
    constexpr float middle = 0.15f;  // m, half a vehicle's height
    VehicleId found = no_vehicle;
    float best = std::numeric_limits<float>::max();
    for (const VehicleView& vehicle : now.vehicles) {
        const auto centre = project(sight, {vehicle.x, vehicle.y}, middle);
        if (!centre) continue;
        const auto kind = static_cast<std::size_t>(vehicle.kind);
        const bool known = now.scene && kind < now.scene->kinds.size();
        const float radius =
            known ? std::max(now.scene->kinds[kind].body.length, now.scene->kinds[kind].body.width) / 2 : 0.5f;
        const float reach = radius * pixels_per_metre(sight, {vehicle.x, vehicle.y}, middle) + generous;
        const float away = maths::distance(*centre, pixel);
        if (away <= reach && away < best) best = away, found = vehicle.id;
    }
    return found;
}

}  // namespace braitenlab
