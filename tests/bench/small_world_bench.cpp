// The time of short runs with few vehicles, of which maps, predictions, breeding and grading consist: their ticks
// beside a loop of bare Box2D, their start, and whole tasks. Keyframes are included.
#include <vector>

#include <benchmark/benchmark.h>
#include <box2d/box2d.h>

#include "core/lesson/exercise_file.h"
#include "core/lesson/grade.h"
#include "core/scene/scene_file.h"
#include "core/world/tick.h"
#include "tests/core/scenes.h"

namespace braitenlab::bench {
namespace {

constexpr std::size_t ticks_a_run = 3600;  // each benchmark of ticks repeats the same minute

// Predators and prey with feelers for walls; none dies.
Scene company(int vehicles) {
    Scene scene = *load_scene(BRAITENLAB_SOURCE "/exercises/scenes/predator-prey.toml");
    scene.ecology.population = vehicles;
    scene.ecology.inactivity = scene.ecology.drain = scene.ecology.bite = 0;
    return scene;
}

Scene one_and_lamp() {
    Scene scene = tests::alone({.LR = 1.5f, .RL = 1.5f, .LM = 0.3f, .RM = 0.25f});
    scene.sources.push_back({.name = "lamp", .x = 8, .y = 2});
    return scene;
}

void run_ticks(benchmark::State& state, const Scene& scene) {
    const World begin = std::move(*World::create(scene, 1));
    World world = begin.fork();
    std::size_t ticks = 0;
    for (auto _ : state) {
        if (++ticks % ticks_a_run == 0) {
            state.PauseTiming();
            world = begin.fork();
            state.ResumeTiming();
        }
        world.step();
    }
}

void BM_Duel(benchmark::State& state) { run_ticks(state, company(2)); }
BENCHMARK(BM_Duel);

void BM_OneAndLamp(benchmark::State& state) { run_ticks(state, one_and_lamp()); }
BENCHMARK(BM_OneAndLamp);

void BM_Twenty(benchmark::State& state) { run_ticks(state, company(20)); }
BENCHMARK(BM_Twenty);

// The motion of all vehicles in each tick of a run.
std::vector<std::vector<mechanics::Motion>> motion_of_run(const Scene& scene) {
    std::vector<std::vector<mechanics::Motion>> run;
    world::WorldData s{world::State(*World::create(scene, 1)->checkpoint().keyframe)};
    while (run.size() < ticks_a_run) {
        run.push_back(s.vehicles.motion);
        world::tick(s, [](world::TickPart) {});
    }
    return run;
}

// The standard vehicle's body on bare Box2D. Its castors are below the chassis and have no fixtures.
b2Body* add_body(b2World& world, const Body& body) {
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    b2Body* made = world.CreateBody(&definition);
    b2PolygonShape box;
    b2FixtureDef fixture;
    fixture.shape = &box;
    fixture.friction = 0.2f, fixture.restitution = 0.1f;
    fixture.filter.categoryBits = 1, fixture.filter.maskBits = 1 | 4;
    box.SetAsBox(body.length / 2, body.width / 2);
    made->CreateFixture(&fixture);
    fixture.filter.categoryBits = 2, fixture.filter.maskBits = 4;
    for (const Wheel& wheel : body.wheels) {
        if (wheel.motor == Motor::none) continue;
        box.SetAsBox(wheel.radius, wheel.width / 2, {wheel.x, wheel.y}, 0);
        made->CreateFixture(&fixture);
    }
    b2MassData mass;
    mass.mass = body.mass;
    mass.center.SetZero();
    mass.I = body.mass * (body.length * body.length + body.width * body.width) / 12;
    made->SetMassData(&mass);
    return made;
}

void add_walls(b2World& world, const Arena& arena) {
    const float w = arena.width, h = arena.height, t = 0.5f;
    const auto add = [&](b2Vec2 middle, float length, float width) {
        b2BodyDef definition;
        definition.position = middle;
        b2PolygonShape box;
        box.SetAsBox(length / 2, width / 2);
        b2FixtureDef fixture;
        fixture.shape = &box;
        fixture.filter.categoryBits = 4;
        world.CreateBody(&definition)->CreateFixture(&fixture);
    };
    add({0, (h + t) / 2}, w + 2 * t, t), add({0, -(h + t) / 2}, w + 2 * t, t);
    add({(w + t) / 2, 0}, t, h), add({-(w + t) / 2, 0}, t, h);
}

// The steps of Box2D alone: the same bodies and walls. Their velocities are set to those of the recorded run, once a
// second their poses too.
void run_bare(benchmark::State& state, const Scene& scene) {
    const auto run = motion_of_run(scene);
    b2World world({0, 0});
    world.SetAllowSleeping(false);
    world.SetContinuousPhysics(false);
    add_walls(world, scene.arena);
    std::vector<b2Body*> bodies;
    for (std::size_t row = 0; row < run[0].size(); ++row) bodies.push_back(add_body(world, scene.kinds[0].body));
    std::size_t tick = 0;
    for (auto _ : state) {
        const auto& now = run[tick];
        for (std::size_t row = 0; row < bodies.size(); ++row) {
            const mechanics::Motion& m = now[row];
            if (tick % 60 == 0) bodies[row]->SetTransform({m.position.x, m.position.y}, m.heading);
            bodies[row]->SetLinearVelocity({m.velocity.x, m.velocity.y});
            bodies[row]->SetAngularVelocity(m.angular_velocity);
        }
        world.Step(tick_seconds, 6, 2);
        if (++tick == run.size()) tick = 0;
    }
}

void BM_DuelOfBareBox2D(benchmark::State& state) { run_bare(state, company(2)); }
BENCHMARK(BM_DuelOfBareBox2D);

void BM_OneOfBareBox2D(benchmark::State& state) { run_bare(state, one_and_lamp()); }
BENCHMARK(BM_OneOfBareBox2D);

void BM_TwentyOfBareBox2D(benchmark::State& state) { run_bare(state, company(20)); }
BENCHMARK(BM_TwentyOfBareBox2D);

void BM_Create(benchmark::State& state) {
    const Scene scene = company(2);
    for (auto _ : state) benchmark::DoNotOptimize(World::create(scene, 1));
}
BENCHMARK(BM_Create)->Unit(benchmark::kMicrosecond);

// The ten starts of exercise 5 with its solution.
void BM_Grade(benchmark::State& state) {
    const auto exercise = load_exercise(BRAITENLAB_SOURCE "/exercises/guided/05-aggressor.toml");
    if (!exercise) return state.SkipWithError("the exercise cannot be read");
    const Submission solution = with_solution(*exercise);
    for (auto _ : state) benchmark::DoNotOptimize(grade(*exercise, solution).count);
}
BENCHMARK(BM_Grade)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace braitenlab::bench
