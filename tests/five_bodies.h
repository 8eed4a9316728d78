// The reference for the single rigid body of a vehicle: a chassis and its wheels as separate bodies,
// joined by revolute joints that are locked at 0, with the same wheel laws applied to each wheel's body.
//
// For tests and benchmarks only. The constants of the laws are computed here again from the vehicle's data, so that a
// mistake in the simulation is detected.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <box2d/box2d.h>

#include "core/brain/brain.h"
#include "core/maths/angle.h"
#include "core/mechanics/motion.h"
#include "core/mechanics/wheel.h"
#include "core/scene/scene.h"
#include "core/world/snapshot.h"

namespace braitenlab::tests {

class FiveBodies {
public:
    // An empty arena on its plain floor, with walls where its edge has them.
    explicit FiveBodies(const Arena& arena) : floor_(arena) {
        if (arena.edge != Boundary::wall) return;
        const float w = arena.width, h = arena.height, t = 0.5f;
        add_wall({0, (h + t) / 2}, w + 2 * t, t), add_wall({0, -(h + t) / 2}, w + 2 * t, t);
        add_wall({(w + t) / 2, 0}, t, h), add_wall({-(w + t) / 2, 0}, t, h);
    }

    std::size_t size() const { return vehicles_.size(); }

    // Vehicles are placed in rows, in the order of their addition.
    void add(const Body& design, const Pose& pose) {
        float on_wheels = 0, driven = 0, gripping = 0;
        for (const Wheel& w : design.wheels) {
            on_wheels += wheel_share;
            driven += w.motor != Motor::none ? w.load : 0;
            gripping += w.grip > 0 ? w.load : 0;
        }
        Vehicle made;
        made.top_speed = design.top_speed;
        made.motor_force = design.motor_force;
        made.chassis = add_body(pose, {}, {.mass = design.mass * (1 - on_wheels)});
        b2PolygonShape plate;
        plate.SetAsBox(design.length / 2, design.width / 2);
        attach(*made.chassis, plate, chassis, chassis | environment);
        // The whole has its middle at the origin and turns like the uniform plate that it represents.
        float inertia = design.mass * (design.length * design.length + design.width * design.width) / 12;
        maths::vec2 moment;
        for (const Wheel& w : design.wheels) {
            const float mass = design.mass * wheel_share;
            const WheelBody wheel{
                .body = add_body(pose, {w.x, w.y}, {.mass = mass, .inertia = mass * square(w.radius) / 3}),
                .motor = w.motor,
                .drive_mass = driven > 0 ? design.mass * w.load / driven : 0,
                .lateral_mass = gripping > 0 ? design.mass * w.load / gripping : 0,
                .friction_limit = w.grip * floor_.grip * w.load * design.mass * mechanics::gravity,
                .carried_mass = design.mass * w.load,
                .area = w.area};
            b2PolygonShape box;
            box.SetAsBox(w.radius, w.width / 2);
            attach(*wheel.body, box, wheels, environment);
            lock(*made.chassis, *wheel.body, {w.x, w.y});
            inertia -= mass * (square(w.radius) / 3 + w.x * w.x + w.y * w.y);
            moment += maths::vec2{w.x, w.y} * mass;
            made.wheels.push_back(wheel);
        }
        const float rest = design.mass * (1 - on_wheels);
        const b2Vec2 middle{-moment.x / rest, -moment.y / rest};
        set_mass(*made.chassis, {.mass = rest, .inertia = inertia - rest * middle.LengthSquared()}, middle);
        vehicles_.push_back(made);
    }

    // The commands of the two motors, −1..1, until the next call.
    void command(std::size_t row, float left, float right) { vehicles_[row].command = {left, right}; }

    // One tick: every wheel's law, then the physics.
    void step() {
        for (const Vehicle& vehicle : vehicles_)
            for (const WheelBody& wheel : vehicle.wheels) drive(vehicle, wheel);
        constexpr int velocity_iterations = 6, position_iterations = 2;  // as for the one body
        world_.Step(tick_seconds, velocity_iterations, position_iterations);
    }

    // Of the vehicle's origin, which is the frame of its chassis.
    mechanics::Motion motion(std::size_t row) const {
        const b2Body& body = *vehicles_[row].chassis;
        const b2Rot& turn = body.GetTransform().q;
        const b2Vec2 place = body.GetPosition(), velocity = body.GetLinearVelocityFromLocalPoint({0, 0});
        return {
            {place.x, place.y}, {turn.c, turn.s}, {velocity.x, velocity.y}, body.GetAngularVelocity(), body.GetAngle()};
    }

private:
    enum Category : std::uint16_t { chassis = 1, wheels = 2, environment = 4 };
    static constexpr float wheel_share = 0.02f;  // of the vehicle's mass, for each wheel

