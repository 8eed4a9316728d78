// A world that repeats recorded ticks beside the session it was recorded by: for clips and pictures of paths.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "core/maths/vec.h"
#include "core/session/recording.h"
#include "core/world/snapshot.h"

namespace braitenlab {

class RecordedRun {
public:
    // At tick `from`, after its commands, or at the earliest recorded tick if that is later. The recording is copied:
    // the session may go on.
    RecordedRun(Recording, std::uint64_t from);

    // Goes on by one tick, with the commands recorded at it: bit for bit the recorded run. After the last recorded tick
    // the run goes on without commands, as the session would.
    void step();

    std::uint64_t tick() const { return world_.tick(); }
    // The reference stays valid and its content changes with step().
    const Snapshot& snapshot() const { return snapshot_; }

private:
    Recording recording_;
    World world_;
    Snapshot snapshot_;
};

struct RecordedPath {
    std::vector<maths::vec2> places;  // m
    VehicleView last;                 // when it was last there
};

// The path of each vehicle: a place per `stride` ticks from tick `from` on, and that at tick `to`. Costs a step per
// tick from the keyframe before `from`.
std::map<VehicleId, RecordedPath> recorded_paths(const Recording&, std::uint64_t from, std::uint64_t to,
                                                 std::uint64_t stride);

}  // namespace braitenlab
