// The forces at a wheel's contact point, as plain functions. All are in the wheel's own frame: x along its rolling
// direction, y to its left; speeds in m/s, forces in N, masses in kg.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/maths/vec.h"

namespace braitenlab::mechanics {

inline constexpr float gravity = 9.81f;  // m/s^2, standard gravity rounded: it loads the wheels, nothing falls

// The force that brings the mass a wheel moves to the wanted speed within one tick of dt seconds, as far as the motor
// is strong enough. Never overshoots, so a wheel does not chatter about its speed.
inline float motor_force(float wanted_speed, float speed, float moved_mass, float strongest, float dt) {
    return std::clamp((wanted_speed - speed) * moved_mass / dt, -strongest, strongest);
}

// The force that stops a wheel from sliding sideways within one tick.
inline float lateral_grip(float lateral_speed, float moved_mass, float dt) { return -lateral_speed * moved_mass / dt; }

// Coulomb's limit: tyre and floor pass on at most mu times the load (in N), along and across taken together.
inline maths::vec2 limit_to_friction(maths::vec2 force, float limit) {
    const float size = maths::length(force);
    return size > limit ? force * (limit / size) : force;
}

// Rolling resistance: grows with the floor's friction constant (N·s/m per m^2), the contact area (m^2) and the speed.
// Stepped implicitly, by what the speed will be after dt seconds: no floor is so sticky that it throws a wheel back,
// and what nothing else brakes comes to rest after v·m/(friction·area) metres, to the formula's letter.
constexpr maths::vec2 rolling_drag(maths::vec2 velocity, float friction, float area, float carried_mass, float dt) {
    const float drag = friction * area;  // N·s/m
    return carried_mass > 0 ? velocity * (-drag / (1 + drag * dt / carried_mass)) : maths::vec2{};
}

// What a motor makes of its command, −1..1: nothing below its dead band, else what it is told times its own gain.
inline float motor_command(float command, float dead_band, float gain) {
    return std::fabs(command) < dead_band ? 0 : command * gain;
}

// Differential drive, both ways: forward speed and turning rate (rad/s, counter-clockwise) of a pair of wheels whose
// contact points are `track` metres apart.
struct Drive {
    float forward = 0, turning = 0;
};
constexpr Drive drive_of_wheels(float left, float right, float track) {
    return {(left + right) / 2, (right - left) / track};
}
struct WheelSpeeds {
    float left = 0, right = 0;
};
constexpr WheelSpeeds wheels_of_drive(Drive drive, float track) {
    return {drive.forward - drive.turning * track / 2, drive.forward + drive.turning * track / 2};
}

}  // namespace braitenlab::mechanics
