// The commands behind what a hand does to a thing of the scene, whatever kind of thing it is.
#pragma once

#include <array>
#include <optional>

#include "core/world/command.h"
#include "render/view/pick.h"

namespace braitenlab {

// What a source can be, in the order of menus: what exists in the world by itself.
inline constexpr std::array<Channel, 7> source_channels{Channel::light, Channel::red,   Channel::green, Channel::blue,
                                                        Channel::heat,  Channel::smell, Channel::oxygen};

// Nothing where the thing is gone.
std::optional<Command> removal_of(const Snapshot&, const SceneObject&);

// One like it, about 0.8 m beside it, where there is room in the arena; a vehicle's copy has its very brain.
std::optional<Command> copy_of(const Snapshot&, const SceneObject&);

// The thing stands there instead, within the arena; a source takes no heading.
std::optional<Command> move_of(const Snapshot&, const SceneObject&, Pose to);

// Before a run's first tick, who is moved starts there from now on: its new start, exactly where and how it stands, to
// be part of the same gesture. Nothing later, nor for one that starts at random, nor for other commands.
std::optional<Command> start_of(const Snapshot&, const Command& move);

// What is added by a command, once it has been carried out and captured: the newest of its sort. SceneObject{} for
// other commands, and for vehicles that come in anywhere.
SceneObject added_by(const Snapshot&, const Command&);

}  // namespace braitenlab
