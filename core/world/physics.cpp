#include "core/world/physics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include <box2d/box2d.h>

#include "core/brain/brain.h"
#include "core/maths/angle.h"
#include "core/mechanics/body.h"
#include "core/scene/arena.h"

namespace braitenlab::world {

namespace {

enum Category : std::uint16_t { chassis = 1, wheel = 2, environment = 4 };

constexpr float wall_thickness = 0.5f;  // m; bodies do not pass through it in one step

b2Vec2 to_box(maths::vec2 v) { return {v.x, v.y}; }
maths::vec2 from_box(b2Vec2 v) { return {v.x, v.y}; }

// True when the chassis covers the wheel seen from above: then every contact of the wheel is also one of the chassis.
bool is_covered(const Wheel& w, const Body& body) {
    const float x = std::abs(w.x) + w.radius, y = std::abs(w.y) + w.width / 2;
    return x <= body.length / 2 + b2_linearSlop && y <= body.width / 2 + b2_linearSlop;
}

// Box2D 2.4.1 fills a static table when a process creates its first contact, without a lock. This creates one, so that
// worlds can be stepped on several threads. Thread-safe: the static below is initialised once.
void fill_contact_table() {
    static const int contacts = [] {
        b2World world({0, 0});
        b2CircleShape shape;
        shape.m_radius = 1;
        b2BodyDef definition;
        definition.type = b2_dynamicBody;
        for (int body = 0; body < 2; ++body) world.CreateBody(&definition)->CreateFixture(&shape, 1);
        world.Step(tick_seconds, 1, 1);
        return world.GetContactCount();
    }();
    static_cast<void>(contacts);
}

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

// The search for the time of each impact costs about 5 % of a crowd's tick. A collision at most about doubles the speed
// that a vehicle reaches by its motors; the speed of bodies that zones or vehicles push is not bounded.
bool may_skip_an_impact(const Scene& scene) {
    const auto pushes = [](const Zone& z) { return z.pull != 0 || z.wind_x != 0 || z.wind_y != 0 || z.slope != 0; };
    if (std::any_of(scene.zones.begin(), scene.zones.end(), pushes)) return true;
    if (std::any_of(scene.obstacles.begin(), scene.obstacles.end(), [](const Obstacle& o) { return o.mass > 0; }))
        return true;
    float fastest = 0, thinnest = wall_thickness;
    for (const Kind& kind : scene.kinds) {
        fastest = std::max(fastest, kind.body.top_speed * voltage_share(kind.body));
        thinnest = std::min({thinnest, kind.body.length, kind.body.width});
    }
    return 2 * fastest * tick_seconds > thinnest / 4;
}

// Box2D reports contacts during a step; they are recorded here and evaluated after it.
struct Physics::Impl : b2ContactListener {
    b2World world{b2Vec2(0, 0)};
    std::vector<b2Body*> bodies;
    std::vector<b2Body*> obstacles;
    // Number of touching fixture pairs per touch, sorted; and its changes in the last step.
    struct Contacts {
        Touch touch;
        int count = 0;
    };
    std::vector<Contacts> contacts, changes;
    std::vector<Bump> struck;  // contacts of fixtures that began in the last step

    void BeginContact(b2Contact* contact) override {
        note(contact, 1);
        const Touch touch = touch_of(contact);
        if (touch.one == no_vehicle) return;
        b2WorldManifold points;
        contact->GetWorldManifold(&points);
        struck.push_back({touch.one, from_box(points.points[0]), touch.other});
    }
    void EndContact(b2Contact* contact) override { note(contact, -1); }
    void note(b2Contact* contact, int change) {
        if (const Touch touch = touch_of(contact); touch.one != no_vehicle) changes.push_back({touch, change});
    }

    static Touch touch_of(b2Contact* contact) {
        const VehicleId a = vehicle_of(contact->GetFixtureA()), b = vehicle_of(contact->GetFixtureB());
        if (a == no_vehicle || b == no_vehicle) return {std::max(a, b), no_vehicle};
        return {std::min(a, b), std::max(a, b)};
    }

