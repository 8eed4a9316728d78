#include "core/world/physics.h"

#include <algorithm>
#include <array>

#include <box2d/box2d.h>

#include "core/brain/brain.h"
#include "core/maths/angle.h"

namespace braitenlab {

namespace {

enum Category : std::uint16_t { chassis = 1, wheel = 2, environment = 4 };

constexpr float wall_thickness = 0.5f;  // m; thick enough that nothing passes within a step

b2Vec2 to_box(maths::vec2 v) { return {v.x, v.y}; }
maths::vec2 from_box(b2Vec2 v) { return {v.x, v.y}; }

VehicleId vehicle_of(b2Fixture* fixture) {
    const std::uintptr_t stored = fixture->GetBody()->GetUserData().pointer;
    return stored == 0 ? no_vehicle : static_cast<VehicleId>(stored - 1);
}

void fill(b2FixtureDef& definition, const b2Shape& shape, Category category, std::uint16_t collides_with) {
    definition.shape = &shape;
    definition.friction = 0.2f;
    definition.restitution = 0.1f;
    definition.density = 0;  // masses are set as data
    definition.filter.categoryBits = category;
    definition.filter.maskBits = collides_with;
}

}  // namespace

// Box2D reports contacts in the middle of a step; they are only noted here and acted on after it.
struct Physics::Box : b2ContactListener {
    b2World world{b2Vec2(0, 0)};
    std::vector<b2Body*> bodies;
    std::vector<Touch> begun, ended;

    void BeginContact(b2Contact* contact) override {
        if (const Touch touch = touch_of(contact); touch.one != no_vehicle) begun.push_back(touch);
    }
    void EndContact(b2Contact* contact) override {
        if (const Touch touch = touch_of(contact); touch.other != no_vehicle) ended.push_back(touch);
    }

    static Touch touch_of(b2Contact* contact) {
        const VehicleId a = vehicle_of(contact->GetFixtureA()), b = vehicle_of(contact->GetFixtureB());
        if (a == no_vehicle || b == no_vehicle) return {std::max(a, b), no_vehicle};
        return {std::min(a, b), std::max(a, b)};
    }

    void add_block(const Pose& pose, float length, float width) {
        b2BodyDef body;
        body.position.Set(pose.x, pose.y);
        body.angle = pose.heading;
        b2PolygonShape shape;
        shape.SetAsBox(length / 2, width / 2);
        b2FixtureDef fixture;
        fill(fixture, shape, environment, chassis | wheel);
        world.CreateBody(&body)->CreateFixture(&fixture);
    }

    // What ended leaves the touching pairs, what began joins them; a pair's wheels touch nothing but the environment,
    // so a pair of vehicles has one contact at most.
    void settle(std::vector<Touch>& touching, std::vector<Touch>& begun_sorted) {
        std::sort(begun.begin(), begun.end());
        begun.erase(std::unique(begun.begin(), begun.end()), begun.end());
        begun_sorted = begun;
        std::erase_if(touching,
                      [this](const Touch& t) { return std::find(ended.begin(), ended.end(), t) != ended.end(); });
        for (const Touch& touch : begun)
            if (touch.other != no_vehicle) touching.push_back(touch);
        std::sort(touching.begin(), touching.end());
        touching.erase(std::unique(touching.begin(), touching.end()), touching.end());
        begun.clear();
        ended.clear();
    }
};

Physics::Physics(const Scene& scene) : box_(std::make_unique<Box>()) {
    box_->world.SetContactListener(box_.get());
    box_->world.SetAllowSleeping(false);  // sleeping islands depend on Box2D's own lists
    if (scene.arena.edge == Edge::wall) {
        const float w = scene.arena.width, h = scene.arena.height, t = wall_thickness;
        box_->add_block({0, (h + t) / 2, 0}, w + 2 * t, t);
        box_->add_block({0, -(h + t) / 2, 0}, w + 2 * t, t);
        box_->add_block({(w + t) / 2, 0, 0}, t, h);
        box_->add_block({-(w + t) / 2, 0, 0}, t, h);
    }
    for (const Obstacle& o : scene.obstacles) box_->add_block({o.x, o.y, o.heading}, o.length, o.width);
}

Physics::~Physics() = default;

void Physics::add(VehicleId id, const Body& body, const Pose& pose) {
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.position.Set(pose.x, pose.y);
    definition.angle = pose.heading;
    definition.userData.pointer = static_cast<std::uintptr_t>(id) + 1;  // 0 is the environment
    b2Body* made = box_->world.CreateBody(&definition);

    b2PolygonShape shape;
    b2FixtureDef fixture;
    shape.SetAsBox(body.length / 2, body.width / 2);
    fill(fixture, shape, chassis, chassis | environment);
    made->CreateFixture(&fixture);
    for (const Wheel& w : body.wheels) {
        shape.SetAsBox(w.radius, w.width / 2, {w.x, w.y}, 0);
        fill(fixture, shape, wheel, environment);
        made->CreateFixture(&fixture);
    }
    b2MassData mass;
    mass.mass = body.mass;
    mass.center.SetZero();
    mass.I = body.mass * (body.length * body.length + body.width * body.width) / 12;  // of a uniform plate
    made->SetMassData(&mass);
    box_->bodies.push_back(made);
}

void Physics::remove(std::size_t row) {
    box_->world.DestroyBody(box_->bodies[row]);  // reports the contacts it ends
    box_->bodies.erase(box_->bodies.begin() + static_cast<std::ptrdiff_t>(row));
    std::erase_if(touching_, [this](const Touch& t) {
        return std::find(box_->ended.begin(), box_->ended.end(), t) != box_->ended.end();
    });
    box_->ended.clear();
}

void Physics::place(std::size_t row, const Pose& pose) {
    b2Body* body = box_->bodies[row];
    body->SetTransform({pose.x, pose.y}, pose.heading);
    body->SetLinearVelocity({0, 0});
    body->SetAngularVelocity(0);
}

Motion Physics::motion(std::size_t row) const {
    const b2Body* body = box_->bodies[row];
    const b2Rot& turn = body->GetTransform().q;
    return {from_box(body->GetPosition()),
            {turn.c, turn.s},
            from_box(body->GetLinearVelocity()),
            body->GetAngularVelocity()};
}

float Physics::heading(std::size_t row) const { return box_->bodies[row]->GetAngle(); }

void Physics::push(std::size_t row, maths::vec2 force, float torque) {
    box_->bodies[row]->ApplyForceToCenter(to_box(force), true);
    box_->bodies[row]->ApplyTorque(torque, true);
}

void Physics::step() {
    constexpr int velocity_iterations = 6, position_iterations = 2;
    box_->world.Step(tick_seconds, velocity_iterations, position_iterations);
    box_->settle(touching_, begun_);
}

}  // namespace braitenlab
