#include "ui/panels/chart_data.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "core/io/vehicle_table.h"

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

// Name and value of each of History::Signals::values.
const auto& signal_values() {
    static const std::array<io::VehicleColumn, 4> columns{io::sensor_column("SL"), io::sensor_column("SR"),
                                                          io::vehicle_column("left"), io::vehicle_column("right")};
    return columns;
}

History::Signals signals_of(const Snapshot& now, const VehicleView& vehicle, double seconds) {
    History::Signals sample{seconds, {}};
    for (std::size_t i = 0; i < sample.values.size(); ++i) {
        const double value = std::get<double>(signal_values()[i].value({now, vehicle}));
        sample.values[i] = std::isnan(value) ? 0 : static_cast<float>(value);
    }
    return sample;
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

void record(History& history, const LabView& view) {
    const Snapshot& now = *view.now;
    const double seconds = static_cast<double>(now.tick) / 60;
    if (history.run_id != view.run_id) history = {}, history.run_id = view.run_id;
    if (now.tick < history.tick) {
        drop_after(history.signals, seconds);
        drop_after(history.population, seconds);
    }
    history.tick = now.tick;
    if (history.vehicle != view.settings.selection.vehicle) history.signals.clear();
    history.vehicle = view.settings.selection.vehicle;
    const VehicleView* vehicle = find_vehicle(now, view.settings.selection.vehicle);
    if (vehicle && is_due(history.signals, seconds, History::signal_period))
        add_sample(history.signals, signals_of(now, *vehicle, seconds), History::signal_samples);
    if (is_due(history.population, seconds, History::population_period))
        add_sample(history.population, counted(now, seconds), History::population_samples);
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

namespace {

using io::CsvValue;
using SignalRow = History::Signals;
using PopulationRow = History::Population;

std::vector<io::CsvColumn<SignalRow>> signal_columns() {
    std::vector<io::CsvColumn<SignalRow>> columns{
        {io::vehicle_column("seconds").name, [](const SignalRow& s) -> CsvValue { return s.seconds; }}};
    for (std::size_t i = 0; i < signal_values().size(); ++i)
        columns.push_back({signal_values()[i].name, [i](const SignalRow& s) -> CsvValue { return s.values[i]; }});
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

std::string signals_csv(const History& history) { return csv_of(signal_columns(), history.signals); }

std::string population_csv(const History& history) { return csv_of(population_columns(), history.population); }

std::string energies_csv(const Snapshot& now) {
    const std::array columns{io::vehicle_column("id"), io::vehicle_column("kind"), io::vehicle_column("role"),
                             io::vehicle_column("energy")};
    std::string text = io::csv_header(columns);
    for (const VehicleView& vehicle : now.vehicles) io::add_csv_row(text, columns, io::VehicleRow{now, vehicle});
    return text;
}

}  // namespace braitenlab::ui
