// Drivers compute wheel commands: a brain, manual control, a path, random motion, or none.
#include <algorithm>
#include <cmath>

#include "core/maths/angle.h"
#include "core/maths/random.h"
#include "core/scene/arena.h"
#include "core/world/world_data.h"

namespace braitenlab::world {

using maths::vec2;

namespace {

using Wheels = std::array<float, 2>;

// Wheel commands for forward motion with a turn, to the left for positive `turn`. Scaled so that no command exceeds ±1.
Wheels steer(float forward, float turn) {
    Wheels wheels{forward - turn, forward + turn};
    const float fastest = std::max({1.0f, std::fabs(wheels[0]), std::fabs(wheels[1])});
    return {wheels[0] / fastest, wheels[1] / fastest};
}

// Wheel commands towards a point. Speed falls with the cosine of the angle to it, 0 beyond 90 degrees.
Wheels steer_to(const mechanics::Motion& motion, vec2 goal, float speed) {
    const vec2 way = goal - motion.position;
    const float aside = maths::wrap_angle(maths::arctangent2(way.y, way.x) - motion.heading);
    const float forward = std::max(0.0f, maths::cosine(aside)) * speed;
    return steer(forward, std::clamp(aside, -0.6f, 0.6f));
}

Wheels follow_path(const WorldData& s, std::size_t row, std::int32_t& next) {
    constexpr float arrived = 0.6f;  // m
    const auto& path = s.scene->kinds[s.kind(row)].waypoints;
    if (path.empty()) return {};
    if (static_cast<std::size_t>(next) >= path.size()) next = 0;
    const Waypoint& goal = path[static_cast<std::size_t>(next)];
    if (maths::distance({goal.x, goal.y}, s.vehicles.motion[row].position) < arrived)
        next = static_cast<std::int32_t>((static_cast<std::size_t>(next) + 1) % path.size());
    return steer_to(s.vehicles.motion[row], {goal.x, goal.y}, 0.6f);
}

// Random motion: a new turn every 45 ticks, towards the middle near an edge, backwards with a turn at a wall or
// obstacle.
Wheels wander(const WorldData& s, std::size_t row) {
    constexpr std::uint64_t ticks_a_whim = 45;
    constexpr float rim = 1.5f;  // m
    const VehicleId id = s.vehicles.id[row];
    const mechanics::Motion& motion = s.vehicles.motion[row];
    const std::uint64_t stream = (s.tick / ticks_a_whim << 32U) | static_cast<std::uint32_t>(id);
    maths::Random chance{s.seed ^ 0x77616e646572ULL, stream};
    const float whim = chance.uniform(-0.3f, 0.3f);
    const Touch wall{id, no_vehicle};
    if (std::binary_search(s.touching.begin(), s.touching.end(), wall)) return steer(-0.4f, whim > 0 ? 0.5f : -0.5f);
    const vec2 soon = motion.position + motion.ahead * rim;
    const Arena& arena = s.scene->arena;
    const bool leaving = !is_inside(arena, soon, 0.5f);
    if (leaving && arena.edge != Boundary::torus) return steer_to(motion, {0, 0}, 0.4f);
    return steer(0.5f, whim);
}

void think_with_brain(const WorldData& s, std::size_t row, const std::vector<float>& sensed,
                      std::vector<float>& neurons, Wheels& motor) {
    const Vehicles& v = s.vehicles;
    const Brain& brain = v.brain[row]->flat;
    think(brain, {sensed.data() + v.first_sensed[row], s.compiled(row).sensors.size()},
          {neurons.data() + v.first_neuron[row], static_cast<std::size_t>(brain.state_size())}, motor);
}

// A neuron that reads other neurons is a tick behind them. While no tick comes, its value agrees with theirs.
void settle_neurons(const WorldData& s, const std::vector<float>& sensed, std::vector<float>& neurons) {
    const Vehicles& v = s.vehicles;
    for (std::size_t row = 0; row < v.size(); ++row) {
        const Brain& brain = v.brain[row]->flat;
        if (v.driver[row] != Driver::brain || brain.neuron_count() <= 2) continue;
        settle_forward(brain, {sensed.data() + v.first_sensed[row], s.compiled(row).sensors.size()},
                       {neurons.data() + v.first_neuron[row], static_cast<std::size_t>(brain.state_size())});
    }
}

// All drivers. `sensed`, `neurons`, `motor` and `waypoint` are arrays of all vehicles.
void run_drivers(const WorldData& s, const std::vector<float>& sensed, std::vector<float>& neurons,
                 std::vector<Wheels>& motor, std::vector<std::int32_t>& waypoint) {
    const Vehicles& v = s.vehicles;
    for (std::size_t row = 0; row < v.size(); ++row) {
        switch (v.driver[row]) {
            case Driver::brain:
                think_with_brain(s, row, sensed, neurons, motor[row]);
                break;
            case Driver::manual:
                motor[row] = v.steered[row];
                break;
            case Driver::path:
                motor[row] = follow_path(s, row, waypoint[row]);
                break;
            case Driver::wander:
                motor[row] = wander(s, row);
                break;
            case Driver::parked:
                motor[row] = {};
                break;
        }
    }
}

}  // namespace

void think(WorldData& s) {
    Vehicles& v = s.vehicles;
    run_drivers(s, v.sensed, v.neurons, v.motor, v.waypoint);
}

Preview preview(const WorldData& s) {
    Preview next{sense_preview(s), s.vehicles.neurons, s.vehicles.motor};
    std::vector<std::int32_t> waypoint = s.vehicles.waypoint;
    settle_neurons(s, next.sensed, next.neurons);
    run_drivers(s, next.sensed, next.neurons, next.motor, waypoint);
    return next;
}

}  // namespace braitenlab::world
