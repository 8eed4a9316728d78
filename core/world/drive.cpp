// Wheel forces: sums motor force, grip and drag of each wheel at its contact point and the push of zones into one force
// and one torque per vehicle.
#include "core/maths/angle.h"
#include "core/maths/random.h"
#include "core/mechanics/wheel.h"
#include "core/world/world_data.h"

namespace braitenlab::world {

using maths::vec2;

namespace {

// Force of one wheel in N, in the vehicle's frame, whose axes are those of every wheel: wheels do not steer.
vec2 wheel_force(const CompiledKind& kind, const CompiledWheel& wheel, const FloorConstants& floor, vec2 velocity,
                 float command) {
    const vec2 drag = mechanics::rolling_drag(velocity, floor.friction, wheel.area, wheel.carried_mass, tick_seconds);
    if (wheel.friction_limit == 0) return drag;  // a castor rolls in every direction
    vec2 tyre{0, mechanics::lateral_grip(velocity.y, wheel.lateral_mass, tick_seconds)};
    if (wheel.motor != Motor::none)
        tyre.x = mechanics::motor_force(command * kind.top_speed, velocity.x, wheel.drive_mass, kind.motor_force,
                                        tick_seconds);
    return mechanics::limit_to_friction(tyre, wheel.friction_limit * floor.grip) + drag;
}

// Random numbers for the friction of one vehicle's wheels: the same at every tick and for every spread.
maths::Random friction_for(const WorldData& s, std::size_t row) {
    return {s.parts_seed ^ 0x66726963ULL, static_cast<std::uint32_t>(s.vehicles.id[row])};
}

std::array<float, 2> commands_of(const Vehicles& v, std::size_t row, float dead_band) {
    return {mechanics::motor_command(v.motor[row][0], dead_band, v.gain[row][0]),
            mechanics::motor_command(v.motor[row][1], dead_band, v.gain[row][1])};
}

void drive_vehicle(WorldData& s, std::size_t row) {
    Vehicles& v = s.vehicles;
    const CompiledKind& kind = s.kinds[s.kind(row)];
    const mechanics::Motion& m = v.motion[row];
    const std::array<float, 2> command = commands_of(v, row, kind.dead_band);
    // Wheels resist the push of a zone: their forces are computed for the velocity after one tick of the push alone.
    const vec2 push = s.environment.ground.push_at(m.position, kind.mass);
    const vec2 pushed = m.velocity + push * (tick_seconds / kind.mass);
    const vec2 velocity = maths::rotate(pushed, {m.ahead.x, -m.ahead.y});  // in the vehicle's frame
    FloorConstants floor = s.environment.ground.plain;
    vec2 force;
    float torque = 0;
    maths::Random friction;
    if (kind.friction_spread > 0) friction = friction_for(s, row);
    for (const CompiledWheel& wheel : kind.wheels) {
        if (s.environment.ground.has_surfaces || kind.friction_spread > 0)
            floor = s.environment.ground.floor_at(m.position + maths::rotate(wheel.at, m.ahead));
        if (kind.friction_spread > 0) {
            const float share = 1 + kind.friction_spread * friction.uniform(-1, 1);
            floor.friction *= share, floor.grip *= share;
        }
        const vec2 at_wheel{velocity.x - m.angular_velocity * wheel.at.y, velocity.y + m.angular_velocity * wheel.at.x};
        const auto side = static_cast<std::size_t>(wheel.motor == Motor::right ? 1 : 0);
        const vec2 f = wheel_force(kind, wheel, floor, at_wheel, command[side]);
        force += f;
        torque += maths::cross(wheel.at, f);
        if (wheel.motor != Motor::none) {
            float& angle = v.wheel_angle[row][side];
            angle = maths::wrap_angle(angle + at_wheel.x * tick_seconds / kind.driven_radius[side]);
        }
    }
    s.physics.push(row, maths::rotate(force, m.ahead) + push, torque);
}

}  // namespace

void drive(WorldData& s) {
    for (std::size_t row = 0; row < s.vehicles.size(); ++row) drive_vehicle(s, row);
}

}  // namespace braitenlab::world
