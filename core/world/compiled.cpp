#include "core/world/compiled.h"

#include <cmath>

#include "core/brain/recogniser.h"
#include "core/maths/angle.h"
#include "core/mechanics/body.h"
#include "core/mechanics/wheel.h"
#include "core/scene/sensor_pairs.h"

namespace braitenlab::world {

namespace {

// Attraction to other vehicles gives a predator, avoidance gives prey. Pairs that do not sense vehicles do not count.
Role role_by_wiring(const BrainGraph& graph, const Kind& kind) {
    for (const KindPair& pair : sensor_pairs(kind)) {
        const int drawn = senses_vehicles(pair.channel) ? attraction(recognise(graph, pair.sensors)) : 0;
        if (drawn != 0) return drawn > 0 ? Role::predator : Role::prey;
    }
    return Role::none;
}

// Largest fraction of the body's motion that the wheels cancel within one tick if each wheel stops its masses `along`
// and `across`. 1: the body stops. Above 1: the motion reverses. Above 2: it grows. Computed as the largest eigenvalue
// of the map from the body's velocity (forward, sideways, angular) to the change by the wheels' impulses, by power
// iteration.
float overshoot(const Body& body, const std::vector<CompiledWheel>& wheels, float CompiledWheel::*along,
                float CompiledWheel::*across) {
    const float inertia = mechanics::plate_inertia(body.mass, body.length, body.width);
    const maths::vec3 share{1 / std::sqrt(body.mass), 1 / std::sqrt(body.mass), 1 / std::sqrt(inertia)};
    maths::vec3 speeds{0.6f, 0.64f, 0.48f};  // a unit vector along no axis
    float largest = 0;
    for (int i = 0; i < 64; ++i) {
        const maths::vec3 own{speeds.x * share.x, speeds.y * share.y, speeds.z * share.z};
        maths::vec3 stopped;
        for (const CompiledWheel& w : wheels) {
            const float x = w.*along * (own.x - own.z * w.at.y), y = w.*across * (own.y + own.z * w.at.x);
            stopped += {x, y, y * w.at.x - x * w.at.y};
        }
        speeds = {stopped.x * share.x, stopped.y * share.y, stopped.z * share.z};
        largest = maths::length(speeds);
        speeds = maths::normalise(speeds);
    }
    return largest;
}

// Scales the masses down so that the overshoot is at most 1. Otherwise wheels far from the centre of a small body would
// make it oscillate.
void limit_overshoot(const Body& body, std::vector<CompiledWheel>& wheels, float CompiledWheel::*along,
                     float CompiledWheel::*across) {
    const float too_far = overshoot(body, wheels, along, across);
    if (too_far <= 1.001f) return;
    for (CompiledWheel& w : wheels) {
        w.*along /= too_far;
        if (along != across) w.*across /= too_far;
    }
}

}  // namespace

Result<SharedBrain> compile_brain(const BrainGraph& graph, const Kind& kind) {
    auto brain = compile(graph, sensor_names(kind));
    if (!brain) return brain.error();
    const Role role = kind.role == Role::wiring ? role_by_wiring(graph, kind) : kind.role;
    return std::make_shared<const CompiledBrain>(CompiledBrain{graph, std::move(*brain), role});
}

std::uint32_t delayed_readings(const Kind& kind) {
    std::uint32_t count = 0;
    for (const Sensor& sensor : kind.sensors) count += sensing::kept_readings(sensor);
    return count;
}

CompiledKind compile_kind(const Kind& kind) {
    const Body& body = kind.body;
    CompiledKind compiled;
    for (const Sensor& sensor : kind.sensors) {
        const sensing::CompiledSensor& made = compiled.sensors.emplace_back(sensor);
        compiled.has_noise = compiled.has_noise || made.noise > 0 || made.channel == Channel::random;
        compiled.has_gain_spread = compiled.has_gain_spread || made.gain_spread > 0;
    }
    compiled.delayed_readings = delayed_readings(kind);
    float driven = 0, gripping = 0;  // shares of the load on wheels with a motor and on wheels with grip
    for (const Wheel& w : body.wheels) {
        if (w.motor != Motor::none) driven += w.load;
        if (w.grip > 0) gripping += w.load;
    }
    for (const Wheel& w : body.wheels) {
        CompiledWheel c;
        c.at = {w.x, w.y};
        c.motor = w.motor;
        c.drive_mass = w.motor != Motor::none && driven > 0 ? body.mass * w.load / driven : 0;
        c.lateral_mass = w.grip > 0 && gripping > 0 ? body.mass * w.load / gripping : 0;
        c.carried_mass = body.mass * w.load;
        c.friction_limit = w.grip * w.load * body.mass * mechanics::gravity;
        c.area = w.area;
        compiled.wheels.push_back(c);
        if (w.motor != Motor::none) compiled.driven_radius[w.motor == Motor::left ? 0 : 1] = w.radius;
    }
    limit_overshoot(body, compiled.wheels, &CompiledWheel::drive_mass, &CompiledWheel::lateral_mass);
    limit_overshoot(body, compiled.wheels, &CompiledWheel::carried_mass, &CompiledWheel::carried_mass);
    compiled.top_speed = body.top_speed * voltage_share(body);
    compiled.motor_force = body.motor_force * voltage_share(body);
    compiled.dead_band = body.dead_band;
    compiled.friction_spread = body.friction_spread;
    compiled.mass = body.mass;
    compiled.reach = 1.065f * maths::length(maths::vec2{body.length, body.width} / 2);
    compiled.sensor_names = sensor_names(kind);
    return compiled;
}

SharedDesign own_design(const Kind& kind, const std::vector<Sensor>& sensors) {
    if (sensors == kind.sensors) return nullptr;
    Kind own = kind;
    own.sensors = sensors;
    CompiledKind compiled = compile_kind(own);
    return std::make_shared<const OwnDesign>(OwnDesign{std::move(own), std::move(compiled)});
}

}  // namespace braitenlab::world
