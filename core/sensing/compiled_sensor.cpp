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
      inverse_range_squared(1 / (s.range * s.range)),
      inverse_half_distance_squared(1 / (s.half_distance * s.half_distance)),
      noise(s.noise),
      delay(delay_ticks(s)),
      sees_ambient_light(is_seen_as(s.channel, Channel::light)),
      is_blocked(is_blocked_by_obstacles(s.channel)) {}

std::uint32_t delay_ticks(const Sensor& s) { return static_cast<std::uint32_t>(s.latency / tick_seconds + 0.5f); }

bool in_field(const CompiledSensor& sensor, const SensorPose& pose, vec2 point) {
    const vec2 d = point - pose.position;
    const float squared = maths::dot(d, d), along = maths::dot(d, pose.axis);
    return squared <= sensor.range_squared && along >= sensor.cos_half_field * std::sqrt(squared) &&
           along <= sensor.reach;
}

float response_to(const CompiledSensor& sensor, const SensorPose& pose, vec2 point, float strength) {
    if (!in_field(sensor, pose, point)) return 0;
    if (sensor.response == SensorResponse::boolean) return strength;
    const vec2 d = point - pose.position;
    const float squared = maths::dot(d, d);
    return graded_response(sensor, squared, std::sqrt(squared), maths::dot(d, pose.axis), strength);
}

}  // namespace braitenlab::sensing
