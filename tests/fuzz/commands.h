// Random commands on a session, and what holds after each of them.
#pragma once

#include <string_view>

#include "core/session/session.h"

namespace braitenlab::fuzz {

// Plays the bytes as commands on a small scene: edits, undo and redo, ticks, time travel, resets.
void run_commands(std::string_view bytes);

// Numbers are finite, energies, readings and motors in their ranges, vehicles inside walls.
void is_sound(const Session&);

// The run that is saved and read again is the same, also later.
void is_restored(const Session&);

}  // namespace braitenlab::fuzz
