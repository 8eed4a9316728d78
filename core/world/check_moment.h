// Whether a moment that came from outside is one that a run can be in. Inside core/world only.
#pragma once

#include <optional>

#include "core/result.h"
#include "core/world/moment.h"

namespace braitenlab {

// Preconditions: its scene passes check_scene, and every vehicle has a kind of it, a design, and its stretch of sensed
// and neurons. What is wrong, or nothing.
std::optional<Error> check_moment(Moment&);

}  // namespace braitenlab
