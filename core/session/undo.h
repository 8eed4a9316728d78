// Undo and redo by commands: to undo a command, execute the commands that restore the old values.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/world/command.h"
#include "core/world/snapshot.h"

namespace braitenlab {

// One undo step: the commands that undo it and those that repeat it.
struct UndoStep {
    std::vector<Command> back, again;
    std::uint64_t gesture = 0;
    // Tick and generation after its last command. In that state `back` restores a removed vehicle exactly; later
    // another vehicle may have moved to its pose.
    std::uint64_t tick = 0;
    int generation = 0;  // 0: unknown
};

using SharedStep = std::shared_ptr<const UndoStep>;

// The steps that can be undone and redone, the latest last. Copies are cheap: steps are shared and immutable.
struct Edits {
    std::vector<SharedStep> done, undone;
};

// The commands that undo a command, from the snapshot before it. Empty for commands without undo (ChooseDriver, Steer,
// NewPopulation) and for those that will be refused.
std::vector<Command> undoing(const Snapshot& before, const Command&);

// The command that repeats a command. Repeating AddVehicle or SetPopulation adds the same vehicles as they are in the
// snapshot `after`.
Command repeating(const Snapshot& after, const Command&);

// True when the later command sets the same value, brain or pose as the earlier one, which then has no effect.
bool supersedes(const Command& later, const Command& earlier);

// The commands of `back` that restore something that no command of `known` restores.
std::vector<Command> beyond(const std::vector<Command>& known, std::vector<Command> back);

// True when the command edits brains only, so that it still applies after a reset of the scene.
bool is_about_brains(const Command&);

// The command with its vehicle ids replaced.
Command renumbered(Command, const std::function<VehicleId(VehicleId)>&);

}  // namespace braitenlab
