// Wheels push bodies: each wheel's motor, grip and drag at its contact point, summed into one force and one torque.
#include "core/maths/angle.h"
#include "core/mechanics/wheel.h"
#include "core/world/state.h"

namespace braitenlab {

using maths::vec2;

namespace {

// The force of one wheel in the vehicle's frame. All wheels roll straight ahead, so the frames have the same axes.
vec2 wheel_force(const CompiledKind& kind, const CompiledWheel& wheel, vec2 velocity,
                 const std::array<float, 2>& motor) {
    const vec2 drag = {-wheel.drag * velocity.x, -wheel.drag * velocity.y};
    if (wheel.friction_limit == 0) return drag;  // a castor: rolls whichever way it is pulled
    vec2 tyre{0, mechanics::lateral_grip(velocity.y, wheel.lateral_mass, tick_seconds)};
    if (wheel.motor != Motor::none) {
        const float command = motor[wheel.motor == Motor::left ? 0 : 1];
        tyre.x = mechanics::motor_force(command * kind.top_speed, velocity.x, wheel.drive_mass, kind.motor_force,
                                        tick_seconds);
    }
    return mechanics::limit_to_friction(tyre, wheel.friction_limit) + drag;
}

}  // namespace

void drive(WorldState& s) {
    Vehicles& v = s.vehicles;
    for (std::size_t row = 0; row < v.size(); ++row) {
        const CompiledKind& kind = s.kinds[static_cast<std::size_t>(v.kind[row])];
        const Motion& m = v.motion[row];
        const vec2 velocity = maths::rotate(m.velocity, {m.ahead.x, -m.ahead.y});  // in the vehicle's frame
        vec2 force;
        float torque = 0;
        for (const CompiledWheel& wheel : kind.wheels) {
            const vec2 at_wheel{velocity.x - m.turning * wheel.at.y, velocity.y + m.turning * wheel.at.x};
            const vec2 f = wheel_force(kind, wheel, at_wheel, v.motor[row]);
            force += f;
            torque += maths::cross(wheel.at, f);
            if (wheel.motor != Motor::none) {
                const auto side = static_cast<std::size_t>(wheel.motor == Motor::left ? 0 : 1);
                float& angle = v.wheel_angle[row][side];
                angle = maths::wrap_angle(angle + at_wheel.x * tick_seconds / kind.driven_radius[side]);
            }
        }
        s.physics.push(row, maths::rotate(force, m.ahead), torque);
    }
}

}  // namespace braitenlab
