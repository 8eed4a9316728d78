// Forces at a wheel's contact point. All are in the wheel's frame: x along its rolling direction, y to its left. Speeds
// in m/s, forces in N, masses in kg.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/maths/vec.h"

namespace braitenlab::mechanics {

inline constexpr float gravity = 9.81f;  // m/s^2, standard gravity rounded; for the load on the wheels

// Force that brings the mass moved by a wheel to the wanted speed within one tick of dt seconds, limited to ±strongest.
// It does not overshoot, so the speed does not oscillate.
inline float motor_force(float wanted_speed, float speed, float moved_mass, float strongest, float dt) {
    return std::clamp((wanted_speed - speed) * moved_mass / dt, -strongest, strongest);
}

// Force that stops the sideways motion of a wheel within one tick of dt seconds.
inline float lateral_grip(float lateral_speed, float moved_mass, float dt) { return -lateral_speed * moved_mass / dt; }

// Coulomb friction: scales the force (both components together) down to the limit (N), which is mu times the load.
inline maths::vec2 limit_to_friction(maths::vec2 force, float limit) {
    const float size = maths::length(force);
    return size > limit ? force * (limit / size) : force;
}

// Rolling resistance: proportional to the floor's friction constant (N·s/m per m^2), the contact area (m^2) and the
// speed. Computed implicitly from the speed after dt seconds, so that it never reverses the motion. Without other
// forces a body of mass m stops after exactly v·m/(friction·area) metres.
constexpr maths::vec2 rolling_drag(maths::vec2 velocity, float friction, float area, float carried_mass, float dt) {
    const float drag = friction * area;  // N·s/m
    return carried_mass > 0 ? velocity * (-drag / (1 + drag * dt / carried_mass)) : maths::vec2{};
}

// Effective command of a motor for a command −1..1: 0 in the dead band, else the command times the motor's gain.
inline float motor_command(float command, float dead_band, float gain) {
    return std::fabs(command) < dead_band ? 0 : command * gain;
}

// Differential drive: conversion between the speeds of two wheels and the forward speed and turning rate (rad/s,
// counter-clockwise). `track` is the distance (m) between their contact points.
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
