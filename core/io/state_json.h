// A state as JSON, and the validation of a state that was read. Inside core/io only.
#pragma once

#include <optional>

#include "core/io/json.h"
#include "core/result.h"
#include "core/world/state.h"

namespace braitenlab::io {

Json state_json(const world::State&);

// Throws Json::exception for missing values and wrong types; fails when check_state() does.
Result<world::State> read_state(const Json&);

// Returns what is wrong with a state that came from outside, or nothing if a run can be in it. Preconditions: its scene
// passes check_scene, and every vehicle has a kind of the scene, a brain and its ranges of sensed, neurons and delayed.
std::optional<Error> check_state(const world::State&);

}  // namespace braitenlab::io
