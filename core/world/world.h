// A running simulation. The same scene, seed and commands give the same run, bit for bit.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/result.h"
#include "core/scene/scene.h"
#include "core/world/command.h"
#include "core/world/snapshot.h"

namespace braitenlab {

namespace world {
struct State;      // core/world/state.h
struct WorldData;  // core/world/world_data.h: inside core/world only
}  // namespace world

// Box2D keeps caches that cannot be restored. A running world therefore rebuilds itself from its own state every
// keyframe_ticks; a run restored from that state is then the same run.
inline constexpr std::uint64_t keyframe_ticks = 300;

// This number of commands since a keyframe creates another one between two ticks, so that dragging for a long time in a
// paused run cannot grow the log without limit. Cosmetic commands do not count.
inline constexpr std::size_t keyframe_commands = 512;

// A command and the tick before which it was executed.
struct LoggedCommand {
    std::uint64_t tick = 0;
    Command command;
};

// A run at one tick, complete: the last keyframe and what was done since. Restoring repeats that.
struct Checkpoint {
    std::shared_ptr<const world::State> keyframe;
    std::uint64_t keyframe_tick = 0;
    std::vector<LoggedCommand> commands;  // since the keyframe, in order
    std::uint64_t tick = 0;               // at most keyframe_ticks after the keyframe
};

// A run that can be stored and continued: the scene as it was opened, and the checkpoint.
struct SavedRun {
    Scene opened;
    Checkpoint checkpoint;
};

class World {
public:
    // Fails when the scene is invalid (see check_scene).
    static Result<World> create(const Scene&, std::uint64_t seed);

    World(World&&) noexcept;
    World& operator=(World&&) noexcept;
    ~World();

    // Executes a command before the next tick. Refuses it and changes nothing when it cannot be done: an unknown
    // vehicle, a brain that does not compile, a full arena.
    std::optional<Error> apply(const Command&);

    // One tick of 1/60 s: sense, think, drive, physics, remember, live.
    void step();

    std::uint64_t tick() const;

    // Fills a snapshot and reuses its memory. After a command and before the next tick, readings, neurons and wheel
    // commands are those that the next tick will compute.
    void capture(Snapshot&) const;

    // Fills the trace of one vehicle and reuses its memory. Returns false when the vehicle is not in the world.
    bool trace(VehicleId, VehicleTrace&) const;

    // An independent copy of the run at this tick, which begins with a keyframe: it evolves as this world does after a
    // keyframe at the same tick.
    World fork() const;

    // The run at this tick, and a world that continues it exactly. A checkpoint costs almost nothing; restoring costs
    // at most keyframe_ticks steps.
    Checkpoint checkpoint() const;
    static World restore(const Checkpoint&);

    // The last keyframe, its tick, and whether nothing was done since.
    const std::shared_ptr<const world::State>& keyframe() const { return since_.keyframe; }
    std::uint64_t keyframe_tick() const { return since_.keyframe_tick; }
    bool is_at_keyframe() const { return since_.commands.empty() && tick() == since_.keyframe_tick; }

    // A digest of everything that decides the future of the run.
    std::uint64_t hash() const;

private:
    explicit World(std::unique_ptr<world::WorldData>);
    void begin_keyframe();
    std::unique_ptr<world::WorldData> data_;
    Checkpoint since_;  // the last keyframe and what was done since; `tick` is not kept up to date
};

}  // namespace braitenlab
