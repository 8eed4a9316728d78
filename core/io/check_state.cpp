#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <tuple>
#include <vector>

#include "core/io/state_json.h"
#include "core/messages.h"
#include "core/scene/scene_file.h"
#include "core/scene/schema.h"
#include "core/world/present_parts.h"

namespace braitenlab::io {

using world::Bite;
using world::Mark;
using world::State;
using world::Strike;
using world::Touch;
using world::Vehicles;

namespace {

constexpr auto most_vehicles = static_cast<std::size_t>(limits::vehicles);
constexpr float farthest = 1e5f;  // limit of coordinates (m), speeds (m/s) and angular velocities (rad/s)
constexpr std::uint64_t last_tick = std::uint64_t{1} << 53U;
constexpr std::int32_t last_number = 2'000'000'000;  // of a generation or a vehicle: the next ones fit in 32 bits

bool within(float value, float low, float high) { return value >= low && value <= high; }  // false for NaN
bool is_bounded(float value) { return within(value, -farthest, farthest); }
bool is_bounded(maths::vec2 v) { return is_bounded(v.x) && is_bounded(v.y); }

bool is_sound(const mechanics::Motion& m) {
    return is_bounded(m.position) && is_bounded(m.velocity) && is_bounded(m.angular_velocity) &&
           is_bounded(m.heading) && within(maths::length(m.ahead), 0.999f, 1.001f);
}

template <class Values, class IsSound>
bool all_of(const Values& values, IsSound is_sound) {
    return std::all_of(values.begin(), values.end(), is_sound);
}

template <class Values>
bool ascend(const Values& values) {
    return std::adjacent_find(values.begin(), values.end(), [](const auto& a, const auto& b) { return !(a < b); }) ==
           values.end();
}

bool components_within(std::floating_point auto value, float low, float high) { return value >= low && value <= high; }
bool components_within(const std::array<float, 2>& pair, float low, float high) {
    return within(pair[0], low, high) && within(pair[1], low, high);
}

// More vehicles of a kind in one place than a run has, which physics would push apart for minutes.
std::optional<Error> pile_fault(const State& m) {
    constexpr std::size_t always_allowed = 100, most = 32;
    const Vehicles& v = m.vehicles;
    if (v.size() <= always_allowed) return std::nullopt;
    std::vector<std::tuple<std::int32_t, std::int64_t, std::int64_t>> squares;
    for (std::size_t row = 0; row < v.size(); ++row) {
        const Body& body = m.scene->kinds[static_cast<std::size_t>(v.kind[row])].body;
        const maths::vec2 at = v.motion[row].position / std::min(body.length, body.width);
        squares.emplace_back(v.kind[row], std::llround(at.x), std::llround(at.y));
    }
    std::sort(squares.begin(), squares.end());
    for (std::size_t i = most; i < squares.size(); ++i)
        if (squares[i - most] == squares[i]) return error_of(message_of("contradicts", "vehicles"));
    return std::nullopt;
}

// Of what the state has and not its scene: pushed obstacles, edited brains and sensors, all its vehicles. Twice the
// limit of a scene, because vehicles may have pushed obstacles together.
std::optional<Error> work_fault(const State& m) {
    constexpr double most = 2 * most_work;
    Scene now = *m.scene;
    for (std::size_t i = 0; i < now.obstacles.size(); ++i)
        now.obstacles[i].x = m.obstacles[i].position.x, now.obstacles[i].y = m.obstacles[i].position.y;
    const auto in_population = static_cast<int>(m.vehicles.size()) - static_cast<int>(now.starts.size());
    now.ecology.population = std::max(now.ecology.population, in_population);
    const double work = work_of_a_tick(now, world::present_parts(m));
    if (work <= most) return std::nullopt;
    return error_of(too_much_work(static_cast<long long>(m.vehicles.size()), work, most));
}

std::optional<Error> vehicles_fault(const State& m) {
    const Vehicles& v = m.vehicles;
    if (v.size() > most_vehicles) return error_of(message_of("full_world", most_vehicles));
    bool complete = true;
    Vehicles::each_column(v, [&](const auto& column) { complete &= column.size() == v.size(); });
    if (!complete) return error_of(message_of("vehicles_incomplete"));
    if (!ascend(v.id) || (v.size() > 0 && (v.id.front() < 0 || v.id.back() >= m.next_id)))
        return error_of(message_of("vehicle_numbers"));
    const auto starts = static_cast<std::int32_t>(m.scene->starts.size());
    if (!all_of(v.start, [&](std::int32_t start) { return start >= -1 && start < starts; }))
        return error_of(message_of("vehicle_start"));
    for (std::size_t row = 0; row < v.size(); ++row) {
        const auto waypoints = m.scene->kinds[static_cast<std::size_t>(v.kind[row])].waypoints.size();
        if (v.waypoint[row] < 0 || (v.waypoint[row] > 0 && static_cast<std::size_t>(v.waypoint[row]) >= waypoints))
            return error_of(message_of("vehicle_waypoint", v.id[row]));
    }
    bool values_are_sound = all_of(v.motion, is_sound) && all_of(v.sensed, [](float s) { return within(s, 0, 1); }) &&
                            all_of(v.delayed, [](float s) { return within(s, 0, 1); }) &&
                            all_of(v.neurons, [](float n) { return is_bounded(n); });
    world::each_vehicle_value([&](const auto& value) {
        if constexpr (requires { components_within((v.*value.column)[0], 0.0f, 0.0f); })
            if (value.limits)
                values_are_sound &= all_of(v.*value.column, [&](const auto& each) {
                    return components_within(each, (*value.limits)[0], (*value.limits)[1]);
                });
    });
    if (!values_are_sound) return error_of(message_of("vehicle_range"));
    return pile_fault(m);
}

}  // namespace

std::optional<Error> check_state(const State& m) {
    if (m.kind_brains.size() != m.scene->kinds.size()) return error_of(message_of("brains_of_kinds"));
    const auto is_counted = [](std::int64_t count) { return count >= 0 && count <= std::int64_t{1} << 53U; };
    const EventCounts& e = m.events;
    const auto within_numbers = [](std::int32_t number, std::int32_t first) {
        return number >= first && number <= last_number;
    };
    if (m.tick > last_tick || !within_numbers(m.generation, 1) || !within_numbers(m.next_id, 0) ||
        !all_of(std::array{e.captures, e.deaths, e.births, e.contacts, e.falls}, is_counted))
        return error_of(message_of("clock_range"));
    if (auto error = vehicles_fault(m)) return error;
    const auto lives = [&](VehicleId id) { return std::binary_search(m.vehicles.id.begin(), m.vehicles.id.end(), id); };
    // Contacts can refer to removed vehicles.
    const auto has_lived = [&](VehicleId id) { return id >= 0 && id < m.next_id; };
    const auto touch_is_sound = [&](const Touch& t) {
        return has_lived(t.one) && (t.other == no_vehicle || (has_lived(t.other) && t.one < t.other));
    };
    if (!all_of(m.touching, touch_is_sound) || !ascend(m.touching))
        return error_of(message_of("contradicts", "touching"));
    if (m.bites.size() > most_vehicles || !all_of(m.bites, [&](const Bite& b) { return b.tick <= m.tick; }))
        return error_of(message_of("contradicts", "bites"));
    const auto ascends = [](const Strike& a, const Strike& b) { return a.pair() >= b.pair(); };
    if (std::adjacent_find(m.strikes.begin(), m.strikes.end(), ascends) != m.strikes.end() ||
        !all_of(m.strikes,
                [&](const Strike& s) { return touch_is_sound(s.pair()) && is_bounded(s.at) && s.tick <= m.tick; }))
        return error_of(message_of("contradicts", "strikes"));
    const auto by_owner = [](const Mark& a, const Mark& b) { return a.owner < b.owner; };
    if (!std::is_sorted(m.marks.begin(), m.marks.end(), by_owner) ||
        m.marks.size() > most_vehicles * static_cast<std::size_t>(limits::marks) ||
        !all_of(m.marks, [&](const Mark& k) { return lives(k.owner) && is_bounded(k.position) && k.tick <= m.tick; }))
        return error_of(message_of("contradicts", "marks"));
    const auto in_order = [](const VehicleLook& a, const VehicleLook& b) { return a.vehicle < b.vehicle; };
    if (!std::is_sorted(m.looks.begin(), m.looks.end(), in_order) ||
        !all_of(m.looks, [&](const VehicleLook& l) { return lives(l.vehicle) && !check_look(l.look); }))
        return error_of(message_of("contradicts", "looks"));
    if (m.obstacles.size() != m.scene->obstacles.size() || !all_of(m.obstacles, is_sound))
        return error_of(message_of("contradicts", "obstacles"));
    return work_fault(m);
}

}  // namespace braitenlab::io
