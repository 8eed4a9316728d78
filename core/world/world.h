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

// Ticks between two keyframes. Box2D keeps caches that cannot be restored; at a keyframe the world is therefore rebuilt
// from its state, so that a run restored from that state is identical.
inline constexpr std::uint64_t keyframe_ticks = 300;

// Number of commands since a keyframe that creates the next keyframe between two ticks. It limits the size of the log
// during a long drag in a paused run. Cosmetic commands do not count.
inline constexpr std::size_t keyframe_commands = 512;

// A command and the tick before which it was executed.
struct LoggedCommand {
    std::uint64_t tick = 0;
    Command command;
};

// A complete run at one tick: the last keyframe and the commands since. Restoring repeats the ticks and commands.
struct Checkpoint {
    std::shared_ptr<const world::State> keyframe;
    std::uint64_t keyframe_tick = 0;
    std::vector<LoggedCommand> commands;  // since the keyframe, in order
    std::uint64_t tick = 0;               // at most keyframe_ticks after the keyframe
};

// A run that can be stored and continued: the scene without edits, and the checkpoint.
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

    // Executes a command before the next tick. Returns an error and changes nothing when the command is invalid: an
    // unknown vehicle, a brain that does not compile, too many vehicles.
    std::optional<Error> apply(const Command&);

    // Computes one tick of 1/60 s: sense, think, drive, physics, boundary, memory, ecology.
    void step();

    std::uint64_t tick() const;
    const EventCounts& events() const;  // since the start of the run

    // Fills a snapshot and reuses its memory. After a command and before the next tick, readings, neurons and wheel
    // commands are those that the next tick will compute.
    void capture(Snapshot&) const;

    // Fills the trace of one vehicle and reuses its memory. Returns false when the vehicle is not in the world.
    bool trace(VehicleId, VehicleTrace&) const;

    // The pose if no vehicle and no obstacle is there, else the nearest free position on a grid around it with the same
    // heading. Precondition: the scene has this kind.
    Pose nearest_free_pose(int kind, const Pose&) const;

    // An independent copy of the run at this tick. It starts with a keyframe, so it evolves as this world does after a
    // keyframe at the same tick.
    World fork() const;

    // The same with another seed from this tick on: other noise, other random poses of vehicles that enter later.
    World fork(std::uint64_t seed) const;

    // checkpoint() returns the run at this tick and is cheap. restore() returns a world that continues the run exactly;
    // it costs at most keyframe_ticks steps.
    Checkpoint checkpoint() const;
    static World restore(const Checkpoint&);

    // The last keyframe, its tick, and whether there is no tick and no command since.
    const std::shared_ptr<const world::State>& keyframe() const { return since_.keyframe; }
    std::uint64_t keyframe_tick() const { return since_.keyframe_tick; }
    bool is_at_keyframe() const { return since_.commands.empty() && tick() == since_.keyframe_tick; }

    // Digest of all values that determine the further run.
    std::uint64_t hash() const;

private:
    explicit World(std::unique_ptr<world::WorldData>);
    void begin_keyframe();
    std::unique_ptr<world::WorldData> data_;
    Checkpoint since_;  // the last keyframe and the commands since; `tick` is not kept up to date
};

// A new snapshot.
inline Snapshot snapshot_of(const World& world) {
    Snapshot now;
    world.capture(now);
    return now;
}

}  // namespace braitenlab
