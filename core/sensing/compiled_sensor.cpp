#include "core/sensing/compiled_sensor.h"

#include <limits>

#include "core/brain/brain.h"

namespace braitenlab::sensing {

using maths::vec2;

namespace {

float reach_of(const Sensor& s) {
    if (s.shape != SensorShape::triangle) return std::numeric_limits<float>::max();
    return s.range * std::max(0.0f, maths::cosine(s.fov / 2));
}

// In microseconds; 0 for an interval that is no longer than a tick.
std::uint32_t interval_of(const Sensor& s) {
    return s.interval > tick_seconds ? static_cast<std::uint32_t>(s.interval * 1e6f + 0.5f) : 0;
}

}  // namespace

CompiledSensor::CompiledSensor(const Sensor& s)
    : channel(s.channel),
      shape(s.shape),
      response(s.response),
      mount{s.x, s.y},
      axis(maths::direction(s.angle)),
      left_arm(maths::direction(s.angle + s.fov / 2)),
      right_arm(maths::direction(s.angle - s.fov / 2)),
      cos_half_field(s.shape == SensorShape::omni ? -2.0f : maths::cosine(s.fov / 2)),
      reach(reach_of(s)),
      least_cosine(s.shape == SensorShape::omni ? 1.0f : 0.0f),
      range(s.range),
      range_squared(s.range * s.range),
      inverse_range_squared(s.hard_range ? 0 : 1 / (s.range * s.range)),
      inverse_half_distance_squared(1 / (s.half_distance * s.half_distance)),
      gamma(s.gamma),
      per_lux(1 / s.half_lux),
      per_candela(1 / (s.half_lux * s.half_distance * s.half_distance)),
      gain_spread(s.gain_spread),
      points(s.response == SensorResponse::table ? s.points : std::vector<ResponsePoint>{}),
      noise(s.noise),
      delay(delay_ticks(s)),
      interval(interval_of(s)),
      steps(s.bits > 0 ? static_cast<float>(1U << static_cast<unsigned>(s.bits)) : 0.0f),
      sees_ambient_light(is_seen_as(s.channel, Channel::light)),
      is_blocked(is_blocked_by_obstacles(s.channel)) {}

std::uint32_t delay_ticks(const Sensor& s) { return static_cast<std::uint32_t>(s.latency / tick_seconds + 0.5f); }

std::uint32_t kept_readings(const Sensor& s) { return (interval_of(s) > 0 ? 1 : 0) + delay_ticks(s); }

bool is_sampled(std::uint32_t interval, std::uint64_t tick) {
    if (interval == 0 || tick == 0) return true;
    constexpr std::uint64_t microseconds = 1000000, ticks = 60;  // of a second
    const auto number = [&](std::uint64_t t) { return t * microseconds / (ticks * interval); };
    return number(tick) != number(tick - 1);
}

bool in_field(const CompiledSensor& sensor, const SensorPose& pose, vec2 point) {
    const vec2 d = point - pose.position;
    const float squared = maths::dot(d, d), along = maths::dot(d, pose.axis);
    return squared <= sensor.range_squared && along >= sensor.cos_half_field * std::sqrt(squared) &&
           along <= sensor.reach;
}

float response_to(const CompiledSensor& sensor, const SensorPose& pose, vec2 point, float strength) {
    if (!in_field(sensor, pose, point)) return 0;
    const vec2 d = point - pose.position;
    const float squared = maths::dot(d, d);
    return response_in_field(sensor, squared, std::sqrt(squared), maths::dot(d, pose.axis), strength);
}

float response_in_field(const CompiledSensor& sensor, float squared, float distance, float along, float strength) {
    constexpr float dazzling = 1e9f;  // of a lamp in the eye itself
    const auto cosine = [&] { return distance > 0 ? std::max(along / distance, sensor.least_cosine) : 1.0f; };
    switch (sensor.response) {
        case SensorResponse::boolean:
            return strength;
        case SensorResponse::photocell: {
            const float near = squared * sensor.inverse_half_distance_squared;
            return strength * cosine() * (near * dazzling > 1 ? 1 / near : dazzling);
        }
        case SensorResponse::table:
            return strength * cosine() * table_reading(sensor.points, distance);
        case SensorResponse::graded:
            break;
    }
    return graded_response(sensor, squared, distance, along, strength);
}

float table_reading(const std::vector<ResponsePoint>& points, float distance) {
    if (points.empty() || distance > points.back().distance) return 0;
    const auto after = std::find_if(points.begin(), points.end(),
                                    [distance](const ResponsePoint& point) { return point.distance >= distance; });
    if (after == points.begin()) return after->reading;
    const ResponsePoint &a = *(after - 1), &b = *after;
    return a.reading + (b.reading - a.reading) * ((distance - a.distance) / (b.distance - a.distance));
}

float total_reading(const CompiledSensor& sensor, float sum, float ambient, float lux) {
    if (sensor.response != SensorResponse::photocell) return sum + ambient;
    // The light that alone gives the reading `ambient`.
    const float around = ambient <= 0   ? 0.0f
                         : ambient >= 1 ? std::numeric_limits<float>::max() / 2
                                        : maths::power(ambient / (1 - ambient), 1 / sensor.gamma);
    const float light = maths::power(sum + around + lux * sensor.per_lux, sensor.gamma);
    return light / (1 + light);
}

}  // namespace braitenlab::sensing
