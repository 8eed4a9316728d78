// A moment as JSON, and whether one that was read makes sense. Inside core/world only.
#pragma once

#include <optional>

#include "core/result.h"
#include "core/world/json.h"
#include "core/world/moment.h"

namespace braitenlab {

Json moment_json(const Moment&);

// Throws Json::exception for what is missing or of the wrong type; fails for what could not be.
Result<Moment> read_moment(const Json&);

}  // namespace braitenlab
