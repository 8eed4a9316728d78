#include "core/world/compiled.h"

#include "core/brain/recogniser.h"
#include "core/maths/angle.h"
#include "core/mechanics/wheel.h"

namespace braitenlab {

namespace {

// Whoever is drawn to others hunts them, whoever is driven away by them is hunted.
Role role_by_wiring(const BrainGraph& graph) {
    const int drawn = attraction(recognise(graph));
    return drawn > 0 ? Role::predator : drawn < 0 ? Role::prey : Role::none;
}

}  // namespace

Result<SharedDesign> make_design(const BrainGraph& graph, const Kind& kind) {
    auto brain = compile(graph, sensor_names(kind));
    if (!brain) return brain.error();
    const Role role = kind.role == Role::wiring ? role_by_wiring(graph) : kind.role;
    return std::make_shared<const Design>(Design{graph, std::move(*brain), role});
}

CompiledKind compile_kind(const Kind& kind, const Arena& arena) {
    CompiledKind compiled;
    for (const Sensor& sensor : kind.sensors) compiled.eyes.emplace_back(sensor);
    float driven = 0, gripping = 0;  // shares of the load on wheels with a motor, with grip
    for (const Wheel& w : kind.body.wheels) {
        if (w.motor != Motor::none) driven += w.load;
        if (w.grip > 0) gripping += w.load;
    }
    for (const Wheel& w : kind.body.wheels) {
        CompiledWheel c;
        c.at = {w.x, w.y};
        c.motor = w.motor;
        c.drive_mass = driven > 0 ? kind.body.mass * w.load / driven : 0;
        c.lateral_mass = gripping > 0 ? kind.body.mass * w.load / gripping : 0;
        c.friction_limit = w.grip * arena.grip * w.load * kind.body.mass * mechanics::gravity;
        c.drag = arena.friction * w.area;
        compiled.wheels.push_back(c);
        if (w.motor != Motor::none) compiled.driven_radius[w.motor == Motor::left ? 0 : 1] = w.radius;
    }
    compiled.top_speed = kind.body.top_speed;
    compiled.motor_force = kind.body.motor_force;
    compiled.sensor_names = sensor_names(kind);
    return compiled;
}

std::vector<Outline> outlines_of(const Scene& scene) {
    std::vector<Outline> outlines;
    if (scene.arena.edge == Edge::wall) {
        const float w = scene.arena.width / 2, h = scene.arena.height / 2;
        const std::array<maths::vec2, 4> corner{{{-w, -h}, {w, -h}, {w, h}, {-w, h}}};
        for (std::size_t i = 0; i < 4; ++i) outlines.push_back({{corner[i], corner[(i + 1) % 4]}});
    }
    for (const Obstacle& o : scene.obstacles) {
        const maths::vec2 ahead = maths::direction(o.heading), middle{o.x, o.y};
        Outline outline;
        for (const maths::vec2 corner : corners_of(o)) outline.corners.push_back(middle + maths::rotate(corner, ahead));
        outlines.push_back(std::move(outline));
    }
    return outlines;
}

}  // namespace braitenlab
