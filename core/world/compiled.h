// Brains and kinds of a scene with precomputed constants. Inside core/world and core/io only.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/brain/brain.h"
#include "core/sensing/compiled_sensor.h"

namespace braitenlab::world {

// A brain as edited and as flat arrays. Immutable: an edit creates a new one.
struct CompiledBrain {
    BrainGraph graph;
    Brain flat;
    Role role = Role::none;  // the kind's; for Role::wiring the role that the graph implies
};
using SharedBrain = std::shared_ptr<const CompiledBrain>;

// A wheel with the constants of its laws precomputed.
struct CompiledWheel {
    maths::vec2 at;  // contact point in the vehicle's frame
    Motor motor = Motor::none;
    float drive_mass = 0;      // kg, moved by the motor
    float lateral_mass = 0;    // kg, stopped by the grip
    float carried_mass = 0;    // kg, slowed down by the drag
    float friction_limit = 0;  // N, on a floor of grip 1
    float area = 0;            // m^2
};

struct CompiledKind {
    std::vector<sensing::CompiledSensor> sensors;
    std::vector<CompiledWheel> wheels;
    std::array<float, 2> driven_radius{1, 1};             // m, of the left and the right driven wheel
    float top_speed = 0, motor_force = 0, dead_band = 0;  // m/s, N, share of the full command
    float friction_spread = 0;                            // see Body
    float mass = 0;                                       // kg
    bool has_noise = false;                               // a sensor draws random numbers
    bool has_gain_spread = false;
    std::uint32_t delayed_readings = 0;
    float reach = 0;  // m, radius of free space round the origin: slightly more than half the diagonal
    std::vector<std::string> sensor_names;
};

// A kind with the sensors of a vehicle that has its own. Immutable: an edit creates a new one.
struct OwnDesign {
    Kind kind;
    CompiledKind compiled;
};
using SharedDesign = std::shared_ptr<const OwnDesign>;

// Null if the sensors are those of the kind.
SharedDesign own_design(const Kind&, const std::vector<Sensor>&);

// Fails as compile() does.
Result<SharedBrain> compile_brain(const BrainGraph&, const Kind&);

// Number of readings that one vehicle of the kind keeps: held samples and ring buffers.
std::uint32_t delayed_readings(const Kind&);

// Compiles a kind without its brain.
CompiledKind compile_kind(const Kind&);

}  // namespace braitenlab::world
