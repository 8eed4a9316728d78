// From a stick or four arrow keys to two wheels.
#pragma once

#include <algorithm>

#include "core/world/command.h"

namespace braitenlab {

// `right` and `ahead` are −1..1, as a stick is pushed. Full ahead with full right still drives on: it curves.
inline Steer steer(VehicleId vehicle, float right, float ahead) {
    constexpr float turning = 0.5f;  // of a wheel's speed, at full right or left
    return {vehicle, std::clamp(ahead + turning * right, -1.0f, 1.0f),
            std::clamp(ahead - turning * right, -1.0f, 1.0f)};
}

}  // namespace braitenlab
