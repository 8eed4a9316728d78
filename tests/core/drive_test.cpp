// Motion of a vehicle on several surfaces, compared with the formulas.
#include <array>
#include <cmath>

#include "core/maths/random.h"
#include "core/mechanics/body.h"
#include "tests/core/runs.h"
#include "tests/core/scenes.h"

namespace braitenlab::tests::drive_test {
namespace {

using namespace world;
using maths::vec2;
using tests::after;
using tests::alone;
using tests::begin_with;
using tests::look;
using tests::make;

const std::array<Surface, 4> surfaces{Surface::none, Surface::ice, Surface::carpet, Surface::sand};

// An arena with one surface.
Scene on(Surface surface, Scene scene) {
    scene.zones.push_back(
        {.name = "all", .length = scene.arena.width, .width = scene.arena.height, .surface = surface});
    return scene;
}

// N·s/m, of all four wheels of the standard vehicle together.
float whole_drag(const FloorConstants& floor) {
    float area = 0;
    for (const Wheel& wheel : Body{}.wheels) area += wheel.area;
    return floor.friction * area;
}

// Only rolling and grip: a vehicle without motors and with an initial velocity.
Scene motorless() {
    Scene scene = alone({});
    scene.arena.width = scene.arena.height = 2000;
    for (Wheel& wheel : scene.kinds[0].body.wheels) wheel.motor = Motor::none;
    return scene;
}

World set_in_motion(const Scene& scene, vec2 velocity, float turning = 0) {
    return begin_with(scene, [&](State& moment) {
        moment.vehicles.motion[0].velocity = velocity;
        moment.vehicles.motion[0].angular_velocity = turning;
    });
}

TEST(World, CoastingEndsAtTheDistanceOfTheFormulaOnEverySurface) {
    for (const Surface surface : surfaces) {
        const float speed = 3, drag = whole_drag(floor_constants({}, surface));
        World world = set_in_motion(on(surface, motorless()), {speed, 0});
        const Snapshot end = after(world, 12.0 * Body{}.mass / static_cast<double>(drag));
        EXPECT_NEAR(end.vehicles[0].x, speed * Body{}.mass / drag, 0.01f * speed * Body{}.mass / drag)
            << static_cast<int>(surface);
        EXPECT_NEAR(end.vehicles[0].y, 0, 1e-3f);
    }
}

TEST(World, CoastingIsFiveTimesAsLongOnIceAndAThirdAsLongOnCarpet) {
    const auto floor = [](Surface surface) { return whole_drag(floor_constants({}, surface)); };
    EXPECT_FLOAT_EQ(floor(Surface::none) / floor(Surface::ice), 5);
    EXPECT_FLOAT_EQ(floor(Surface::carpet) / floor(Surface::none), 3);
}

TEST(World, TheTopSpeedIsReachedAgainstTheDragOfEverySurface) {
    const Body body;
    for (const Surface surface : surfaces) {
        const FloorConstants floor = floor_constants({}, surface);
        Scene scene = on(surface, alone({.LM = 1, .RM = 1}));
        const float grip = floor.grip * 0.9f * 0.8f * body.mass * mechanics::gravity;
        const float strongest = std::min(2 * body.motor_force, grip), drag = whole_drag(floor);
        // Motors correct their speed once per tick, so the error is at most the drag of one tick.
        const float reached = std::min(body.top_speed / (1 + drag / body.mass / 60), strongest / drag);
        World world = make(scene);
        EXPECT_NEAR(after(world, 20).vehicles[0].speed, reached, 0.01f * reached) << static_cast<int>(surface);
    }
}

TEST(World, TheTopSpeedOfAWeakMotorIsWhereDragEqualsItsForce) {
    Scene scene = on(Surface::sand, alone({.LM = 1, .RM = 1}));
    scene.kinds[0].body.motor_force = 8;
    World world = make(scene);
    const float drag = whole_drag(floor_constants({}, Surface::sand));
    const float reached = 16 / drag * (1 + drag / Body{}.mass / 60);  // the drag acts one tick after the motor
    EXPECT_NEAR(after(world, 15).vehicles[0].speed, reached, 0.01f * reached);
}

TEST(World, TheTurningRadiusIsThatOfADifferentialDriveAtTheOrigin) {
    for (const auto& [left, right] : {std::pair{0.2f, 0.4f}, {0.4f, 0.3f}, {0.1f, 0.3f}, {-0.1f, 0.3f}}) {
        World world = make(alone({.LM = left, .RM = right}));
        after(world, 3);
        // Three points of the circle, half a second apart, and the circle through them.
        const VehicleView p = look(world).vehicles[0], q = after(world, 0.5).vehicles[0],
                          r = after(world, 0.5).vehicles[0];
        const vec2 a{p.x, p.y}, b{q.x, q.y}, c{r.x, r.y};
        const float radius = maths::distance(a, b) * maths::distance(b, c) * maths::distance(c, a) /
                             (2 * std::fabs(maths::cross(b - a, c - a)));
        const float wanted = std::fabs(0.6f / 2 * (right + left) / (right - left));
        EXPECT_NEAR(radius, wanted, 0.05f * wanted) << left << ' ' << right;
    }
}

TEST(World, AVehicleTurnsAboutTheMiddleOfItsAxleWhereverThatIs) {
    // The axle of a Thymio is 2.5 cm behind the middle of a hull of 11 cm; here at the size of the standard vehicle.
    Scene scene = alone({.LM = -0.1f, .RM = 0.1f});
    for (Wheel& wheel : scene.kinds[0].body.wheels)
        if (wheel.motor != Motor::none) wheel.x = -0.25f;
    World world = make(scene);
    const auto axle = [&](const VehicleView& v) { return vec2{v.x, v.y} - 0.25f * maths::direction(v.heading); };
    after(world, 1);
    const vec2 before = axle(look(world).vehicles[0]);
    vec2 farthest{};
    for (int i = 0; i < 40; ++i) {
        const VehicleView now = after(world, 0.1).vehicles[0];
        EXPECT_LT(maths::distance(axle(now), before), 0.02f) << i;
        farthest.x = std::max(farthest.x, std::fabs(now.x - before.x));
    }
    EXPECT_NEAR(farthest.x, 0.25f, 0.02f) << "the middle of the chassis goes round it";
}

TEST(World, TopSpeedAndForceOfTheMotorsAreProportionalToTheirVoltage) {
    Scene scene = alone({.LM = 1, .RM = 1});
    Body& body = scene.kinds[0].body;
    const auto speed_after = [&](double seconds) {
        World world = make(scene);
        return after(world, seconds).vehicles[0].speed;
    };
    const float top = speed_after(5), start = speed_after(0.1);
    body.nominal_voltage = 9;
    EXPECT_EQ(speed_after(5), top) << "without a voltage of its own it has the nominal one";
    body.voltage = 9;
    EXPECT_EQ(speed_after(5), top);
    body.voltage = 6;
    EXPECT_NEAR(speed_after(5), top * 2 / 3, 0.02f * top);
    EXPECT_NEAR(speed_after(0.1), start * 2 / 3, 0.02f * start) << "the force is smaller, too";
    body.voltage = 61;
    EXPECT_FALSE(World::create(scene, 1));
}

float kinetic_energy(const Body& body, const mechanics::Motion& m) {
    const float inertia = mechanics::plate_inertia(body.mass, body.length, body.width);
    return body.mass / 2 * maths::dot(m.velocity, m.velocity) + inertia / 2 * m.angular_velocity * m.angular_velocity;
}

// A body with random values in their ranges. The simulation must be stable for all of them.
Body any_body(maths::Random& chance) {
    Body body;
    const auto log_uniform = [&](float low, float high) {
        return low * maths::exponential(chance.uniform(0, std::log(high / low)));
    };
    body.length = log_uniform(0.05f, 5);
    body.width = log_uniform(0.05f, 5);
    body.mass = log_uniform(0.05f, 1000);
    body.motor_force = log_uniform(0.01f, 10000);
    body.wheels.clear();
    const int count = 1 + static_cast<int>(chance.next() % 6);
    for (int i = 0; i < count; ++i) {
        Wheel wheel;
        wheel.x = chance.uniform(-10, 10);
        wheel.y = chance.uniform(-10, 10);
        wheel.motor = static_cast<Motor>(chance.next() % 3);
        wheel.grip = chance.next() % 2 ? chance.uniform(0, 2) : 0;
        wheel.area = log_uniform(0.0001f, 1);
        wheel.load = 1.0f / static_cast<float>(count);
        body.wheels.push_back(wheel);
    }
    return body;
}

TEST(World, FrictionNeverAddsEnergyForAnyBodyFloorOrMotion) {
    maths::Random chance{11, 3};
    for (int round = 0; round < 200; ++round) {
        Scene scene = motorless();
        scene.arena.friction = round % 3 == 0 ? 1000 : chance.uniform(0, 100);
        scene.arena.grip = chance.uniform(0, 2);
        // Motors with the command 0 brake; this is friction too.
        if (round % 4 != 0) scene.kinds[0].body = any_body(chance);
        if (round % 5 == 0) scene.kinds[0].body.friction_spread = 0.9f;
        const vec2 velocity{chance.uniform(-5, 5), chance.uniform(-5, 5)};
        World world = set_in_motion(on(surfaces[chance.next() % 4], scene), velocity, chance.uniform(-6, 6));
        Snapshot before = look(world);
        // Snapshot values are not rounded: the energy is computed from every tick.
        float energy = INFINITY;
        for (int tick = 0; tick < 120; ++tick) {
            const Snapshot now = after(world, 1.0 / 60);
            const VehicleView &a = before.vehicles[0], &b = now.vehicles[0];
            const mechanics::Motion motion{.velocity = vec2{b.x - a.x, b.y - a.y} * 60,
                                           .angular_velocity = maths::wrap_angle(b.heading - a.heading) * 60};
            const float left = kinetic_energy(scene.kinds[0].body, motion);
            EXPECT_LE(left, energy * 1.002f + 1e-3f * scene.kinds[0].body.mass)
                << "round " << round << " tick " << tick;
            if (left > energy * 1.002f + 1e-3f * scene.kinds[0].body.mass) return;
            energy = left;
            before = now;
        }
    }
}

TEST(World, AMotorMismatchTurnsAVehicleTheSameWayInEveryRunAndIsZeroByDefault) {
    Scene scene = alone({.LM = 0.6f, .RM = 0.6f});
    scene.kinds[0].body.mismatch = 0.1f;
    World one = make(scene, 4), same = make(scene, 4), other = make(scene, 5);
    const float aside = after(one, 5).vehicles[0].y;
    EXPECT_GT(std::fabs(aside), 0.05f);
    EXPECT_EQ(after(same, 5).vehicles[0].y, aside);
    EXPECT_NE(after(other, 5).vehicles[0].y, aside);
}

TEST(World, AFrictionSpreadMakesTheWheelsOfEachVehicleDiffer) {
    Scene scene = alone({.LM = 0.6f, .RM = 0.6f});
    scene.arena.friction = 900;  // more than the motors can drive at this speed
    scene.kinds[0].body.friction_spread = 0.5f;
    const auto aside = [&](std::uint64_t seed) {
        World world = make(scene, seed);
        return after(world, 5).vehicles[0].y;
    };
    EXPECT_GT(std::fabs(aside(4)), 0.01f);
    EXPECT_EQ(aside(4), aside(4));
    EXPECT_NE(aside(5), aside(4));
    scene.kinds[0].body.friction_spread = 0;
    EXPECT_NEAR(aside(4), 0, 1e-4f);
}

TEST(World, ADeadBandStopsAMotorBelowItAndHasNoEffectAboveIt) {
    Scene scene = alone({.LM = 0.19f, .RM = -0.19f});
    scene.kinds[0].body.dead_band = 0.2f;
    World still = make(scene);
    const Snapshot now = after(still, 2);
    EXPECT_EQ(now.vehicles[0].heading, 0);
    EXPECT_EQ(now.vehicles[0].motor[0], 0.19f);  // the command is unchanged
    scene.kinds[0].brain = make_graph({.LM = 0.21f, .RM = 0.21f});
    World moving = make(scene);
    EXPECT_NEAR(after(moving, 3).vehicles[0].speed, 0.21f * 3, 0.01f);
}

// One vehicle on a zone as large as the arena.
Scene under(Zone zone, const Scene& base) {
    Scene scene = base;
    zone.name = "all";
    zone.length = zone.width = 200;
    scene.zones.push_back(zone);
    return scene;
}

TEST(World, WindPushesARollingVehicleButNotABrakedOne) {
    Scene rolling = motorless();
    World free = make(under({.wind_x = 3}, rolling));
    // The speed of a body under a constant force and a drag that grows with speed.
    const float drag = whole_drag(floor_constants({}, Surface::none)), mass = Body{}.mass, seconds = 4;
    const float wanted = 3 / drag * (1 - std::exp(-drag / mass * seconds));
    EXPECT_NEAR(after(free, 4).vehicles[0].speed, wanted, 0.01f * wanted);
    World held = make(under({.wind_x = 3, .wind_y = 3}, alone({})));
    const VehicleView stands = after(held, 4).vehicles[0];
    EXPECT_NEAR(std::hypot(stands.x, stands.y), 0, 0.01f);
}

TEST(World, WindPushesAVehicleWithoutEnoughGrip) {
    World world = make(under({.surface = Surface::ice, .wind_x = 50}, alone({})));
    EXPECT_GT(after(world, 3).vehicles[0].x, 5);
}

TEST(World, ASlopePullsDownhillLikeGravity) {
    const float angle = maths::radians(10);
    World world = make(under({.heading = maths::pi / 2, .slope = angle}, [] {
        Scene scene = motorless();
        scene.starts[0].heading = maths::pi / 2;
        return scene;
    }()));
    const float drag = whole_drag(floor_constants({}, Surface::none)), mass = Body{}.mass, seconds = 2;
    const float pull = mass * mechanics::gravity * std::sin(angle);
    const float wanted = pull / drag * (1 - std::exp(-drag / mass * seconds));
    EXPECT_NEAR(after(world, 2).vehicles[0].speed, wanted, 0.01f * wanted);
}

TEST(World, APullActsTowardsItsCentreAndANegativePullRepels) {
    Scene scene = motorless();
    for (Wheel& wheel : scene.kinds[0].body.wheels) wheel.grip = 0;  // slides in every direction
    scene.starts[0].x = 3;
    scene.starts[0].y = -2;
    scene.arena.friction = 400;
    World drawn = make(under({.pull = 20}, scene));
    const VehicleView there = after(drawn, 60).vehicles[0];
    EXPECT_NEAR(std::hypot(there.x, there.y), 0, 0.05f);
    World driven = make(under({.pull = -20}, scene));
    const VehicleView away = after(driven, 5).vehicles[0];
    EXPECT_GT(std::hypot(away.x, away.y), 5);
    EXPECT_NEAR(away.x / away.y, -1.5f, 0.01f);
}

}  // namespace
}  // namespace braitenlab::tests::drive_test
