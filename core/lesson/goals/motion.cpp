#include "core/lesson/goals/motion.h"

#include <algorithm>

#include "core/brain/brain.h"

namespace braitenlab::goals {

namespace {

// The lowest first speed that a speed is compared with: any speed is a large multiple of that of a standing vehicle.
constexpr float least_first_speed = 0.05f;  // m/s

// Reading of the vehicle's sensor with this name.
std::optional<float> reading_of(const std::string& sensor, const Observation& at) {
    const std::vector<Sensor>& sensors = kind_of(at.now, at.vehicle).sensors;
    const auto found = std::find_if(sensors.begin(), sensors.end(), [&](const Sensor& s) { return s.name == sensor; });
    if (found == sensors.end()) return std::nullopt;
    return at.now.sensed[static_cast<std::size_t>(at.vehicle.first_sensed + (found - sensors.begin()))];
}

}  // namespace

std::optional<Reading> measure(const Runs& goal, Runs::State&, const Observation& at) {
    const auto seconds = static_cast<float>(at.now.seconds);
    return Reading{seconds, seconds >= goal.seconds};
}

std::optional<Reading> measure(const Survives& goal, Survives::State& state, const Observation& at) {
    const auto seconds = static_cast<float>(at.now.seconds);
    if (state.fell_at < 0 && at.now.events.falls > 0) state.fell_at = seconds;
    const bool has_fallen = state.fell_at >= 0;
    return Reading{has_fallen ? state.fell_at : seconds, !has_fallen && seconds >= goal.seconds, has_fallen};
}

std::optional<Reading> measure(const SpeedsUp& goal, SpeedsUp::State& state, const Observation& at) {
    if (state.first_speed == 0 && at.now.seconds >= 1)
        state.first_speed = std::max(std::fabs(at.vehicle.speed), least_first_speed);
    if (!state.decided) {
        const auto offset = offset_to_source(goal.source, at);
        if (!offset || state.first_speed == 0) return std::nullopt;
        state.ratio = std::fabs(at.vehicle.speed) / state.first_speed;
        state.decided = maths::length(*offset) <= goal.metres;
    }
    const bool met = state.decided && state.ratio >= goal.factor;
    return Reading{state.ratio, met, state.decided && !met};
}

std::optional<Reading> measure(const Rests& goal, Rests::State&, const Observation& at) {
    const float speed = std::fabs(at.vehicle.speed);
    return Reading{speed, speed <= goal.speed};
}

std::optional<Reading> measure(const Drives& goal, Drives::State&, const Observation& at) {
    const float speed = std::fabs(at.vehicle.speed);
    return Reading{speed, speed >= goal.speed};
}

std::optional<Reading> measure(const KeepsSpeed& goal, KeepsSpeed::State&, const Observation& at) {
    return Reading{at.vehicle.speed, at.vehicle.speed >= goal.from && at.vehicle.speed <= goal.to};
}

std::optional<Reading> measure(const KeepsMoving& goal, KeepsMoving::State& state, const Observation& at) {
    const auto now = static_cast<std::int64_t>(at.now.tick);
    if (std::fabs(at.vehicle.speed) >= goal.speed)
        state.slow_since = -1;
    else if (state.slow_since < 0)
        state.slow_since = now;
    else
        state.longest = std::max(state.longest, now - state.slow_since);
    const auto longest = static_cast<float>(seconds_at(static_cast<std::uint64_t>(state.longest)));
    const bool met = longest <= goal.seconds;
    return Reading{longest, met, !met};
}

std::optional<Reading> measure(const SpeedFollows& goal, SpeedFollows::State& state, const Observation& at) {
    const auto reading = reading_of(goal.sensor, at);
    if (!reading) return std::nullopt;
    state.count += 1;
    const auto speed = static_cast<double>(at.vehicle.speed), level = static_cast<double>(*reading);
    const double speed_before = speed - state.mean_speed, level_before = level - state.mean_reading;
    state.mean_speed += speed_before / state.count;
    state.mean_reading += level_before / state.count;
    state.speed_moment += speed_before * (speed - state.mean_speed);
    state.reading_moment += level_before * (level - state.mean_reading);
    state.product_moment += speed_before * (level - state.mean_reading);
    const double spread = std::sqrt(state.speed_moment * state.reading_moment);
    const auto correlation = static_cast<float>(spread > 0 ? state.product_moment / spread : 0);
    return Reading{correlation, at.now.seconds >= static_cast<double>(goal.seconds) && correlation >= goal.correlation};
}

}  // namespace braitenlab::goals
