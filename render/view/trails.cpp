#include "render/view/trails.h"

#include <algorithm>
#include <cmath>

#include "core/brain/brain.h"

namespace braitenlab::render {

namespace {

constexpr float still = 0.04f;  // m, least distance between two points
constexpr float far = 2.5f;     // m: a vehicle moved farther starts a new path
constexpr float fastest = 15;   // m/s: more than a wheel of any body

// Number of recorded points: ten minutes of a few vehicles, the minute that can be rewound of more, of a crowd only the
// points that are drawn.
std::size_t recorded_points(std::size_t vehicles) {
    constexpr std::size_t few = 64, crowd = 1000;
    return vehicles <= few ? 6000 : vehicles <= crowd ? 648 : 48;
}

// True when a jump between two points is a step over the edge of a torus.
bool went_round(const Arena& arena, maths::vec2 from, maths::vec2 to) {
    const auto around = [](float way, float side) { return std::min(std::fabs(way), side - std::fabs(way)); };
    return arena.edge == Boundary::torus &&
           std::hypot(around(to.x - from.x, arena.width), around(to.y - from.y, arena.height)) <= far;
}

// True if a vehicle can drive this far, m, in that many ticks.
bool can_drive(float distance, std::uint64_t ticks) {
    return distance <= std::min(far, still + fastest * tick_seconds * static_cast<float>(ticks));
}

// Distance from a point to a segment, m.
float distance_to_way(maths::vec2 place, maths::vec2 from, maths::vec2 to) {
    const maths::vec2 way = to - from;
    const float length = maths::dot(way, way);
    const float share = length > 0 ? std::clamp(maths::dot(place - from, way) / length, 0.0f, 1.0f) : 0.0f;
    return maths::distance(place, from + way * share);
}

}  // namespace

// Compares with the segment between the recorded points before and after the current tick. A vehicle that drives the
// same curve again is beside the segment by a small part of its length.
bool Trail::is_on_the_known_way(maths::vec2 place) const {
    const std::size_t next = places_.size() - later_;
    const maths::vec2 after = places_[next].at;
    if (next == 0 || !places_[next].is_joined)
        return maths::distance(place, next == 0 ? after : places_[next - 1].at) < still;
    const maths::vec2 before = places_[next - 1].at;
    return distance_to_way(place, before, after) < still + maths::distance(before, after) / 4;
}

bool Trail::extend(std::uint64_t tick, maths::vec2 place, const Arena& arena, std::size_t most) {
    Place before{place_, tick_};
    if (tick != tick_) {  // count the points after this tick
        while (later_ < places_.size() && places_[places_.size() - 1 - later_].tick > tick) ++later_;
        while (later_ > 0 && places_[places_.size() - later_].tick <= tick) --later_;
    }
    tick_ = tick, place_ = place;
    if (later_ > 0) {
        if (is_on_the_known_way(place)) return false;
        places_.resize(places_.size() - later_);
        later_ = 0;
    }
    bool is_joined = false;
    if (!places_.empty()) {
        const Place& last = places_.back();
        const float moved = maths::distance(last.at, place);
        if (moved < still) return false;
        if (before.tick < last.tick || before.tick > tick) before = last;
        is_joined = can_drive(maths::distance(before.at, place), tick - before.tick);
        if (is_joined && tick < last.tick + ticks_between) return false;
        if (!is_joined && !went_round(arena, last.at, place)) {
            if (moved > far)
                dropped_ += places_.size(), places_.clear();
            else if (!last.is_joined)
                ++dropped_, places_.pop_back();  // moved once more
        }
    }
    places_.push_back({place, tick, is_joined});
    while (places_.size() > most) places_.pop_front(), ++dropped_;
    return true;
}

void Trail::note(const TrailMoment& moment, const std::vector<Sensor>& sensors) {
    const std::size_t recorded = std::min(sensors.size(), recorded_sensors);
    if (!std::equal(sensors_.begin(), sensors_.end(), sensors.begin(),
                    sensors.begin() + static_cast<std::ptrdiff_t>(recorded),
                    [](const std::string& name, const Sensor& sensor) { return name == sensor.name; })) {
        for (Place& place : places_) place.moment.readings = TrailMoment::all_unknown();
        sensors_.clear();
        for (std::size_t i = 0; i < recorded; ++i) sensors_.push_back(sensors[i].name);
    }
    places_.back().moment = moment;
}

void Trails::record(const Snapshot& now) {
    // Edits make a new scene of the same name: the run continues.
    const std::string name = now.scene ? now.scene->name : std::string{};
    const Arena arena = now.scene ? now.scene->arena : Arena{};
    if (now.seed != seed_ || now.generation != generation_ || name != scene_) trails_.clear();
    seed_ = now.seed, generation_ = now.generation, scene_ = name;
    const std::size_t most = recorded_points(now.vehicles.size());
    for (const VehicleView& vehicle : now.vehicles) {
        Trail& trail = trails_[vehicle.id];
        if (trail.extend(now.tick, {vehicle.x, vehicle.y}, arena, most) && now.scene)
            trail.note(trail_moment_of(now, vehicle), kind_of(now, vehicle).sensors);
    }
    if (trails_.size() > now.vehicles.size())
        std::erase_if(trails_, [&](const auto& entry) { return !find_vehicle(now, entry.first); });
}

const Trail* Trails::of(VehicleId id) const {
    const auto found = trails_.find(id);
    return found == trails_.end() ? nullptr : &found->second;
}

}  // namespace braitenlab::render
