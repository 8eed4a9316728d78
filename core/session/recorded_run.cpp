#include "core/session/recorded_run.h"

#include <algorithm>
#include <utility>

namespace braitenlab {

RecordedRun::RecordedRun(Recording recording, std::uint64_t from)
    : recording_(std::move(recording)),
      world_(World::restore(
          recording_.at(recording_.keyframe_before(std::clamp(from, recording_.earliest(), recording_.latest()))))) {
    while (world_.tick() < from) step();
    world_.capture(snapshot_);
}

void RecordedRun::step() {
    world_.step();
    if (world_.tick() <= recording_.latest()) {
        if (const auto made = recording_.keyframe_made_by_commands(world_.tick())) world_ = World::restore(*made);
        for (const Command& command : recording_.commands_at(world_.tick())) (void)world_.apply(command);
    }
    world_.capture(snapshot_);
}

std::map<VehicleId, RecordedPath> recorded_paths(const Recording& recording, std::uint64_t from, std::uint64_t to,
                                                 std::uint64_t stride) {
    std::map<VehicleId, RecordedPath> paths;
    for (RecordedRun run(recording, from);; run.step()) {
        if (run.tick() % stride == 0 || run.tick() == to)
            for (const VehicleView& v : run.snapshot().vehicles) {
                paths[v.id].places.push_back({v.x, v.y});
                paths[v.id].last = v;
            }
        if (run.tick() >= to) return paths;
    }
}

}  // namespace braitenlab
