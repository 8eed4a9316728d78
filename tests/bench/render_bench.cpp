// The time of a picture, to glFinish: the renderer, and one draw call per box as in simple simulators. Compare figures
// of one run only. Needs a display (xvfb-run); without one the benchmarks are skipped.
#include <cmath>
#include <memory>
#include <optional>

#include <benchmark/benchmark.h>

#include "core/maths/angle.h"
#include "core/maths/random.h"
#include "render/gl/renderer.h"
#include "tests/bench/cube_by_cube.h"
#include "tests/render/stage.h"
#include "tests/view/hand_made.h"

namespace braitenlab {
namespace {

using namespace render;

constexpr int width = 1280, height = 800;
const Rect window{0, 0, width, height};

// N vehicles with two eyes of 60 degrees and 6 m each, two vehicle lengths apart, half predators, half prey.
Snapshot dense(int n) {
    auto scene = hand_made::scene();
    scene->arena.width = scene->arena.height = 2 * std::sqrt(static_cast<float>(n));
    for (Kind& kind : scene->kinds)
        for (Sensor& eye : kind.sensors) eye.range = 6, eye.fov = maths::radians(60);
    Snapshot now = hand_made::empty(scene);
    maths::Random random(1, 1);
    const float half = scene->arena.width / 2;
    for (int i = 0; i < n; ++i) {
        const float x = random.uniform(-half, half), y = random.uniform(-half, half);
        const float left = random.uniform(0, 1), right = random.uniform(0, 1);
        hand_made::add(now, 1 + i % 2, x, y, random.uniform(-maths::pi, maths::pi), left * left, right * right);
    }
    return now;
}

Picture seen_from_the_ring(const Snapshot& now) {
    Picture picture;
    picture.camera_view = look(Camera{}, now.scene->arena, nullptr, window, window);
    return picture;
}

// Drivers compile shaders at their first use, which takes longer than many frames.
constexpr int warm_up_frames = 4;

void drive_on(Snapshot& now) {
    ++now.tick;
    for (VehicleView& v : now.vehicles) v.x += 0.02f, v.wheel_angle[0] += 0.1f, v.wheel_angle[1] += 0.1f;
}

enum class Look { rests, moves };

void draw_ours(benchmark::State& state, SectorPath sectors, Look eye = Look::rests) {
    Stage stage(width, height);
    if (!stage.ready()) return state.SkipWithError(stage.problem().c_str());
    auto renderer = Renderer::create(BRAITENLAB_SOURCE "/shaders", sectors);
    if (!renderer) return state.SkipWithError(renderer.error().text().c_str());
    Snapshot now = dense(static_cast<int>(state.range(0)));
    Picture picture = seen_from_the_ring(now);
    for (int i = 0; i < warm_up_frames; ++i) drive_on(now), renderer->draw(now, picture), glFinish();
    Camera camera;
    for (auto _ : state) {
        drive_on(now);
        if (eye == Look::moves) {
            orbit(camera, 0.002f, 0);
            picture.camera_view = look(camera, now.scene->arena, nullptr, window, window);
        }
        renderer->draw(now, picture);
        glFinish();
    }
    state.counters["draw_calls"] = renderer->draw_calls();
}

void BM_DrawOurs(benchmark::State& state) { draw_ours(state, SectorPath::automatic); }
void BM_DrawOursOrbiting(benchmark::State& state) { draw_ours(state, SectorPath::automatic, Look::moves); }
void BM_DrawOursInstanced(benchmark::State& state) { draw_ours(state, SectorPath::instanced); }

// A scene of an exercise: one selected vehicle, a lamp and a box. Argument: Quality.
void BM_DrawExercise(benchmark::State& state) {
    Stage stage(width, height);
    if (!stage.ready()) return state.SkipWithError(stage.problem().c_str());
    auto renderer = Renderer::create(BRAITENLAB_SOURCE "/shaders");
    if (!renderer) return state.SkipWithError(renderer.error().text().c_str());
    auto scene = hand_made::scene();
    scene->obstacles.push_back({.name = "box", .x = 2, .y = -2, .length = 2, .width = 1});
    Snapshot now = hand_made::empty(scene);
    hand_made::add(now, 0, -3, 0, 0.3f, 0.3f, 0.4f);
    hand_made::add_source(now, Channel::light, 3, 1);
    const FloorBox box{{-4.5f, -4.5f}, {4.5f, 4.5f}};
    Picture picture;
    picture.quality = static_cast<Quality>(state.range(0));
    picture.settings.selection.vehicle = 0;
    picture.camera_view = look(Camera{}, now.scene->arena, nullptr, window, window, &box);
    for (int i = 0; i < warm_up_frames; ++i) drive_on(now), renderer->draw(now, picture), glFinish();
    for (auto _ : state) {
        drive_on(now), now.vehicles[0].x -= 0.02f;
        renderer->draw(now, picture);
        glFinish();
    }
}

void BM_DrawCubeByCube(benchmark::State& state) {
    Stage stage(width, height);
    if (!stage.ready()) return state.SkipWithError(stage.problem().c_str());
    Snapshot now = dense(static_cast<int>(state.range(0)));
    const Picture picture = seen_from_the_ring(now);
    bench::CubeByCube naive(now, picture);
    for (int i = 0; i < warm_up_frames; ++i) drive_on(now), naive.draw(now, picture), glFinish();
    for (auto _ : state) {
        drive_on(now);
        naive.draw(now, picture);
        glFinish();
    }
    state.counters["draw_calls"] = naive.draw_calls();
}

// Filling the arrays for the graphics card, without drawing.
void BM_FillDrawList(benchmark::State& state) {
    const Snapshot now = dense(static_cast<int>(state.range(0)));
    const Picture picture = seen_from_the_ring(now);
    DrawList list;
    const Trails trails;
    for (auto _ : state) fill(list, now, picture, trails);
}

#define BRAITENLAB_CROWDS \
    Arg(50)->Arg(1000)->Arg(5000)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime()
BENCHMARK(BM_DrawOurs)->BRAITENLAB_CROWDS;
BENCHMARK(BM_DrawOursOrbiting)->BRAITENLAB_CROWDS;
BENCHMARK(BM_DrawOursInstanced)->BRAITENLAB_CROWDS;
BENCHMARK(BM_DrawExercise)->DenseRange(0, 2)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(BM_DrawCubeByCube)->BRAITENLAB_CROWDS;
BENCHMARK(BM_FillDrawList)->BRAITENLAB_CROWDS;

}  // namespace
}  // namespace braitenlab
