#include "core/lesson/goals/others.h"

#include <algorithm>

#include "core/sensing/seam.h"

namespace braitenlab::goals {

std::optional<Reading> measure(const Follows& goal, Follows::State& state, const Observation& at) {
    const VehicleView* other = find_vehicle(at.now, at.subjects.id(goal.other));
    if (!other) return std::nullopt;
    const sensing::Seam seam(at.now.scene->arena);
    const maths::vec2 offset = seam.shortest({other->x - at.vehicle.x, other->y - at.vehicle.y});
    const float distance = maths::length(offset);
    state.degrees = degrees_off(at.vehicle, offset);
    return Reading{distance, distance <= goal.metres && state.degrees <= goal.degrees};
}

std::optional<Reading> measure(const Collides& goal, Collides::State&, const Observation& at) {
    const bool met = at.now.events.contacts <= goal.count;
    return Reading{static_cast<float>(at.now.events.contacts), met, !met};
}

std::optional<Reading> measure(const Captures& goal, Captures::State&, const Observation& at) {
    return Reading{static_cast<float>(at.now.events.captures), at.now.events.captures >= goal.count};
}

std::optional<Reading> measure(const Population& goal, Population::State&, const Observation& at) {
    const int kind = find_kind(*at.now.scene, goal.kind);
    const auto count = std::count_if(at.now.vehicles.begin(), at.now.vehicles.end(),
                                     [&](const VehicleView& vehicle) { return vehicle.kind == kind; });
    return Reading{static_cast<float>(count), count >= goal.count};
}

std::optional<Reading> measure(const Recharges& goal, Recharges::State& state, const Observation& at) {
    if (at.vehicle.energy < goal.low) state.is_low = true;
    if (state.is_low && at.vehicle.energy > goal.high) state.is_low = false, ++state.times;
    return Reading{static_cast<float>(state.times), state.times >= static_cast<std::uint64_t>(goal.count)};
}

std::optional<Reading> measure(const Matches& goal, Matches::State& state, const Observation& at) {
    if (!at.reference || at.now.tick >= at.reference->size()) return std::nullopt;
    const Pose& reference = (*at.reference)[static_cast<std::size_t>(at.now.tick)];
    const sensing::Seam seam(at.now.scene->arena);
    const float distance = maths::length(seam.shortest({reference.x - at.vehicle.x, reference.y - at.vehicle.y}));
    state.count += 1;
    state.mean += (static_cast<double>(distance) - state.mean) / state.count;
    const auto mean = static_cast<float>(state.mean);
    return Reading{mean, at.now.seconds >= static_cast<double>(goal.seconds) && mean <= goal.metres};
}

}  // namespace braitenlab::goals
