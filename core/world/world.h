// A running simulation. The same scene, seed and commands give the same run, bit for bit.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/result.h"
#include "core/scene/scene.h"
#include "core/world/command.h"
#include "core/world/save.h"
#include "core/world/snapshot.h"

namespace braitenlab {

struct WorldState;  // core/world/state.h: inside core/world only

class World {
public:
    // Fails when the scene is inconsistent (see check_scene).
    static Result<World> create(const Scene&, std::uint64_t seed);

    World(World&&) noexcept;
    World& operator=(World&&) noexcept;
    ~World();

    // Carries a command out before the next tick. Refuses, leaving everything as it was, what cannot be done: a vehicle
    // that is gone, a brain that does not compile, a full arena.
    std::optional<Error> apply(const Command&);

    // One tick of 1/60 s: sense, think, drive, physics, remember, live.
    void step();

    std::uint64_t tick() const;

    // Fills a snapshot, reusing its memory.
    void capture(Snapshot&) const;

    // The run as it is now, and a world that goes on from there exactly as this one does. Costs nothing to make; to
    // restore, at most keyframe_ticks steps.
    Save save() const;
    static World restore(const Save&);

    // The last keyframe, its tick, and whether nothing was done since.
    const std::shared_ptr<const Moment>& keyframe() const { return since_.keyframe; }
    std::uint64_t keyframe_tick() const { return since_.keyframe_tick; }
    bool is_at_keyframe() const { return since_.commands.empty() && tick() == since_.keyframe_tick; }

    // A digest of everything that decides the future of the run.
    std::uint64_t hash() const;

private:
    explicit World(std::unique_ptr<WorldState>);
    void begin_keyframe();
    std::unique_ptr<WorldState> state_;
    Save since_;  // the last keyframe and what was done since
};

}  // namespace braitenlab
