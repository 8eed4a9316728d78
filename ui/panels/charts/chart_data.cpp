#include "ui/panels/charts/chart_data.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/io/vehicle_table.h"
#include "ui/wiring/node_text.h"

namespace braitenlab::ui {

namespace {

template <class Samples>
void drop_after(Samples& samples, double seconds) {
    while (!samples.empty() && samples.back().seconds > seconds) samples.pop_back();
}

// With half a tick of tolerance: seconds are ticks divided by 60.
template <class Samples>
bool is_due(const Samples& samples, double seconds, std::uint64_t period) {
    return samples.empty() || samples.back().seconds == seconds ||
           seconds - samples.back().seconds > (static_cast<double>(period) - 0.5) / 60;
}

template <class Samples, class Sample>
void add_sample(Samples& samples, const Sample& sample, std::size_t most) {
    if (!samples.empty() && samples.back().seconds == sample.seconds) samples.pop_back();
    samples.push_back(sample);
    if (samples.size() > most) samples.pop_front();
}

// The values of the brain by name: neurons, then learned parts of wires.
std::vector<io::BrainValue> brain_values_of(const Snapshot& now, const VehicleView& vehicle) {
    std::vector<io::BrainValue> values = io::neuron_values(now, vehicle, History::most_brain_values);
    const std::size_t room = History::most_brain_values - values.size();
    for (io::BrainValue& learned : io::learned_values(now, vehicle, room)) values.push_back(std::move(learned));
    return values;
}

History::Signals signals_of(const Snapshot& now, const VehicleView& vehicle, double seconds) {
    History::Signals sample{seconds, {}, vehicle.motor};
    for (const Sensor& sensor : kind_of(now, vehicle).sensors) {
        const double value = std::get<double>(io::sensor_column(sensor.name).value({now, vehicle}));
        sample.sensors.push_back(static_cast<float>(value));
    }
    return sample;
}

// Keeps the value of largest size of each neuron since the last sample, so that a pulse of one tick is not lost.
void follow_peaks(History& history, const Snapshot& now, const VehicleView& vehicle) {
    std::vector<float>& peaks = history.brain_peaks;
    peaks.resize(history.brain_values.size(), 0.0f);
    if (peaks.empty()) return;
    const std::vector<io::BrainValue> values = brain_values_of(now, vehicle);
    for (std::size_t i = 0; i < peaks.size(); ++i) {
        const auto value = static_cast<float>(values[i].value);
        if (std::fabs(value) >= std::fabs(peaks[i])) peaks[i] = value;
    }
}

// Takes the names of the vehicle's sensors and brain values. Signals with other names are removed.
void follow_names(History& history, const Snapshot& now, const VehicleView* vehicle) {
    auto sensors = vehicle ? sensor_names(kind_of(now, *vehicle)) : std::vector<std::string>{};
    auto brain = vehicle ? brain_of(now, *vehicle) : nullptr;
    std::vector<std::string> values = history.brain_values;
    if (brain != history.brain) {
        values.clear();
        if (vehicle)
            for (io::BrainValue& each : brain_values_of(now, *vehicle)) values.push_back(std::move(each.name));
    }
    if (sensors != history.sensors || values != history.brain_values) {
        history.signals.clear();
        history.brain_peaks.clear();
    }
    history.sensors = std::move(sensors);
    history.brain = std::move(brain);
    history.brain_values = std::move(values);
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

using io::CsvValue;
using SignalRow = History::Signals;
using PopulationRow = History::Population;

std::vector<io::CsvColumn<SignalRow>> signal_columns(const History& history) {
    std::vector<io::CsvColumn<SignalRow>> columns{
        {io::vehicle_column("seconds").name, [](const SignalRow& s) -> CsvValue { return s.seconds; }}};
    for (std::size_t i = 0; i < history.sensors.size(); ++i)
        columns.push_back(
            {io::sensor_column(history.sensors[i]).name, [i](const SignalRow& s) -> CsvValue { return s.sensors[i]; }});
    for (std::size_t i = 0; i < 2; ++i)
        columns.push_back({io::vehicle_column(i == 0 ? "left" : "right").name,
                           [i](const SignalRow& s) -> CsvValue { return s.motors[i]; }});
    for (std::size_t i = 0; i < history.brain_values.size(); ++i) {
        const std::string& name = history.brain_values[i];
        columns.push_back({(name.find('>') == name.npos ? "neuron_" : "learned_") + name,
                           [i](const SignalRow& s) -> CsvValue { return s.brain[i]; }});
    }
    return columns;
}

std::vector<io::CsvColumn<PopulationRow>> population_columns() {
    constexpr std::array groups{"predators", "prey", "others"};
    std::vector<io::CsvColumn<PopulationRow>> columns{
        {io::vehicle_column("seconds").name, [](const PopulationRow& p) -> CsvValue { return p.seconds; }}};
    for (std::size_t i = 0; i < groups.size(); ++i)
        columns.push_back({groups[i], [i](const PopulationRow& p) -> CsvValue { return std::int64_t{p.count[i]}; }});
    for (std::size_t i = 0; i < groups.size(); ++i)
        columns.push_back(
            {std::string("energy_") + groups[i], [i](const PopulationRow& p) -> CsvValue { return p.energy[i]; }});
    return columns;
}

template <class Columns, class Samples>
std::string csv_of(const Columns& columns, const Samples& samples) {
    std::string text = io::csv_header(columns);
    for (const auto& sample : samples) io::add_csv_row(text, columns, sample);
    return text;
}

}  // namespace

void record(History& history, const LabView& view) {
    if ((view.lesson && view.lesson->together) || (view.features.robots && view.features.robots->replayed))
        return;  // other runs than the one that is recorded
    const Snapshot& now = *view.now;
    const double seconds = static_cast<double>(now.tick) / 60;
    if (history.run_id != view.run_id) history = {}, history.run_id = view.run_id;
    if (now.tick < history.tick) {
        history.brain_peaks.clear();
        drop_after(history.signals, seconds);
        drop_after(history.population, seconds);
    }
    history.tick = now.tick;
    if (history.vehicle != view.settings.selection.vehicle) history.signals.clear(), history.brain_peaks.clear();
    history.vehicle = view.settings.selection.vehicle;
    const VehicleView* vehicle = find_vehicle(now, view.settings.selection.vehicle);
    follow_names(history, now, vehicle);
    if (vehicle) follow_peaks(history, now, *vehicle);
    if (vehicle && is_due(history.signals, seconds, History::signal_period)) {
        History::Signals sample = signals_of(now, *vehicle, seconds);
        sample.brain = std::exchange(history.brain_peaks, {});
        add_sample(history.signals, sample, History::signal_samples);
    }
    if (is_due(history.population, seconds, History::population_period))
        add_sample(history.population, counted(now, seconds), History::population_samples);
}

std::size_t first_in_strip(const History& history) {
    const auto& all = history.signals;
    if (all.empty()) return 0;
    const auto first = std::lower_bound(all.begin(), all.end(), all.back().seconds - strip_seconds,
                                        [](const History::Signals& s, double at) { return s.seconds < at; });
    return static_cast<std::size_t>(first - all.begin());
}

float Signal::value(const History::Signals& sample) const {
    if (of == Of::motor) return sample.motors[index];
    return of == Of::sensor ? sample.sensors[index] : sample.brain[index];
}

std::vector<Signal> all_signals(const History& history) {
    std::vector<Signal> all;
    for (std::size_t i = 0; i < history.sensors.size(); ++i) all.push_back({Signal::Of::sensor, i, history.sensors[i]});
    all.push_back({Signal::Of::motor, 0, "ML"});
    all.push_back({Signal::Of::motor, 1, "MR"});
    for (std::size_t i = 0; i < history.brain_values.size(); ++i)
        all.push_back({Signal::Of::brain, i, history.brain_values[i]});
    return all;
}

std::optional<Signal> signal_named(const History& history, std::string_view name) {
    for (Signal& signal : all_signals(history))
        if (signal.name == name) return std::move(signal);
    return std::nullopt;
}

SignalRange range_of(const History& history, const Signal& signal) {
    SignalRange range{signal.of == Signal::Of::motor ? -1.0f : 0.0f, 1};
    for (const History::Signals& sample : history.signals) {
        const float value = signal.value(sample);
        range.high = std::max(range.high, std::fabs(value));
        if (value < 0) range.low = -1;
    }
    if (range.low < 0) range.low = -range.high;
    return range;
}

float ShownSignals::value(const History::Signals& sample, std::size_t signal) const {
    if (signal >= 2) return sample.motors[signal - 2];
    return sensors[signal] ? sample.sensors[*sensors[signal]] : 0;
}

double longest_time_with(const History& history, Role role, int count) {
    const std::size_t group = role == Role::predator ? 0 : 1;
    double best = 0;
    std::optional<double> since;
    for (const History::Population& sample : history.population) {
        if (sample.count[group] < count)
            since.reset();
        else
            best = std::max(best, sample.seconds - since.value_or(sample.seconds)),
            since = since.value_or(sample.seconds);
    }
    return best;
}

ShownSignals shown_signals(const History& history, const SensorPair& pair) {
    ShownSignals shown{{pair.left, pair.right, "ML", "MR"}};
    for (std::size_t side = 0; side < 2; ++side)
        for (std::size_t i = 0; i < history.sensors.size(); ++i)
            if (history.sensors[i] == shown.names[side]) shown.sensors[side] = i;
    return shown;
}

ShownSignals shown_signals(const History& history, const LabView& view) {
    const VehicleView* vehicle = find_vehicle(*view.now, history.vehicle);
    if (!vehicle) return shown_signals(history, SensorPair{});
    ShownSignals shown = shown_signals(history, shown_pair(view, *vehicle));
    for (std::size_t side = 0; side < 2; ++side)
        shown.names[side] = wiring::short_name(kind_of(*view.now, *vehicle).sensors, shown.names[side]);
    return shown;
}

void sort(const Snapshot& now, const EnergyOrder& order, std::vector<std::size_t>& rows) {
    rows.resize(now.vehicles.size());
    std::iota(rows.begin(), rows.end(), std::size_t{0});  // the snapshot is in ascending number
    if (order.by == EnergyOrder::By::number) {
        if (order.falling) std::reverse(rows.begin(), rows.end());
        return;
    }
    std::sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) {
        const VehicleView &one = now.vehicles[a], &other = now.vehicles[b];
        const bool by_energy = order.by == EnergyOrder::By::energy;
        const float x = by_energy ? one.energy : static_cast<float>(one.kind);
        const float y = by_energy ? other.energy : static_cast<float>(other.kind);
        if (x == y) return a < b;
        return order.falling ? x > y : x < y;
    });
}

std::string signals_csv(const History& history) { return csv_of(signal_columns(history), history.signals); }

std::string population_csv(const History& history) { return csv_of(population_columns(), history.population); }

std::string energies_csv(const Snapshot& now) {
    const std::array columns{io::vehicle_column("id"), io::vehicle_column("kind"), io::vehicle_column("role"),
                             io::vehicle_column("energy")};
    std::string text = io::csv_header(columns);
    for (const VehicleView& vehicle : now.vehicles) io::add_csv_row(text, columns, io::VehicleRow{now, vehicle});
    return text;
}

}  // namespace braitenlab::ui
