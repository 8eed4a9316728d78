// Conversion of a state to and from JSON, and validation of the result. Inside core/io only.
#pragma once

#include <optional>

#include "core/io/json.h"
#include "core/result.h"
#include "core/world/state.h"

namespace braitenlab::io {

Json state_json(const world::State&);

// Throws Json::exception for missing values and wrong types. Returns the error of check_scene() or check_state().
Result<world::State> read_state(const Json&);

// Returns an error for a state that no run can have, else nullopt. Preconditions: the scene passes check_scene(), and
// every vehicle has a kind of the scene, a brain and its ranges of sensed, neurons and delayed.
std::optional<Error> check_state(const world::State&);

}  // namespace braitenlab::io
