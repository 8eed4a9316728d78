// The lower limit: the same bodies on bare Box2D, wheel forces summed per vehicle, sensing by a grid over flat
// arrays. No kinds, no brains as graphs, no events, no snapshots. Any simulation of this crowd with Box2D takes at
// least this time; the world is compared with it.
#pragma once

#include <array>
#include <vector>

#include <box2d/box2d.h>

#include "core/brain/brain.h"
#include "core/maths/angle.h"
#include "tests/bench/crowd.h"

namespace braitenlab::bench {

class Limit {
public:
    Limit(const Scene& scene, const CrowdState& crowd) : hunts_(crowd.hunts), sensors_(scene, eye_range) {
        world_.SetAllowSleeping(false);
        world_.SetContinuousPhysics(false);
        const float w = scene.arena.width, h = scene.arena.height, t = 0.5f;
        add_wall({0, (h + t) / 2}, w + 2 * t, t), add_wall({0, -(h + t) / 2}, w + 2 * t, t);
        add_wall({(w + t) / 2, 0}, t, h), add_wall({-(w + t) / 2, 0}, t, h);
        for (const mechanics::Motion& motion : crowd.motion) add(scene.kinds[0].body, motion);
        for (const Wheel& wheel : scene.kinds[0].body.wheels) drag_ += wheel.area * scene.arena.friction;
    }

    void step() {
        motion_.resize(bodies_.size());
        for (std::size_t row = 0; row < bodies_.size(); ++row) motion_[row] = motion_of(*bodies_[row]);
        sensors_.look(motion_, hunts_, sensed_);
        for (std::size_t row = 0; row < bodies_.size(); ++row) drive(row);
        world_.Step(tick_seconds, 6, 2);
    }

private:
    enum Category : std::uint16_t { chassis = 1, wheels = 2, environment = 4 };

    static mechanics::Motion motion_of(const b2Body& body) {
        const b2Rot& turn = body.GetTransform().q;
        const b2Vec2 place = body.GetPosition(), velocity = body.GetLinearVelocity();
        return {{place.x, place.y}, {turn.c, turn.s}, {velocity.x, velocity.y}, body.GetAngularVelocity(), 0};
    }

    // The two driven wheels of the standard vehicle, 0.3 m aside, and all wheels' drag: what friction allows of a push
    // towards the commanded speed and of a grip that stops sliding.
    void drive(std::size_t row) {
        constexpr float aside = 0.3f, mass = 10, top_speed = 3, strongest = 24, limit = 0.9f * 0.4f * mass * 9.81f;
        const mechanics::Motion& m = motion_[row];
        const auto told = motors(hunts_[row] ? hunter : hunted, sensed_[row]);
        const float along = maths::dot(m.velocity, m.ahead), across = maths::cross(m.ahead, m.velocity);
        float force_along = -drag_ * along, force_across = -drag_ * across, torque = 0;
        for (int side = 0; side < 2; ++side) {
            const float y = side == 0 ? aside : -aside, speed = along - m.angular_velocity * y;
            const float wanted = (told[static_cast<std::size_t>(side)] * top_speed - speed) * (mass / 2) / tick_seconds;
            float x_force = std::clamp(wanted, -strongest, strongest), y_force = -across * (mass / 2) / tick_seconds;
            const float size = std::sqrt(x_force * x_force + y_force * y_force);
            if (size > limit) x_force *= limit / size, y_force *= limit / size;
            force_along += x_force, force_across += y_force, torque -= y * x_force;
        }
        const maths::vec2 force = maths::rotate({force_along, force_across}, m.ahead);
        bodies_[row]->ApplyForceToCenter({force.x, force.y}, true);
        bodies_[row]->ApplyTorque(torque, true);
    }

    static void attach(b2Body& body, const b2Shape& shape, Category category, std::uint16_t collides_with) {
        b2FixtureDef fixture;
        fixture.shape = &shape;
        fixture.friction = 0.2f, fixture.restitution = 0.1f, fixture.density = 0;
        fixture.filter.categoryBits = category, fixture.filter.maskBits = collides_with;
        body.CreateFixture(&fixture);
    }

    void add_wall(b2Vec2 middle, float length, float width) {
        b2BodyDef definition;
        definition.position = middle;
        b2PolygonShape box;
        box.SetAsBox(length / 2, width / 2);
        attach(*world_.CreateBody(&definition), box, environment, chassis | wheels | environment);
    }

    void add(const Body& design, const mechanics::Motion& motion) {
        b2BodyDef definition;
        definition.type = b2_dynamicBody;
        definition.position = {motion.position.x, motion.position.y};
        definition.angle = motion.heading;
        definition.linearVelocity = {motion.velocity.x, motion.velocity.y};
        definition.angularVelocity = motion.angular_velocity;
        b2Body* body = world_.CreateBody(&definition);
        b2PolygonShape box;
        box.SetAsBox(design.length / 2, design.width / 2);
        attach(*body, box, chassis, chassis | environment);
        b2MassData mass;
        mass.mass = design.mass;
        mass.center.SetZero();
        mass.I = design.mass * (design.length * design.length + design.width * design.width) / 12;
        body->SetMassData(&mass);
        bodies_.push_back(body);
    }

    b2World world_{b2Vec2(0, 0)};
    float drag_ = 0;
    std::vector<b2Body*> bodies_;
    std::vector<char> hunts_;
    CrowdEyes sensors_;
    std::vector<mechanics::Motion> motion_;
    std::vector<std::array<float, 2>> sensed_;
};

}  // namespace braitenlab::bench
