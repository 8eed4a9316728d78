#include "core/insight/behaviour.h"

#include <algorithm>
#include <cmath>

#include "core/brain/brain.h"
#include "core/maths/angle.h"
#include "core/scene/arena.h"

namespace braitenlab::insight {

namespace {

using maths::vec2;

constexpr float near_touch = 0.05f;               // m, between chassis and object
constexpr float standing = 0.3f, farther = 0.5f;  // m, times scale_of() the arena
constexpr float resting = 0.1f;                   // m in the time of rest
constexpr float told_to_stand = 0.1f;             // wheel command
constexpr std::size_t rest_ticks = 120;
constexpr float jump = 1;  // m in a tick: a vehicle that fell returns to its start
constexpr float once_round = 2 * maths::pi;

bool can_sense(const std::vector<Sensor>& sensors, Channel channel) {
    return std::any_of(sensors.begin(), sensors.end(),
                       [&](const Sensor& sensor) { return is_seen_as(channel, sensor.channel); });
}

std::vector<vec2> sources_for(const Scene& scene, const std::vector<Sensor>& sensors) {
    std::vector<vec2> sensed, all;
    for (const Source& source : scene.sources) {
        all.push_back({source.x, source.y});
        if (can_sense(sensors, source.channel)) sensed.push_back(all.back());
    }
    return sensed.empty() ? all : sensed;
}

// From the chassis to a point, m; the point is given from the vehicle's origin.
float gap(vec2 offset, float heading, float half_length, float half_width) {
    const vec2 ahead = maths::direction(heading);
    const vec2 local = maths::rotate(offset, {ahead.x, -ahead.y});
    return maths::length(
        vec2{std::max(0.0f, std::fabs(local.x) - half_length), std::max(0.0f, std::fabs(local.y) - half_width)});
}

}  // namespace

Judge::Judge(const Snapshot& start, VehicleId id)
    : arena_(start.scene->arena),
      seam_(arena_),
      captures_before_(start.events.captures),
      closest_(NAN),
      last_(NAN),
      touched_at_(INFINITY) {
    const VehicleView& vehicle = *find_vehicle(start, id);
    const Kind& kind = kind_of(start, vehicle);
    half_length_ = kind.body.length / 2, half_width_ = kind.body.width / 2;
    dead_band_ = kind.body.dead_band;
    for (const Sensor& sensor : kind.sensors) reach_ = std::max(reach_, sensor.range);
    sources_ = sources_for(*start.scene, kind.sensors);
    if (!sources_.empty()) return;
    for (const VehicleView& other : start.vehicles)
        if (other.id != id) others_.push_back(other.id), half_lengths_.push_back(kind_of(start, other).body.length / 2);
}

std::optional<Judge::Nearest> Judge::nearest(vec2 at, const std::vector<vec2>& objects) const {
    std::optional<Nearest> found;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        if (std::isnan(objects[i].x)) continue;
        const vec2 offset = seam_.shortest(objects[i] - at);
        const float distance = maths::length(offset);
        if (!found || distance < found->distance) found = Nearest{i, offset, distance};
    }
    return found;
}

bool Judge::add(const VehicleTrace& now, const std::vector<vec2>& others) {
    const Pose& pose = now.pose;
    const vec2 at{pose.x, pose.y};
    if (!places_.empty() && maths::length(seam_.shortest(at - places_.back())) > jump) {
        fell_ = true;
        return false;
    }
    const bool is_first = places_.empty();
    told_ = std::max(std::fabs(now.motor[0]), std::fabs(now.motor[1]));
    places_.push_back(at);
    farthest_from_start_ = std::max(farthest_from_start_, maths::length(seam_.shortest(at - places_.front())));
    const auto object = nearest(at, sources_.empty() ? others : sources_);
    if (!object) return true;
    const float bearing = maths::arctangent2(-object->offset.y, -object->offset.x);
    if (is_first || !has_object_) first_ = closest_ = object->distance;
    if (has_object_ && object->index == round_)
        turned_ += maths::wrap_angle(bearing - bearing_);
    else
        turned_ = 0;
    has_object_ = true, round_ = object->index, bearing_ = bearing;
    most_turned_ = std::max(most_turned_, std::fabs(turned_));
    closest_ = std::min(closest_, object->distance), last_ = object->distance;
    const float radius = sources_.empty() ? half_lengths_[object->index] : source_radius(arena_);
    if (std::isinf(touched_at_) && gap(object->offset, pose.heading, half_length_, half_width_) <= radius + near_touch)
        touched_at_ = static_cast<float>(places_.size() - 1) * tick_seconds;
    return true;
}

bool Judge::rests() const {
    if (places_.size() <= rest_ticks || told_ > std::max(told_to_stand, dead_band_)) return false;
    const vec2 end = places_.back();
    return std::all_of(places_.end() - static_cast<std::ptrdiff_t>(rest_ticks), places_.end(),
                       [&](vec2 place) { return maths::length(seam_.shortest(place - end)) < resting; });
}

Behaviour Judge::behaviour_of(bool is_gone) const {
    const bool is_outside = places_.empty() || (arena_.edge == Boundary::open && !is_inside(arena_, places_.back()));
    if (is_gone || fell_ || is_outside) return Behaviour::leaves;
    if (!std::isinf(touched_at_)) return Behaviour::touches;
    const float scale = scale_of(arena_);
    if (farthest_from_start_ < scale * standing) return Behaviour::stands;
    if (!has_object_) return rests() ? Behaviour::stands : Behaviour::passes;
    if (most_turned_ >= once_round) return Behaviour::circles;
    const bool is_farther = last_ > first_ + scale * farther;
    if (rests()) {
        if (is_farther) return Behaviour::flees;
        return last_ < first_ ? Behaviour::rests_near : Behaviour::stands;
    }
    if (is_farther && closest_ > first_ / 2) return Behaviour::flees;
    if (last_ > reach_) return Behaviour::leaves;
    if (last_ < first_ - scale * farther && last_ <= closest_ + scale * farther) return Behaviour::approaches;
    return Behaviour::passes;
}

Outcome Judge::outcome(const EventCounts& events, bool is_gone) const {
    const auto ticks = static_cast<float>(places_.empty() ? 0 : places_.size() - 1);
    return {.behaviour = behaviour_of(is_gone),
            .closest = closest_,
            .final_distance = last_,
            .time_to_touch = touched_at_,
            .captures = static_cast<float>(events.captures - captures_before_),
            .survival = ticks * tick_seconds};
}

}  // namespace braitenlab::insight