    struct Mass {
        float mass = 0, inertia = 1;
    };
    struct WheelBody {
        b2Body* body = nullptr;
        Motor motor = Motor::none;
        float drive_mass = 0, lateral_mass = 0, friction_limit = 0, carried_mass = 0, area = 0;
    };
    struct Vehicle {
        b2Body* chassis = nullptr;
        std::vector<WheelBody> wheels;
        float top_speed = 0, motor_force = 0;
        std::array<float, 2> command{};
    };

    static float square(float x) { return x * x; }

    static void set_mass(b2Body& body, const Mass& mass, b2Vec2 middle) {
        b2MassData data;
        data.mass = mass.mass;
        data.center = middle;
        data.I = mass.inertia + mass.mass * middle.LengthSquared();  // Box2D expects it about the origin of the body
        body.SetMassData(&data);
    }

    b2Body* add_body(const Pose& vehicle, maths::vec2 at, const Mass& mass) {
        const maths::vec2 turned = maths::rotate(at, maths::direction(vehicle.heading));
        b2BodyDef definition;
        definition.type = b2_dynamicBody;
        definition.position.Set(vehicle.x + turned.x, vehicle.y + turned.y);
        definition.angle = vehicle.heading;
        definition.allowSleep = false;
        b2Body* made = world_.CreateBody(&definition);
        set_mass(*made, mass, {0, 0});
        return made;
    }

    void add_wall(b2Vec2 middle, float length, float width) {
        b2BodyDef definition;
        definition.position = middle;
        b2PolygonShape box;
        box.SetAsBox(length / 2, width / 2);
        attach(*world_.CreateBody(&definition), box, environment, chassis | wheels);
    }

    // Without density: masses are set as data, and Box2D does not change them.
    static void attach(b2Body& body, const b2Shape& shape, Category category, std::uint16_t collides_with) {
        b2MassData before;
        body.GetMassData(&before);
        b2FixtureDef definition;
        definition.shape = &shape;
        definition.friction = 0.2f;
        definition.restitution = 0.1f;
        definition.filter.categoryBits = category;
        definition.filter.maskBits = collides_with;
        body.CreateFixture(&definition);
        body.SetMassData(&before);
    }

    void lock(b2Body& chassis_body, b2Body& wheel, b2Vec2 at) {
        b2RevoluteJointDef joint;
        joint.bodyA = &chassis_body;
        joint.bodyB = &wheel;
        joint.localAnchorA = at;
        joint.localAnchorB.SetZero();
        joint.enableLimit = true;
        joint.lowerAngle = joint.upperAngle = 0;
        world_.CreateJoint(&joint);
    }

    void drive(const Vehicle& vehicle, const WheelBody& wheel) const {
        // A wheel slides with the velocity of its point of the chassis. The velocity of its body still points the
        // way of the tick before, outwards by turning² · arm · dt, and a grip that stops the vehicle's mass, not the
        // wheel's mass only, would treat that as a slide.
        const b2Vec2 at_axle = vehicle.chassis->GetLinearVelocityFromWorldPoint(wheel.body->GetPosition());
        const b2Vec2 in_frame = wheel.body->GetLocalVector(at_axle);
        const maths::vec2 velocity{in_frame.x, in_frame.y};
        maths::vec2 tyre{0, mechanics::lateral_grip(velocity.y, wheel.lateral_mass, tick_seconds)};
        if (wheel.motor != Motor::none) {
            const float told = vehicle.command[wheel.motor == Motor::left ? 0 : 1] * vehicle.top_speed;
            tyre.x = mechanics::motor_force(told, velocity.x, wheel.drive_mass, vehicle.motor_force, tick_seconds);
        }
        const maths::vec2 force =
            mechanics::limit_to_friction(tyre, wheel.friction_limit) +
            mechanics::rolling_drag(velocity, floor_.friction, wheel.area, wheel.carried_mass, tick_seconds);
        wheel.body->ApplyForceToCenter(wheel.body->GetWorldVector({force.x, force.y}), true);
    }

    Arena floor_;
    b2World world_{b2Vec2(0, 0)};
    std::vector<Vehicle> vehicles_;
};

}  // namespace braitenlab::tests