    b2Body* add_block(const mechanics::Motion& motion, const std::vector<maths::vec2>& corners, float mass) {
        b2BodyDef body;
        body.type = mass > 0 ? b2_dynamicBody : b2_staticBody;
        body.position = to_box(motion.position);
        body.angle = motion.heading;
        body.linearVelocity = to_box(motion.velocity);
        body.angularVelocity = motion.angular_velocity;
        // No wheels: the floor brakes a pushed obstacle by damping.
        body.linearDamping = body.angularDamping = 3;
        std::array<b2Vec2, b2_maxPolygonVertices> points;
        for (std::size_t i = 0; i < corners.size(); ++i) points[i] = to_box(corners[i]);
        b2PolygonShape shape;
        shape.Set(points.data(), static_cast<int>(corners.size()));
        b2FixtureDef fixture;
        fill(fixture, shape, environment, chassis | wheel | environment);
        b2Body* made = world.CreateBody(&body);
        b2MassData mass_data;
        shape.ComputeMass(&mass_data, 1);
        if (mass > 0) fixture.density = mass / mass_data.mass;
        made->CreateFixture(&fixture);
        return made;
    }
    void add_box(maths::vec2 middle, float length, float width, float heading = 0) {
        const float l = length / 2, w = width / 2;
        add_block(mechanics::at_rest(middle, heading), {{-l, -w}, {l, -w}, {l, w}, {-l, w}}, 0);
    }
    void add_post(maths::vec2 middle, float radius) {
        b2BodyDef body;
        body.position = to_box(middle);
        b2CircleShape shape;
        shape.m_radius = radius;
        b2FixtureDef fixture;
        fill(fixture, shape, environment, chassis | wheel | environment);
        world.CreateBody(&body)->CreateFixture(&fixture);
    }

