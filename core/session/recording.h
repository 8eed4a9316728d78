// The last minute of a run: enough of it to stand at any of its moments again, exactly.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "core/world/world.h"

namespace braitenlab {

inline constexpr std::uint64_t recorded_ticks = 3600;  // one minute at least, once the run is that long

class Recording {
public:
    // Begins with what the save holds, from its keyframe on.
    explicit Recording(const Checkpoint& begin);

    std::uint64_t earliest() const { return keyframes_.front().tick; }
    std::uint64_t latest() const { return latest_; }

    // Called when the world has taken a step, or a command, at a moment that is not recorded yet; a command that moves
    // nodes may come at a recorded one.
    void add_step(const World&);
    void add_command(const World&, const Command&);

    // Forgets everything after this moment: from here the run takes another way.
    void forget_after(std::uint64_t tick);

    // The moment at `tick`, earliest() .. latest(), after the commands that were given then.
    Checkpoint at(std::uint64_t tick) const;

    // The commands that were given between the step to `tick` and the next. Where there were so many that they made a
    // keyframe, those since: whoever steps there goes on from that keyframe, which this gives; else nothing.
    std::vector<Command> commands_at(std::uint64_t tick) const;
    std::optional<Checkpoint> made_by_commands(std::uint64_t tick) const;

    // The latest moment not after `tick` to which restoring costs no steps.
    std::uint64_t keyframe_before(std::uint64_t tick) const;

private:
    struct Keyframe {
        std::uint64_t tick = 0;
        std::shared_ptr<const world::State> state;
        bool made_by_commands = false;
    };
    const Keyframe& last_keyframe(std::uint64_t tick) const;
    void add_places(std::uint64_t tick, const PlaceNodes&);

    std::deque<Keyframe> keyframes_;       // by ascending tick, never empty
    std::vector<LoggedCommand> commands_;  // in order
    std::uint64_t latest_ = 0;
};

}  // namespace braitenlab
