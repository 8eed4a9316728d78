#include "ui/panels/history.h"

#include <string>

namespace braitenlab {

namespace {

template <class T>
void keep(std::deque<T>& samples, T sample, std::size_t most) {
    samples.push_back(sample);
    if (samples.size() > most) samples.pop_front();
}

float sensed(const Snapshot& now, const VehicleView& vehicle, const char* name) {
    const Node* node = find_node(*now.brains[static_cast<std::size_t>(vehicle.brain)], std::string(name));
    return node ? node_value(now, vehicle, node->id) : 0;
}

void remember_signals(History& history, const Snapshot& now, const VehicleView& vehicle) {
    if (!history.signals[0].empty() && now.tick < history.signal_tick + History::signal_period) return;
    history.signal_tick = now.tick;
    const std::array<float, 4> sample{sensed(now, vehicle, "SL"), sensed(now, vehicle, "SR"), vehicle.motor[0],
                                      vehicle.motor[1]};
    for (std::size_t i = 0; i < sample.size(); ++i) keep(history.signals[i], sample[i], History::signal_samples);
}

void remember_population(History& history, const Snapshot& now) {
    if (!history.population.empty() && now.tick < history.population_tick + History::population_period) return;
    history.population_tick = now.tick;
    const std::array<float, 2> sample{static_cast<float>(now.predators), static_cast<float>(now.prey)};
    keep(history.population, sample, History::population_samples);
}

}  // namespace

void remember(History& history, const LabView& view) {
    const Snapshot& now = *view.now;
    if (now.tick < history.tick) history = {};
    history.tick = now.tick;
    if (history.vehicle != view.selected)
        for (auto& signal : history.signals) signal.clear();
    history.vehicle = view.selected;
    if (const VehicleView* vehicle = find_vehicle(now, view.selected)) remember_signals(history, now, *vehicle);
    remember_population(history, now);
}

}  // namespace braitenlab
