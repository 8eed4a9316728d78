// The time of a tick. Compare only figures of one run: they differ between machines, and on one machine from minute to
// minute.
#include <array>
#include <ctime>
#include <map>

#include <benchmark/benchmark.h>

#include "core/brain/brain.h"
#include "core/insight/map.h"
#include "core/insight/predict.h"
#include "core/insight/why.h"
#include "core/maths/random.h"
#include "core/scene/scene_file.h"
#include "core/world/tick.h"
#include "tests/bench/crowd.h"
#include "tests/bench/limit.h"
#include "tests/bench/own_memory.h"
#include "tests/five_bodies.h"

namespace braitenlab::bench {
namespace {

constexpr int warm_ticks = 120;  // after the start, in a dense crowd

// A crowd after its start, made once. It starts on a grid: a search for free positions takes longer than all the ticks.
const Checkpoint& crowd_of(int n) {
    static std::map<int, Checkpoint> made;
    Checkpoint& save = made[n];
    if (save.keyframe) return save;
    Scene scene = dense(n);
    scene.ecology.population = 0;
    WorldData s{State(*World::create(scene, 1)->checkpoint().keyframe)};
    maths::Random chance{1, 1};
    const int side = static_cast<int>(std::ceil(std::sqrt(static_cast<float>(n))));
    const float spacing = scene.arena.width / static_cast<float>(side);
    for (int i = 0; i < n; ++i) {
        const auto column = static_cast<float>(i % side), row = static_cast<float>(i / side);
        const Pose pose{(column + 0.5f) * spacing - scene.arena.width / 2,
                        (row + 0.5f) * spacing - scene.arena.height / 2, chance.uniform(-3, 3)};
        const int kind = static_cast<int>(chance.next() % 2);
        add_vehicle(s, kind, -1, s.next_id++, s.kind_brains[static_cast<std::size_t>(kind)], pose);
    }
    for (int i = 0; i < warm_ticks; ++i) tick(s, [](TickPart) {});
    save = {std::make_shared<const State>(s), s.tick, {}, s.tick};
    return save;
}

CrowdState state_in(const Checkpoint& save) {
    const State& state = *save.keyframe;
    CrowdState crowd;
    crowd.motion = state.vehicles.motion;
    for (const SharedBrain& brain : state.vehicles.brain) crowd.hunts.push_back(brain->role == Role::predator);
    return crowd;
}

// A crowd changes during a run: every benchmark repeats the same interval of simulated time.
constexpr int stretch = static_cast<int>(keyframe_ticks);

// Processor time, which does not depend on other programs on the machine.
double nanoseconds() { return static_cast<double>(std::clock()) * (1e9 / CLOCKS_PER_SEC); }

void sizes(benchmark::internal::Benchmark* b) {
    b->Arg(50)->Arg(1000)->Arg(5000)->Arg(20000)->Unit(benchmark::kMicrosecond);
}

// The same figure for every size: the time of one tick of one vehicle.
void count(benchmark::State& state) { state.SetItemsProcessed(state.iterations() * state.range(0)); }

void BM_WorldStep(benchmark::State& state) {
    const Checkpoint& save = crowd_of(static_cast<int>(state.range(0)));
    const std::int64_t before = bytes_in_use();
    WorldData world{State(*save.keyframe)};
    auto keyframe = begin_keyframe(world);
    tick(world, [](TickPart) {});
    const std::int64_t bytes = bytes_in_use() - before - static_cast<std::int64_t>(sizeof(b2World));  // without Box2D
    // Reading the clock takes as long as one or two vehicles, so the parts are timed only in some of the ticks.
    constexpr int timed_of = 8;
    std::array<double, 5> spent{};
    int ticks = 0, timed = 0;
    for (auto _ : state) {
        if (++ticks % stretch == 0) {
            state.PauseTiming();
            world = WorldData(State(*save.keyframe));
            state.ResumeTiming();
        }
        if (ticks % timed_of == 0) {
            ++timed;
            double last = nanoseconds();
            tick(world, [&](TickPart part) {
                const double now = nanoseconds();
                spent[static_cast<std::size_t>(part)] += now - last;
                last = now;
            });
        } else {
            tick(world, [](TickPart) {});
        }
        if (world.tick % keyframe_ticks == 0) keyframe = begin_keyframe(world);
    }
    constexpr std::array<const char*, 5> names{"sense_ns", "think_ns", "drive_ns", "physics_ns", "other_ns"};
    const double steps = static_cast<double>(timed) * static_cast<double>(state.range(0));
    for (std::size_t i = 0; i < names.size(); ++i) state.counters[names[i]] = spent[i] / steps;
    state.counters["bytes_per_vehicle"] = static_cast<double>(bytes) / static_cast<double>(state.range(0));
    count(state);
}
BENCHMARK(BM_WorldStep)->Apply(sizes)->Arg(10000);  // must run 60 ticks per second of processor time

void BM_Limit(benchmark::State& state) {
    const int n = static_cast<int>(state.range(0));
    const Scene scene = dense(n);
    const CrowdState crowd = state_in(crowd_of(n));
    auto limit = std::make_unique<Limit>(scene, crowd);
    int ticks = 0;
    for (auto _ : state) {
        if (++ticks % stretch == 0) {
            state.PauseTiming();
            limit = std::make_unique<Limit>(scene, crowd);
            state.ResumeTiming();
        }
        limit->step();
    }
    count(state);
}
BENCHMARK(BM_Limit)->Apply(sizes);

void look(benchmark::State& state, float farthest) {
    const Scene scene = dense(static_cast<int>(state.range(0)));
    const CrowdState crowd = state_in(crowd_of(static_cast<int>(state.range(0))));
    std::vector<std::array<float, 2>> sensed;
    CrowdEyes eyes(scene, farthest);
    for (auto _ : state) {
        eyes.look(crowd.motion, crowd.hunts, sensed);
        benchmark::DoNotOptimize(sensed.data());
    }
    count(state);
}

void BM_GridSense(benchmark::State& state) { look(state, eye_range); }
BENCHMARK(BM_GridSense)->Apply(sizes);

// The same eyes and sums, but one cell as large as the arena: every vehicle is compared with every other.
void BM_AllPairsSense(benchmark::State& state) { look(state, 1e6f); }
BENCHMARK(BM_AllPairsSense)->Apply(sizes);

// The same crowd with five bodies per vehicle, joined by locked joints.
void BM_FiveBodies(benchmark::State& state) {
    const int n = static_cast<int>(state.range(0));
    const Scene scene = dense(n);
    const CrowdState crowd = state_in(crowd_of(n));
    const auto make_bodies = [&] {
        auto made = std::make_unique<tests::FiveBodies>(scene.arena);
        for (const mechanics::Motion& m : crowd.motion)
            made->add(scene.kinds[0].body, {m.position.x, m.position.y, m.heading});
        return made;
    };
    auto bodies = make_bodies();
    CrowdEyes eyes(scene, eye_range);
    std::vector<mechanics::Motion> motion(crowd.motion.size());
    std::vector<std::array<float, 2>> sensed;
    int ticks = 0;
    for (auto _ : state) {
        if (++ticks % stretch == 0) {
            state.PauseTiming();
            bodies = make_bodies();
            state.ResumeTiming();
        }
        for (std::size_t row = 0; row < motion.size(); ++row) motion[row] = bodies->motion(row);
        eyes.look(motion, crowd.hunts, sensed);
        for (std::size_t row = 0; row < motion.size(); ++row) {
            const auto told = motors(crowd.hunts[row] ? hunter : hunted, sensed[row]);
            bodies->command(row, told[0], told[1]);
        }
        bodies->step();
    }
    count(state);
}
BENCHMARK(BM_FiveBodies)->Apply(sizes);

void BM_Capture(benchmark::State& state) {
    World world = World::restore(crowd_of(static_cast<int>(state.range(0))));
    world.step();
    Snapshot now;
    for (auto _ : state) world.capture(now);
    count(state);
}
BENCHMARK(BM_Capture)->Arg(50)->Arg(1000)->Unit(benchmark::kMicrosecond);

void BM_Fork(benchmark::State& state) {
    World world = World::restore(crowd_of(static_cast<int>(state.range(0))));
    world.step();
    for (auto _ : state) benchmark::DoNotOptimize(world.fork());
    count(state);
}
BENCHMARK(BM_Fork)->Arg(50)->Arg(1000)->Unit(benchmark::kMicrosecond);

void BM_Think(benchmark::State& state) {
    const std::array<std::string, 2> eyes{"SL", "SR"};
    const auto brain = compile(make_graph(hunter), eyes);
    std::array<float, 2> neurons{}, told{}, sensed{0.3f, 0.7f};
    for (auto _ : state) {
        think(*brain, sensed, neurons, told);
        benchmark::DoNotOptimize(told);
    }
}
BENCHMARK(BM_Think);

// One vehicle, 300 ticks from a checkpoint: the time of a prediction of five seconds.
void BM_Rollout(benchmark::State& state) {
    Scene scene = tests::alone(hunter);
    scene.sources.push_back({.name = "lamp", .x = 8, .y = 2});
    World now = std::move(*World::create(scene, 1));
    const Checkpoint save = now.checkpoint();
    for (auto _ : state) {
        World ahead = World::restore(save);
        for (int i = 0; i < 300; ++i) ahead.step();
        benchmark::DoNotOptimize(ahead.hash());
    }
}
BENCHMARK(BM_Rollout)->Unit(benchmark::kMicrosecond);

// 20 futures of five seconds, each of another brain, in the middle between two keyframes.
void BM_Predict(benchmark::State& state) {
    Scene scene = tests::alone(hunter);
    scene.sources.push_back({.name = "lamp", .x = 8, .y = 2});
    World now = std::move(*World::create(scene, 1));
    while (now.tick() < keyframe_ticks / 2) now.step();
    for (auto _ : state)
        for (int i = 0; i < 20; ++i) {
            const TurnDial change{{.vehicle = 0}, Dial::LL, 0.05f * static_cast<float>(i)};
            benchmark::DoNotOptimize(insight::predict({now.checkpoint(), {change}, 0, 300}));
        }
}
BENCHMARK(BM_Predict)->Unit(benchmark::kMicrosecond);

// The cells of a map of 32×32 runs of 20 s with one vehicle; of the first level, the coarse map, alone with 1.
void BM_Map(benchmark::State& state) {
    insight::MapQuestion question{.scene = tests::alone(hunter), .vehicle = 0, .target = {.vehicle = 0}};
    question.scene.sources.push_back({.name = "lamp", .x = 8, .y = 2});
    const auto base = *insight::MapBase::create(question);
    const auto levels = insight::map_levels(question.size);
    const auto count = std::min(levels.size(), static_cast<std::size_t>(state.range(0)));
    for (auto _ : state)
        for (std::size_t level = 0; level < count; ++level)
            for (const insight::MapPlace place : levels[level])
                benchmark::DoNotOptimize(insight::run_cell(base, place));
}
BENCHMARK(BM_Map)->Arg(1)->Arg(99)->Unit(benchmark::kMillisecond);

// The cause of one turn: 0 of a brain of wires alone, 1 of one with hidden neurons, silenced over half a second.
void BM_Why(benchmark::State& state) {
    const char* name = state.range(0) ? "5-logic" : "2b-aggressor";
    const auto scene = load_scene(std::string(BRAITENLAB_SOURCE) + "/exercises/scenes/" + name + ".toml");
    World world = std::move(*World::create(*scene, 1));
    std::vector<insight::BrainMoment> past;
    Snapshot now;
    for (std::size_t i = 0; i <= insight::silenced_ticks; ++i) {
        world.step();
        world.capture(now);
        past.push_back(insight::moment_of(now, now.vehicles[0]));
    }
    for (auto _ : state) benchmark::DoNotOptimize(insight::why(now, now.vehicles[0], past));
}
BENCHMARK(BM_Why)->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace braitenlab::bench
