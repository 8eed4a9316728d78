// A run at one moment, complete: a world restored from it goes on as the saved one does, bit for bit.
//
// Box2D keeps caches that cannot be restored. So a running world makes itself anew from its own moment every
// keyframe_ticks; a save is the last such keyframe and what was done since, and restoring does it again.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/world/command.h"

namespace braitenlab {

struct Moment;  // core/world/moment.h: inside core/world only

inline constexpr std::uint64_t keyframe_ticks = 300;

// So many commands since a keyframe make another one, in between two ticks: somebody who drags things about while the
// run is paused gives one with every frame. While it plays, one hand never comes that far. Those that move nodes on the
// canvas do not count.
inline constexpr std::size_t keyframe_commands = 512;

// A command, and the tick before which it was carried out.
struct LoggedCommand {
    std::uint64_t tick = 0;
    Command command;
};

struct Save {
    std::shared_ptr<const Moment> keyframe;
    std::uint64_t keyframe_tick = 0;
    std::vector<LoggedCommand> commands;  // since the keyframe, in order; fewer than keyframe_commands that count
    std::uint64_t tick = 0;               // the saved moment; at most keyframe_ticks after the keyframe
};

// A run that can be put away and gone on with: how it began, and where it stands.
struct SavedRun {
    Scene opened;
    Save save;
};

}  // namespace braitenlab
