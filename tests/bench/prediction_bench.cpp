// The time from an edit to its predicted path in the window, as update_predictions() and Jobs compute it while a slider
// is dragged, and what a frame spends for it on the window's thread.
#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

#include <benchmark/benchmark.h>

#include "app/features/predictions.h"
#include "app/lab_requests.h"
#include "app/playback.h"
#include "core/insight/predict.h"

namespace braitenlab {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

// A hunt of so many vehicles after half a minute, with noise in the sensors: a fan of paths is computed too.
Result<Lab> noisy_hunt(int vehicles) {
    auto lab = open_lab(BRAITENLAB_SOURCE "/exercises/scenes/predator-prey.toml", 1, {});
    if (!lab) return lab;
    Session& session = lab->document.session;
    while (static_cast<int>(session.snapshot().vehicles.size()) < vehicles)
        if (session.apply(AddVehicle{})) break;
    std::vector<Sensor> eyes = session.scene().kinds[0].sensors;
    for (Sensor& eye : eyes) eye.noise = 0.05f;
    if (auto refused = session.apply(SetSensors{{.kind = 0}, eyes})) return *refused;
    handle(*lab, SelectRequest{.vehicle = session.snapshot().vehicles.front().id});
    handle(*lab, Action::play_pause);
    for (int i = 0; i < 1800; ++i) tick(*lab);
    return lab;
}

// Arguments: vehicles, worker threads. Time: from the edit until the path can be drawn, at 60 frames per second.
// Counter `window_ms`: the longest time that a frame spends for it on the window's thread.
void BM_FirstPath(benchmark::State& state) {
    auto lab = noisy_hunt(static_cast<int>(state.range(0)));
    if (!lab) return state.SkipWithError("the hunt cannot be read");
    Jobs jobs(static_cast<int>(state.range(1)));
    const VehicleId vehicle = lab->view.selection.vehicle;
    float value = 0;
    double window_ms = 0;
    std::uint64_t drag = 0;
    for (auto _ : state) {
        value = value > 0.5f ? 0.1f : value + 0.05f;
        ++drag;
        note_press(lab->predictions, *lab, true);
        handle(*lab, EditRequest{TurnDial{{.vehicle = vehicle}, Dial::LM, value}, drag});
        const Clock::time_point edited = Clock::now();
        bool is_shown = false;
        while (!is_shown) {
            const Clock::time_point frame = Clock::now();
            jobs.deliver(std::chrono::milliseconds(4));
            update_predictions(lab->predictions, *lab, jobs);
            is_shown = prediction_of(lab->predictions, *lab) &&
                       prediction_of(lab->predictions, *lab)->tick == lab->document.session.snapshot().tick;
            window_ms = std::max(window_ms, milliseconds_since(frame));
            if (!is_shown) std::this_thread::sleep_until(frame + std::chrono::microseconds(16667));
        }
        state.SetIterationTime(milliseconds_since(edited) / 1000);
        note_press(lab->predictions, *lab, false);
        lab->predictions = {};
    }
    state.counters["window_ms"] = window_ms;
}
BENCHMARK(BM_FirstPath)->ArgsProduct({{50}, {0, 1}})->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace braitenlab
