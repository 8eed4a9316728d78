// Where nodes stand on the wiring canvas. Moving one touches nothing that thinks or drives: what happens in the run
// stays the same, bit for bit, and so does what was recorded of it. Inside core/world and core/session only.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/result.h"
#include "core/world/save.h"

namespace braitenlab {

// Whether a command changes what is seen and nothing that happens.
bool changes_looks_alone(const Command&);

// Every node's place in this brain.
std::vector<NodePlace> places_of(const BrainGraph&);

// The same moment with nodes elsewhere.
std::shared_ptr<const Moment> with_places(const Moment&, const PlaceNodes&);

// A command that was given after nodes were moved, to the same vehicles, made to leave them where they are.
Command keeping_places(Command later, const PlaceNodes& moved);

// Carries the command out. Refuses a place beyond the canvas, a vehicle or a kind that is not there.
std::optional<Error> place_nodes(Moment&, const PlaceNodes&);

}  // namespace braitenlab
