#include "core/session/recording.h"

#include <algorithm>
#include <utility>

#include "core/world/cosmetic_edits.h"

namespace braitenlab {

namespace {

const auto by_tick = [](const LoggedCommand& command, std::uint64_t tick) { return command.tick < tick; };

}  // namespace

Recording::Recording(const Checkpoint& begin, RunObserver observer)
    : keyframes_{{begin.keyframe_tick, begin.keyframe, std::move(observer)}},
      commands_(begin.commands),
      latest_(begin.tick) {}

void Recording::add_step(const World& world, const RunObserver& observer) {
    latest_ = world.tick();
    if (world.keyframe_tick() == keyframes_.back().tick) return;
    keyframes_.push_back({world.keyframe_tick(), world.keyframe(), observer});
    while (keyframes_.size() > 1 && keyframes_[1].tick + recorded_ticks <= latest_) keyframes_.pop_front();
    commands_.erase(commands_.begin(), std::lower_bound(commands_.begin(), commands_.end(), earliest(), by_tick));
}

// A keyframe created by commands replaces the commands before it and a keyframe at the same tick.
void Recording::add_command(const World& world, const Command& command, const RunObserver& observer) {
    const std::uint64_t tick = world.tick();
    if (world::is_cosmetic(command)) return add_cosmetic(tick, command);
    if (!world.is_at_keyframe()) return commands_.push_back({tick, command});
    commands_.erase(std::lower_bound(commands_.begin(), commands_.end(), tick, by_tick), commands_.end());
    if (keyframes_.back().tick == tick) keyframes_.pop_back();
    keyframes_.push_back({tick, world.keyframe(), observer, true});
}

// Keeps the later recorded ticks: executes the edit in every later keyframe and changes later commands so that they do
// not revert it.
void Recording::add_cosmetic(std::uint64_t tick, const Command& edit) {
    for (Keyframe& keyframe : keyframes_)
        if (keyframe.tick > tick) keyframe.state = world::with_cosmetic(keyframe.state, edit);
    const auto later = std::lower_bound(commands_.begin(), commands_.end(), tick + 1, by_tick);
    for (auto c = later; c != commands_.end(); ++c) c->command = world::keeping_cosmetic(std::move(c->command), edit);
    commands_.insert(later, {tick, edit});
}

void Recording::forget_after(std::uint64_t tick) {
    while (keyframes_.back().tick > tick) keyframes_.pop_back();
    commands_.erase(std::lower_bound(commands_.begin(), commands_.end(), tick + 1, by_tick), commands_.end());
    latest_ = std::min(latest_, tick);
}

const Recording::Keyframe& Recording::last_keyframe(std::uint64_t tick) const {
    const auto after = std::find_if(keyframes_.begin() + 1, keyframes_.end(),
                                    [tick](const Keyframe& keyframe) { return keyframe.tick > tick; });
    return *(after - 1);
}

Checkpoint Recording::at(std::uint64_t tick) const {
    const Keyframe& keyframe = last_keyframe(tick);
    const auto begin = std::lower_bound(commands_.begin(), commands_.end(), keyframe.tick, by_tick);
    const auto end = std::lower_bound(commands_.begin(), commands_.end(), tick + 1, by_tick);
    return {keyframe.state, keyframe.tick, {begin, end}, tick};
}

std::vector<Command> Recording::commands_at(std::uint64_t tick) const {
    std::vector<Command> commands;
    for (auto c = std::lower_bound(commands_.begin(), commands_.end(), tick, by_tick);
         c != commands_.end() && c->tick == tick; ++c)
        commands.push_back(c->command);
    return commands;
}

std::optional<Checkpoint> Recording::keyframe_made_by_commands(std::uint64_t tick) const {
    const Keyframe& keyframe = last_keyframe(tick);
    if (keyframe.tick != tick || !keyframe.made_by_commands) return std::nullopt;
    return Checkpoint{keyframe.state, tick, {}, tick};
}

Checkpoint Recording::keyframe_at(std::uint64_t tick) const {
    const Keyframe& keyframe = last_keyframe(tick);
    return {keyframe.state, keyframe.tick, {}, keyframe.tick};
}

std::uint64_t Recording::keyframe_before(std::uint64_t tick) const { return last_keyframe(tick).tick; }

}  // namespace braitenlab
