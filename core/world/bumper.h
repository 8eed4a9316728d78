// Whether a bumper feels what its vehicle touches.
#pragma once

#include "core/world/eye.h"
#include "core/world/outline.h"

namespace braitenlab {

// Whether a part of the outline that lies in the bumper's field comes within touching distance of the chassis. Its
// range does not matter: a bumper ends at the chassis.
bool feels(const Eye& bumper, const Body&, const Motion&, const Outline&);

}  // namespace braitenlab
