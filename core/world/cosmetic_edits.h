// Cosmetic edits: positions of nodes on the wiring canvas, and the scene's title and story. They change the display
// only; the run and its recording stay the same, bit for bit. Inside core/world and core/session only.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/result.h"
#include "core/world/command.h"

namespace braitenlab::world {

struct State;

// True for a cosmetic edit.
bool is_cosmetic(const Command&);

// Executes the edit. PlaceNodes: refuses a position outside the canvas, an unknown vehicle or kind. Retitle: refuses a
// title or story that check_scene refuses.
std::optional<Error> execute_cosmetic(State&, const PlaceNodes&);
std::optional<Error> execute_cosmetic(State&, const Retitle&);

// A copy of a later recorded state with the edit executed; the same state if it refuses the edit.
std::shared_ptr<const State> with_cosmetic(const std::shared_ptr<const State>&, const Command& edit);

// A later recorded command, changed so that it does not take the edit back.
Command keeping_cosmetic(Command later, const Command& edit);

// The canvas position of every node of the brain.
std::vector<NodePlace> places_of(const BrainGraph&);

}  // namespace braitenlab::world
