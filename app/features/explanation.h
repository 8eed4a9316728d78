// The cause of the selected vehicle's turn, followed while it is shown.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/insight/why.h"

namespace braitenlab {

struct Workspace;

struct Explanation {
    bool on = false;
    std::optional<insight::Why> why{};         // as shown
    std::uint64_t run = 0;                     // Document::run_id of what follows
    std::int64_t edits = 0;                    // Document::edits
    std::vector<insight::BrainMoment> past{};  // of successive ticks, up to insight::silenced_ticks before the last one
    std::uint64_t past_tick = 0;               // of the last moment
    VehicleId past_vehicle = no_vehicle;
};

// Call after each tick: records what the explanation of a brain with neurons needs, while it is shown.
void record_moment(Explanation&, const Workspace&);

// Call once per turn. While playing, the numbers change ten times a second, so that they can be read.
void update_explanation(Explanation&, const Workspace&);

// Goes to this tick and shows the cause there; pauses while playing.
void explain_at(Explanation&, Workspace&, std::uint64_t tick);

// null: not shown, or the vehicle's brain may not be shown, or it does not drive.
const insight::Why* explanation_of(const Explanation&, const Workspace&);

}  // namespace braitenlab
