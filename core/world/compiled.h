// A scene's designs with everything worked out that no tick changes.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/brain/brain.h"
#include "core/world/eye.h"

namespace braitenlab {

// A brain as it was edited, and as it thinks. Never changed once made: an edit makes a new one.
struct Design {
    BrainGraph graph;
    Brain brain;
    Role role = Role::none;  // the kind's; where that is `wiring`, what the graph makes of it
};
using SharedDesign = std::shared_ptr<const Design>;

// A wheel with its laws' constants worked out.
struct CompiledWheel {
    maths::vec2 at;  // contact point in the vehicle's frame
    Motor motor = Motor::none;
    float drive_mass = 0;      // kg, what the motor has to move
    float lateral_mass = 0;    // kg, what its grip has to stop
    float carried_mass = 0;    // kg, what its drag has to slow down
    float friction_limit = 0;  // N, on a floor of grip 1
    float area = 0;            // m^2
};

struct CompiledKind {
    std::vector<Eye> eyes;
    std::vector<CompiledWheel> wheels;
    std::array<float, 2> driven_radius{1, 1};  // m, of the left and the right wheel: how fast they spin
    float top_speed = 0, motor_force = 0, dead_band = 0;
    float mass = 0;
    bool has_noise = false;
    std::uint32_t late_readings = 0;
    float reach = 0;  // m round its origin that it wants for itself: a little more than half its diagonal
    std::vector<std::string> sensor_names;
};

// Fails as compile() does.
Result<SharedDesign> make_design(const BrainGraph&, const Kind&);

// How many readings the sensors of one vehicle of the kind hold back.
std::uint32_t late_readings(const Kind&);

// Everything but the brain.
CompiledKind compile_kind(const Kind&);

}  // namespace braitenlab