    // Applies the recorded changes to the counts of contacts.
    void settle() {
        if (changes.empty()) return;
        std::sort(changes.begin(), changes.end(),
                  [](const Contacts& a, const Contacts& b) { return a.touch < b.touch; });
        for (const Contacts& change : changes) {
            const auto at = std::lower_bound(contacts.begin(), contacts.end(), change.touch,
                                             [](const Contacts& c, const Touch& t) { return c.touch < t; });
            if (at == contacts.end() || at->touch != change.touch)
                contacts.insert(at, change);
            else
                at->count += change.count;
        }
        std::erase_if(contacts, [](const Contacts& c) { return c.count <= 0; });
        changes.clear();
    }
};

Physics::Physics(const Scene& scene, const std::vector<mechanics::Motion>& obstacles)
    : impl_(new Impl) {  // make_unique would fill Box2D's stack of 100 kB with zeros
    fill_contact_table();
    impl_->world.SetContactListener(impl_.get());
    impl_->world.SetContinuousPhysics(may_skip_an_impact(scene));
    impl_->world.SetAllowSleeping(false);  // the order of islands depends on Box2D's lists
    if (has_walls(scene.arena.edge) && scene.arena.round) {
        for (const WallBox& box : round_wall(scene.arena, wall_thickness))
            impl_->add_box(box.middle, box.length, wall_thickness, box.heading);
    } else if (has_walls(scene.arena.edge)) {
        const float w = scene.arena.width, h = scene.arena.height, t = wall_thickness;
        impl_->add_box({0, (h + t) / 2}, w + 2 * t, t);
        impl_->add_box({0, -(h + t) / 2}, w + 2 * t, t);
        impl_->add_box({(w + t) / 2, 0}, t, h);
        impl_->add_box({-(w + t) / 2, 0}, t, h);
    }
    for (std::size_t i = 0; i < scene.obstacles.size(); ++i)
        impl_->obstacles.push_back(
            impl_->add_block(obstacles[i], corners_of(scene.obstacles[i]), scene.obstacles[i].mass));
    for (const Source& source : scene.sources)
        if (source.solid) impl_->add_post({source.x, source.y}, source_radius(scene.arena));
}

Physics::~Physics() = default;
Physics::Physics(Physics&&) noexcept = default;
Physics& Physics::operator=(Physics&&) noexcept = default;

void Physics::add(std::size_t row, VehicleId id, const Body& body, const mechanics::Motion& motion) {
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.position = to_box(motion.position);
    definition.angle = motion.heading;
    definition.linearVelocity = to_box(motion.velocity);
    definition.angularVelocity = motion.angular_velocity;
    definition.userData.pointer = static_cast<std::uintptr_t>(id) + 1;  // 0 is the environment
    b2Body* made = impl_->world.CreateBody(&definition);

    b2PolygonShape shape;
    b2FixtureDef fixture;
    shape.SetAsBox(body.length / 2, body.width / 2);
    fill(fixture, shape, chassis, chassis | environment);
    made->CreateFixture(&fixture);
    for (const Wheel& w : body.wheels) {
        if (is_covered(w, body)) continue;
        shape.SetAsBox(w.radius, w.width / 2, {w.x, w.y}, 0);
        fill(fixture, shape, wheel, environment);
        made->CreateFixture(&fixture);
    }
    b2MassData mass;
    mass.mass = body.mass;
    mass.center.SetZero();
    mass.I = mechanics::plate_inertia(body.mass, body.length, body.width);
    made->SetMassData(&mass);
    if (row >= impl_->bodies.size()) impl_->bodies.resize(row + 1);
    impl_->bodies[row] = made;
}

void Physics::remove(const std::vector<std::size_t>& rows) {
    for (const std::size_t row : rows) {
        impl_->world.DestroyBody(impl_->bodies[row]);  // reports the contacts it ends
        impl_->bodies[row] = nullptr;
    }
    std::erase(impl_->bodies, nullptr);
    impl_->settle();
}

void Physics::set_pose(std::size_t row, const Pose& pose) {
    b2Body* body = impl_->bodies[row];
    body->SetTransform({pose.x, pose.y}, pose.heading);
    body->SetLinearVelocity({0, 0});
    body->SetAngularVelocity(0);
}

void Physics::set_position(std::size_t row, maths::vec2 to) {
    impl_->bodies[row]->SetTransform(to_box(to), impl_->bodies[row]->GetAngle());
}

void Physics::set_obstacle_position(std::size_t index, maths::vec2 to) {
    impl_->obstacles[index]->SetTransform(to_box(to), impl_->obstacles[index]->GetAngle());
}

namespace {

// Box2D adds up the angle of a body, and the steps of a float become coarse as it grows. So it is turned back by whole
// turns as soon as it leaves −π..π. Contacts and their impulses stay.
mechanics::Motion motion_of(b2Body& body) {
    if (std::fabs(body.GetAngle()) > maths::pi)
        body.SetTransform(body.GetPosition(), maths::wrap_angle(body.GetAngle()));
    const b2Rot& turn = body.GetTransform().q;
    return {from_box(body.GetPosition()),
            {turn.c, turn.s},
            from_box(body.GetLinearVelocity()),
            body.GetAngularVelocity(),
            body.GetAngle()};
}

}  // namespace

mechanics::Motion Physics::motion(std::size_t row) { return motion_of(*impl_->bodies[row]); }
mechanics::Motion Physics::obstacle(std::size_t index) { return motion_of(*impl_->obstacles[index]); }

void Physics::push(std::size_t row, maths::vec2 force, float torque) {
    // In a large crowd the next bodies are far away in memory.
    [[maybe_unused]] constexpr std::size_t ahead = 6;
#ifdef __GNUC__
    if (row + ahead < impl_->bodies.size()) __builtin_prefetch(impl_->bodies[row + ahead], 1);
#endif
    impl_->bodies[row]->ApplyForceToCenter(to_box(force), true);
    impl_->bodies[row]->ApplyTorque(torque, true);
}

namespace {

bool by_vehicle(const Bump& a, const Bump& b) {
    return std::tuple(a.vehicle, a.other, a.at.x, a.at.y) < std::tuple(b.vehicle, b.other, b.at.x, b.at.y);
}

}  // namespace

void Physics::find_strikes(const std::vector<Touch>& begun, std::vector<Bump>& strikes) const {
    strikes.clear();
    std::vector<Bump>& struck = impl_->struck;
    std::sort(struck.begin(), struck.end(), by_vehicle);
    for (const Touch& touch : begun) {
        const auto at =
            std::lower_bound(struck.begin(), struck.end(), touch, [](const Bump& bump, const Touch& wanted) {
                return Touch{bump.vehicle, bump.other} < wanted;
            });
        if (at != struck.end() && Touch{at->vehicle, at->other} == touch) strikes.push_back(*at);
    }
}

void Physics::find_bumps(std::vector<Bump>& bumps) const {
    bumps.clear();
    for (b2Contact* contact = impl_->world.GetContactList(); contact; contact = contact->GetNext()) {
        const Touch touch = Impl::touch_of(contact);
        if (!contact->IsTouching() || touch.one == no_vehicle || touch.other != no_vehicle) continue;
        b2WorldManifold points;
        contact->GetWorldManifold(&points);
        for (int i = 0; i < contact->GetManifold()->pointCount; ++i)
            bumps.push_back({touch.one, from_box(points.points[i])});
    }
    std::sort(bumps.begin(), bumps.end(), by_vehicle);  // sums must not depend on the order of Box2D's list
    std::size_t merged = 0;
    for (std::size_t i = 0; i < bumps.size();) {
        Bump all{bumps[i].vehicle, {}};
        float points = 0;
        for (; i < bumps.size() && bumps[i].vehicle == all.vehicle; ++i) all.at += bumps[i].at, ++points;
        bumps[merged++] = {all.vehicle, all.at / points};
    }
    bumps.resize(merged);
}

void Physics::step(std::vector<Touch>& touching, std::vector<Touch>& begun) {
    constexpr int velocity_iterations = 6, position_iterations = 2;
    impl_->struck.clear();
    impl_->world.Step(tick_seconds, velocity_iterations, position_iterations);
    impl_->settle();
    begun.clear();
    auto before = touching.begin();
    for (const Impl::Contacts& now : impl_->contacts) {
        while (before != touching.end() && *before < now.touch) ++before;
        if (before == touching.end() || *before != now.touch) begun.push_back(now.touch);
    }
    touching.clear();
    for (const Impl::Contacts& now : impl_->contacts) touching.push_back(now.touch);
}

}  // namespace braitenlab::world

// Box2D rotates bodies by the C library's sinf and cosf. These differ in the last bit between platforms, and glibc's
// also between processors with and without fused multiply-add: enough for two runs to diverge. So Box2D gets the
// functions of core/maths/portable.h under these names. Where programs are linked as ELF, a function of the program
// takes precedence over a library's function of the same name, for a shared Box2D too. Elsewhere Box2D is linked
// statically with the linker's --wrap option (see core/CMakeLists.txt), which renames sinf to __wrap_sinf in all
// objects. Visual C++ has no such option: there a run may differ in the last bits.
#ifndef _MSC_VER
#if defined(BRAITENLAB_WRAP_SINE)
#define BRAITENLAB_LIBM(name) __wrap_##name
#elif defined(__ELF__)
#define BRAITENLAB_LIBM(name) name
#else
#error "Box2D's sinf and cosf are not replaced here: link it with --wrap and define BRAITENLAB_WRAP_SINE"
#endif

namespace {

// core/maths is accurate up to this angle; beyond it, and for infinities and NaN, double precision is rounded.
bool is_accurate(float angle) { return std::fabs(angle) < 1e5f; }

}  // namespace

extern "C" {

float BRAITENLAB_LIBM(sinf)(float angle) noexcept {
    return is_accurate(angle) ? braitenlab::maths::sine(angle)
                              : static_cast<float>(std::sin(static_cast<double>(angle)));
}
float BRAITENLAB_LIBM(cosf)(float angle) noexcept {
    return is_accurate(angle) ? braitenlab::maths::cosine(angle)
                              : static_cast<float>(std::cos(static_cast<double>(angle)));
}
void BRAITENLAB_LIBM(sincosf)(float angle, float* sine, float* cosine) noexcept {
    if (is_accurate(angle)) {
        const auto both = braitenlab::maths::sine_cosine(angle);
        *sine = both.sine, *cosine = both.cosine;
    } else {
        *sine = static_cast<float>(std::sin(static_cast<double>(angle)));
        *cosine = static_cast<float>(std::cos(static_cast<double>(angle)));
    }
}

}  // extern "C"

#undef BRAITENLAB_LIBM

// Box2D's clock for profiles, which it reads seven times a step or more: a fifth of the tick of two vehicles. This one
// stands still and takes precedence in the same way; cmake/debian_sources.cmake leaves out Box2D's own.
b2Timer::b2Timer() = default;
void b2Timer::Reset() {}
float b2Timer::GetMilliseconds() const { return 0; }
#endif
