#include "core/scene/driven_wheels.h"

#include <algorithm>
#include <limits>

namespace braitenlab {

DrivenWheels driven_wheels(const Body& body) {
    DrivenWheels driven;
    float left = std::numeric_limits<float>::lowest(), right = std::numeric_limits<float>::max();
    for (const Wheel& wheel : body.wheels) {
        if (wheel.motor == Motor::none) continue;
        left = std::max(left, wheel.y), right = std::min(right, wheel.y);
        driven.radius = std::max(driven.radius, wheel.radius);
    }
    driven.track = std::max(0.0f, left - right);
    return driven;
}

Body with_driven_wheels(const Body& body, DrivenWheels wanted) {
    const DrivenWheels now = driven_wheels(body);
    Body to = body;
    for (Wheel& wheel : to.wheels) {
        if (wheel.motor == Motor::none) continue;
        if (now.track > 0) wheel.y = std::clamp(wheel.y * (wanted.track / now.track), -10.0f, 10.0f);
        if (now.radius > 0) wheel.radius = std::clamp(wheel.radius * (wanted.radius / now.radius), 0.005f, 5.0f);
    }
    return to;
}

}  // namespace braitenlab
