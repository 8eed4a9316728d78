// The driven wheels of a body as two lengths, and their change.
#pragma once

#include "core/scene/scene.h"

namespace braitenlab {

// Of the wheels with a motor: the distance (m) between the leftmost and the rightmost, and the largest radius (m). Both
// are 0 for a body without such wheels.
struct DrivenWheels {
    float track = 0, radius = 0;
};
DrivenWheels driven_wheels(const Body&);

// The body whose driven wheels have this track and radius: each is moved across and scaled in proportion, within the
// ranges of a wheel. A length that is 0 in the body stays 0.
Body with_driven_wheels(const Body&, DrivenWheels wanted);

}  // namespace braitenlab
