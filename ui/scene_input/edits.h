// Commands behind the gestures on objects of the scene, and the search for a free position.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/maths/vec.h"
#include "core/world/command.h"
#include "core/world/snapshot.h"
#include "render/view/pick.h"

namespace braitenlab::ui {

// The channels a source can have, in the order of menus.
inline constexpr auto& source_channels = channels_with<&ChannelTraits::is_source>;

// Body colours on offer, apart for colour-blind eyes (M. Okabe and K. Ito, 2008), and grey.
inline constexpr std::string_view body_colours[]{"#e69f00", "#56b4e9", "#009e73", "#f0e442",
                                                 "#0072b2", "#d55e00", "#cc79a7", "#8595aa"};

// All return nullopt when the object no longer exists.
std::optional<Command> removal_of(const Snapshot&, const SceneObject&);

// The removal of each of the objects, in an order in which no removal changes the index of a later one.
std::vector<Command> removals_of(const Snapshot&, std::vector<SceneObject>);

// Adds a copy about 0.8 m beside the object, at a free position. A copied vehicle has the same brain
// and a body colour that no other vehicle of the scene has, while there is one.
std::optional<Command> copy_of(const Snapshot&, const SceneObject&);

// Moves the object to this pose, clamped to the arena. A source ignores the heading.
std::optional<Command> move_of(const Snapshot&, const SceneObject&, Pose to);

// For a MoveVehicle before the first tick: the edit that makes the new pose the vehicle's start, as part of the same
// gesture: EditStart, or EditMember for a vehicle of the population. nullopt after the first tick and for other
// commands.
std::optional<Command> start_of(const Snapshot&, const Command& move);

// The object added by a command, in a snapshot captured after it. SceneObject{} for other commands, and for a vehicle
// added without a position.
SceneObject added_by(const Snapshot&, const Command&);

// The position nearest to `wanted`, within the arena, where a disc of radius `reach` (m) overlaps no object. If the
// arena is full: `wanted`, clamped to the arena.
maths::vec2 free_place(const Snapshot&, maths::vec2 wanted, float reach);

// For a command that adds an object: the command with the nearest free position. An obstacle is treated as the largest
// disc within it; a zone needs no free position. Other commands are returned unchanged.
Command with_room(const Snapshot&, Command);

}  // namespace braitenlab::ui
