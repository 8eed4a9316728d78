// Room for one more in the scene, as near as can be to where a person wants it.
#pragma once

#include "core/maths/vec.h"
#include "core/world/command.h"
#include "core/world/snapshot.h"

namespace braitenlab {

// The nearest place within the arena where something round of this reach (m) touches neither wall nor anything else. In
// an arena that is full, the wanted place, moved inside.
maths::vec2 free_place(const Snapshot&, maths::vec2 wanted, float reach);

// What the command adds stands at the nearest free place to the one it names; an obstacle takes the room of the circle
// within it. Every other command stays as it is.
Command with_room(const Snapshot&, Command);

}  // namespace braitenlab
