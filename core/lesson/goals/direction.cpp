#include "core/lesson/goals/direction.h"

namespace braitenlab::goals {

std::optional<Reading> measure(const TurnsTo& goal, TurnsTo::State& state, const Observation& at) {
    const auto offset = offset_to_source(goal.source, at);
    if (!offset) return std::nullopt;
    const float off = degrees_off(at.vehicle, *offset);
    if (off > goal.degrees) state.was_outside = true;
    return Reading{off, state.was_outside && off <= goal.degrees};
}

std::optional<Reading> measure(const TurnsAway& goal, TurnsAway::State& state, const Observation& at) {
    const auto offset = offset_to_source(goal.source, at);
    if (!offset) return std::nullopt;
    const float off = degrees_off(at.vehicle, *offset);
    if (off < goal.degrees) state.was_inside = true;
    return Reading{off, state.was_inside && off >= goal.degrees};
}

std::optional<Reading> measure(const Faces& goal, Faces::State&, const Observation& at) {
    const auto offset = offset_to_source(goal.source, at);
    if (!offset) return std::nullopt;
    const float off = degrees_off(at.vehicle, *offset);
    return Reading{off, off <= goal.degrees};
}

}  // namespace braitenlab::goals
