// What a tick costs. Compare figures of one run only: machines differ, and so does one machine from minute to minute.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>

#include "core/brain/brain.h"
#include "core/session/session.h"
#include "core/world/world.h"
#include "tests/core/scenes.h"

namespace braitenlab {
namespace {

// N vehicles at constant density: half attracted, half repelled, so that contacts are many.
Scene dense(int n) {
    Scene scene = tests::crowd(n);
    scene.arena.width = scene.arena.height = 2 * std::sqrt(static_cast<float>(n));
    scene.ecology.inactivity = 0;
    scene.ecology.bite = 0;  // nobody dies: the same load from first tick to last
    for (Kind& kind : scene.kinds)
        for (Sensor& eye : kind.sensors) eye.range = 6, eye.field = maths::radians(60);
    return scene;
}

void BM_WorldStep(benchmark::State& state) {
    auto world = World::create(dense(static_cast<int>(state.range(0))), 1);
    for (int i = 0; i < 120; ++i) world->step();  // past the start, into the crowd
    for (auto _ : state) world->step();
    state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(BM_WorldStep)->Arg(50)->Arg(1000)->Arg(5000)->Unit(benchmark::kMicrosecond);

void BM_Capture(benchmark::State& state) {
    auto world = World::create(dense(static_cast<int>(state.range(0))), 1);
    Snapshot now;
    for (auto _ : state) world->capture(now);
    state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(BM_Capture)->Arg(50)->Arg(1000)->Unit(benchmark::kMicrosecond);

void BM_Think(benchmark::State& state) {
    const std::array<std::string, 2> eyes{"SL", "SR"};
    const auto brain = compile(make_graph({.LR = 1.5f, .RL = 1.5f, .LM = 0.1f, .RM = 0.1f}), eyes);
    std::array<float, 2> neurons{}, motors{}, sensed{0.3f, 0.7f};
    for (auto _ : state) {
        think(*brain, sensed, neurons, motors);
        benchmark::DoNotOptimize(motors);
    }
}
BENCHMARK(BM_Think);

// One vehicle, 300 ticks, from its start: what looking five seconds ahead costs.
void BM_Rollout(benchmark::State& state) {
    const Scene scene = tests::alone({.LR = 1.5f, .RL = 1.5f, .LM = 0.1f, .RM = 0.1f});
    for (auto _ : state) {
        auto world = World::create(scene, 1);
        for (int i = 0; i < 300; ++i) world->step();
        benchmark::DoNotOptimize(world->hash());
    }
}
BENCHMARK(BM_Rollout)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace braitenlab
