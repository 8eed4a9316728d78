// What takes edits back: commands that bring the old values again. Inside core/session only.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/world/command.h"
#include "core/world/snapshot.h"

namespace braitenlab {

// One step of undo: the commands that take it back and those that do it again.
struct UndoStep {
    std::vector<Command> back, again;
    std::uint64_t gesture = 0;
};

using SharedStep = std::shared_ptr<const UndoStep>;

// What can be taken back and done again, the latest last. Copies are cheap: steps are shared, never changed.
struct Edits {
    std::vector<SharedStep> done, undone;
};

// What undoes a command, judged before it is carried out; empty for those that only time or another command takes back
// (ChooseDriver, Steer, NewPopulation) and for those that would be refused.
std::vector<Command> undoing(const Snapshot& before, const Command&);

// The command again, made to do the very same: one that added a vehicle brings that vehicle, as it is `after`.
Command repeating(const Snapshot& after, const Command&);

// Whether the later command makes the earlier one pointless: the same value, brain or pose, set again.
bool supersedes(const Command& later, const Command& earlier);

// Whether it concerns brains alone, so that it still means something in a scene that was set back.
bool is_about_brains(const Command&);

// The command with other numbers for its vehicles.
Command renumbered(Command, const std::function<VehicleId(VehicleId)>&);

}  // namespace braitenlab
