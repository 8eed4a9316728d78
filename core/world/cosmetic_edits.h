// Edits that change what people see and nothing that happens in the run: the positions of nodes on the wiring canvas.
// The run and its recording stay the same, bit for bit. Inside core/world and core/session only.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/result.h"
#include "core/world/world.h"

namespace braitenlab::world {

// True when the command is such an edit.
bool is_cosmetic(const Command&);

// The canvas position of every node of the brain.
std::vector<NodePlace> places_of(const BrainGraph&);

// A copy of the state with the nodes moved.
std::shared_ptr<const State> with_places(const State&, const PlaceNodes&);

// A command recorded after the nodes were moved, changed so that it does not move them back.
Command keeping_places(Command later, const PlaceNodes& moved);

// Moves the nodes. Refuses a position outside the canvas, an unknown vehicle or kind.
std::optional<Error> place_nodes(State&, const PlaceNodes&);

}  // namespace braitenlab::world
