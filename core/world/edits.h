// Commands that change the scene as well as the world: who is in it (roster.cpp), what stands in it and what the kinds'
// sensors are (edits.cpp).
#pragma once

#include <optional>

#include "core/world/state.h"

namespace braitenlab {

// Each refuses what would make the scene unsound (see check_scene) and leaves everything as it was. A name that is
// empty or taken is replaced by a free one.
std::optional<Error> carry_out(WorldState&, const AddVehicle&);
std::optional<Error> carry_out(WorldState&, const RemoveVehicle&);
std::optional<Error> carry_out(WorldState&, const EditStart&);
std::optional<Error> carry_out(WorldState&, const SetSensors&);
std::optional<Error> carry_out(WorldState&, const AddSource&);
std::optional<Error> carry_out(WorldState&, const RemoveSource&);
std::optional<Error> carry_out(WorldState&, const EditSource&);
std::optional<Error> carry_out(WorldState&, const MoveSource&);
std::optional<Error> carry_out(WorldState&, const AddObstacle&);
std::optional<Error> carry_out(WorldState&, const RemoveObstacle&);
std::optional<Error> carry_out(WorldState&, const EditObstacle&);
std::optional<Error> carry_out(WorldState&, const MoveObstacle&);
std::optional<Error> carry_out(WorldState&, const Retitle&);

}  // namespace braitenlab
