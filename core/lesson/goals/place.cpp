#include "core/lesson/goals/place.h"

#include <algorithm>
#include <vector>

#include "core/brain/brain.h"
#include "core/maths/angle.h"
#include "core/maths/geometry.h"
#include "core/sensing/seam.h"

namespace braitenlab::goals {

namespace {

using maths::vec2;

vec2 place_of(const Observation& at) { return {at.vehicle.x, at.vehicle.y}; }

std::optional<float> distance_to_source(const std::string& source, const Observation& at) {
    const auto offset = offset_to_source(source, at);
    return offset ? std::optional(maths::length(*offset)) : std::nullopt;
}

bool is_between(float value, float from, float to) { return value >= from && value <= to; }

// In the zone's own frame. From an ellipse the distance along the line to its centre.
float distance_to_ellipse(vec2 point, float half_length, float half_width) {
    const float scale = maths::length(vec2{point.x / half_length, point.y / half_width});
    return scale <= 1 ? 0 : maths::length(point) * (1 - 1 / scale);
}

float distance_to_convex(vec2 point, const std::vector<vec2>& corners) {
    bool inside = true;
    float nearest = INFINITY;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const vec2 a = corners[i], b = corners[(i + 1) % corners.size()];
        inside &= maths::cross(b - a, point - a) >= 0;
        nearest = std::min(nearest, maths::distance(point, maths::nearest_on_segment(point, a, b)));
    }
    return inside ? 0 : nearest;
}

// 0 inside the zone.
float distance_to_zone(const Zone& zone, vec2 place) {
    const vec2 ahead = maths::direction(zone.heading);
    const vec2 local = maths::rotate(place - vec2{zone.x, zone.y}, {ahead.x, -ahead.y});
    if (zone.round && zone.corners.empty()) return distance_to_ellipse(local, zone.length / 2, zone.width / 2);
    return distance_to_convex(local, corners_of(zone));
}

// To the nearest image of the zone; `images` as Seam::images().
float distance_to_zone(const Zone& zone, vec2 place, const std::vector<vec2>& images) {
    float nearest = INFINITY;
    for (const vec2 image : images) nearest = std::min(nearest, distance_to_zone(zone, place - image));
    return nearest;
}

std::optional<vec2> place_of_obstacle(const std::string& name, const Observation& at) {
    const int index = find_obstacle(*at.now.scene, name);
    if (index < 0) return std::nullopt;
    const Pose& pose = at.now.obstacles[static_cast<std::size_t>(index)];
    return vec2{pose.x, pose.y};
}

bool segments_cross(vec2 a, vec2 b, vec2 c, vec2 d) {
    const auto side = [](vec2 from, vec2 to, vec2 point) { return maths::cross(to - from, point - from); };
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

constexpr double full_turn = 2 * maths::pi_d;

}  // namespace

std::optional<Reading> measure(const Touches& goal, Touches::State&, const Observation& at) {
    const auto distance = distance_to_source(goal.source, at);
    if (!distance) return std::nullopt;
    return Reading{*distance, *distance <= goal.metres};
}

std::optional<Reading> measure(const Avoids& goal, Avoids::State& state, const Observation& at) {
    const auto distance = distance_to_source(goal.source, at);
    if (!distance) return std::nullopt;
    state.nearest = state.nearest < 0 ? *distance : std::min(state.nearest, *distance);
    const bool met = state.nearest >= goal.metres;
    return Reading{state.nearest, met, !met};
}

std::optional<Reading> measure(const KeepsDistance& goal, KeepsDistance::State&, const Observation& at) {
    const auto distance = distance_to_source(goal.source, at);
    if (!distance) return std::nullopt;
    return Reading{*distance, is_between(*distance, goal.from, goal.to)};
}

std::optional<Reading> measure(const Circles& goal, Circles::State& state, const Observation& at) {
    const auto offset = offset_to_source(goal.source, at);
    if (!offset) return std::nullopt;
    const maths::Polar now = maths::to_polar(-*offset);
    const bool inside = is_between(now.distance, goal.from, goal.to);
    if (!inside)
        state.turned = 0;
    else if (state.inside)
        state.turned += static_cast<double>(maths::wrap_angle(now.angle - state.bearing));
    state.inside = inside;
    state.bearing = now.angle;
    const auto rounds = static_cast<float>(std::fabs(state.turned) / full_turn);
    return Reading{rounds, rounds >= goal.rounds};
}

std::optional<Reading> measure(const SteadyDistance& goal, SteadyDistance::State& state, const Observation& at) {
    const auto distance = distance_to_source(goal.source, at);
    if (!distance) return std::nullopt;
    const auto now = static_cast<std::int64_t>(at.now.tick);
    state.nearest = std::min(state.nearest, *distance), state.furthest = std::max(state.furthest, *distance);
    const bool varied = state.furthest - state.nearest > goal.percent / 100 * state.furthest;
    if (state.since < 0 || varied) state.since = now, state.nearest = state.furthest = *distance;
    const auto seconds = static_cast<float>(seconds_at(static_cast<std::uint64_t>(now - state.since)));
    return Reading{seconds, seconds >= goal.seconds};
}

std::optional<Reading> measure(const Visits& goal, Visits::State& state, const Observation& at) {
    const sensing::Seam seam(at.now.scene->arena);
    for (std::size_t i = 0; i < std::min<std::size_t>(64, at.now.sources.size()); ++i) {
        const SourceView& source = at.now.sources[i];
        if (maths::length(seam.shortest(vec2{source.x, source.y} - place_of(at))) <= goal.metres)
            state.visited |= std::uint64_t{1} << i;
    }
    int count = 0;
    for (std::uint64_t rest = state.visited; rest != 0; rest &= rest - 1) ++count;
    return Reading{static_cast<float>(count), count >= goal.count};
}

std::optional<Reading> measure(const Enters& goal, Enters::State&, const Observation& at) {
    const int index = find_zone(*at.now.scene, goal.zone);
    if (index < 0) return std::nullopt;
    const float distance = distance_to_zone(at.now.scene->zones[static_cast<std::size_t>(index)], place_of(at),
                                            sensing::Seam(at.now.scene->arena).images());
    return Reading{distance, distance <= 0};
}

std::optional<Reading> measure(const DrivesThrough& goal, DrivesThrough::State& state, const Observation& at) {
    const auto left = place_of_obstacle(goal.left, at), right = place_of_obstacle(goal.right, at);
    if (!left || !right) return std::nullopt;
    const sensing::Seam seam(at.now.scene->arena);
    const vec2 to_post = seam.shortest(*right - *left) / 2, middle = *left + to_post, place = place_of(at);
    const vec2 from = seam.shortest(vec2{state.x, state.y} - middle);
    const vec2 to = from + seam.shortest(place - vec2{state.x, state.y});
    const std::int64_t moves = at.now.generation + at.now.events.falls;
    const bool has_driven = state.begun && state.moves == moves;
    if (has_driven && segments_cross(-to_post, to_post, from, to)) state.crossed = true;
    state = {true, state.crossed, place.x, place.y, moves};
    if (state.crossed) return Reading{0, true};
    const vec2 now = seam.shortest(place - middle);
    return Reading{maths::distance(now, maths::nearest_on_segment(now, -to_post, to_post)), false};
}

std::optional<Reading> measure(const FollowsLine& goal, FollowsLine::State& state, const Observation& at) {
    const std::vector<vec2> images = sensing::Seam(at.now.scene->arena).images();
    vec2 middle;
    float nearest = INFINITY, pieces = 0;
    for (const Zone& zone : at.now.scene->zones) {
        if (zone.surface != Surface::tape) continue;
        middle += vec2{zone.x, zone.y};
        pieces += 1;
        nearest = std::min(nearest, distance_to_zone(zone, place_of(at), images));
    }
    if (pieces == 0) return std::nullopt;
    const float bearing = maths::to_polar(place_of(at) - middle / pieces).angle;
    if (state.begun && nearest <= goal.metres)
        state.turned += static_cast<double>(maths::wrap_angle(bearing - state.bearing));
    state.begun = true;
    state.bearing = bearing;
    const auto laps = static_cast<float>(std::fabs(state.turned) / full_turn);
    return Reading{laps, laps >= goal.laps};
}

}  // namespace braitenlab::goals
