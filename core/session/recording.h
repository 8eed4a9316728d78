// Recording: the last minute of a run. Each of its ticks can be restored exactly. Each keyframe holds the state of the
// world and the run's observer.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "core/session/run_observer.h"
#include "core/world/world.h"

namespace braitenlab {

inline constexpr std::uint64_t recorded_ticks = 3600;  // minimum number of recorded ticks in a longer run: 1 min

class Recording {
public:
    // Starts at the checkpoint's keyframe. `observer`: as it was there.
    explicit Recording(const Checkpoint& begin, RunObserver observer = {});

    std::uint64_t earliest() const { return keyframes_.front().tick; }
    std::uint64_t latest() const { return latest_; }

    // Call add_step() after each step of the world and add_command() after each command, once the observer has seen it.
    // Precondition: latest() is not after the world's tick, except for cosmetic commands.
    void add_step(const World&, const RunObserver&);
    void add_command(const World&, const Command&, const RunObserver&);

    // Removes everything after this tick.
    void forget_after(std::uint64_t tick);

    // The run at `tick`, earliest() .. latest(), after the commands of that tick.
    Checkpoint at(std::uint64_t tick) const;

    // The commands executed between the step to `tick` and the next step; after a keyframe created by commands, those
    // since that keyframe.
    std::vector<Command> commands_at(std::uint64_t tick) const;

    // Keyframe created by the commands at `tick`, or nullopt. Restore from it instead of replaying them.
    std::optional<Checkpoint> keyframe_made_by_commands(std::uint64_t tick) const;

    // The last keyframe at or before `tick`, without the commands executed at its tick since.
    Checkpoint keyframe_at(std::uint64_t tick) const;

    // The observer at that keyframe.
    const RunObserver& observer_at(std::uint64_t tick) const { return last_keyframe(tick).observer; }

    // Tick of the last keyframe at or before `tick`. Restoring it costs no steps.
    std::uint64_t keyframe_before(std::uint64_t tick) const;

private:
    struct Keyframe {
        std::uint64_t tick = 0;
        std::shared_ptr<const world::State> state;
        RunObserver observer{};
        bool made_by_commands = false;
    };
    const Keyframe& last_keyframe(std::uint64_t tick) const;
    void add_cosmetic(std::uint64_t tick, const Command& edit);

    std::deque<Keyframe> keyframes_;       // by ascending tick, never empty
    std::vector<LoggedCommand> commands_;  // in order
    std::uint64_t latest_ = 0;
};

}  // namespace braitenlab
