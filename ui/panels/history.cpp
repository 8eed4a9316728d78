#include "ui/panels/history.h"

#include <cmath>
#include <limits>
#include <string>

namespace braitenlab {

namespace {

template <class Samples>
void forget_after(Samples& samples, double seconds) {
    while (!samples.empty() && samples.back().seconds > seconds) samples.pop_back();
}

// Half a tick of slack: seconds are ticks divided by 60.
template <class Samples>
bool is_due(const Samples& samples, double seconds, std::uint64_t period) {
    return samples.empty() || samples.back().seconds == seconds ||
           seconds - samples.back().seconds > (static_cast<double>(period) - 0.5) / 60;
}

template <class Samples, class Sample>
void keep(Samples& samples, const Sample& sample, std::size_t most) {
    if (!samples.empty() && samples.back().seconds == sample.seconds) samples.pop_back();
    samples.push_back(sample);
    if (samples.size() > most) samples.pop_front();
}

// What the brain gets of an eye: nothing of a covered one.
float sensed(const Snapshot& now, const VehicleView& vehicle, const char* name) {
    const Node* node = find_node(*now.brains[static_cast<std::size_t>(vehicle.brain)], std::string(name));
    return node && !node->silenced ? node_value(now, vehicle, node->id) : 0;
}

std::size_t group_of(Role role) { return role == Role::predator ? 0 : role == Role::prey ? 1 : 2; }

History::Population counted(const Snapshot& now, double seconds) {
    History::Population sample{.seconds = seconds};
    for (const VehicleView& v : now.vehicles) {
        ++sample.count[group_of(v.role)];
        sample.energy[group_of(v.role)] += v.energy;
    }
    for (std::size_t i = 0; i < 3; ++i)
        sample.energy[i] = sample.count[i] > 0 ? sample.energy[i] / static_cast<float>(sample.count[i])
                                               : std::numeric_limits<float>::quiet_NaN();
    return sample;
}

}  // namespace

void remember(History& history, const LabView& view) {
    const Snapshot& now = *view.now;
    const double seconds = static_cast<double>(now.tick) / 60;
    if (history.run_id != view.run_id) history = {}, history.run_id = view.run_id;
    if (now.tick < history.tick) {
        forget_after(history.signals, seconds);
        forget_after(history.population, seconds);
    }
    history.tick = now.tick;
    if (history.vehicle != view.settings.selection.vehicle) history.signals.clear();
    history.vehicle = view.settings.selection.vehicle;
    const VehicleView* vehicle = find_vehicle(now, view.settings.selection.vehicle);
    if (vehicle && is_due(history.signals, seconds, History::signal_period))
        keep(history.signals,
             History::Signals{
                 seconds,
                 {sensed(now, *vehicle, "SL"), sensed(now, *vehicle, "SR"), vehicle->motor[0], vehicle->motor[1]}},
             History::signal_samples);
    if (is_due(history.population, seconds, History::population_period))
        keep(history.population, counted(now, seconds), History::population_samples);
}

}  // namespace braitenlab
