#include "ui/panels/chart_data.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include <fmt/format.h>

#include "core/scene/enums.h"

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

// The reading of a sensor as input of the brain: 0 for a silenced sensor.
float sensor_reading(const Snapshot& now, const VehicleView& vehicle, const char* name) {
    const Node* node = find_node(*brain_of(now, vehicle), std::string(name));
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
        add_sample(history.signals,
                   History::Signals{seconds,
                                    {sensor_reading(now, *vehicle, "SL"), sensor_reading(now, *vehicle, "SR"),
                                     vehicle->motor[0], vehicle->motor[1]}},
                   History::signal_samples);
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

// A column: its name in the header line, and the text of its value in a row.
template <class Row>
struct CsvColumn {
    std::string_view name;
    std::string (*text)(const Row&);
};

template <class Row, std::size_t Count, class Rows>
std::string csv(const CsvColumn<Row> (&columns)[Count], const Rows& rows) {
    std::string text;
    const auto end_of_field = [&](const CsvColumn<Row>& column) {
        text += &column == &columns[Count - 1] ? '\n' : ',';
    };
    for (const auto& column : columns) text += column.name, end_of_field(column);
    for (const Row& row : rows)
        for (const auto& column : columns) text += column.text(row), end_of_field(column);
    return text;
}

std::string csv_seconds(double seconds) { return fmt::format("{:.3f}", seconds); }

// Empty for NaN.
std::string csv_value(float value) { return std::isfinite(value) ? fmt::format("{:.4f}", value) : std::string(); }

// In quotes where the text holds a separator.
std::string csv_text(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + "\"";
}

using SignalRow = History::Signals;
constexpr CsvColumn<SignalRow> signal_columns[]{
    {"seconds", [](const SignalRow& s) { return csv_seconds(s.seconds); }},
    {"SL", [](const SignalRow& s) { return csv_value(s.values[0]); }},
    {"SR", [](const SignalRow& s) { return csv_value(s.values[1]); }},
    {"ML", [](const SignalRow& s) { return csv_value(s.values[2]); }},
    {"MR", [](const SignalRow& s) { return csv_value(s.values[3]); }},
};

using PopulationRow = History::Population;
constexpr CsvColumn<PopulationRow> population_columns[]{
    {"seconds", [](const PopulationRow& p) { return csv_seconds(p.seconds); }},
    {"predators", [](const PopulationRow& p) { return std::to_string(p.count[0]); }},
    {"prey", [](const PopulationRow& p) { return std::to_string(p.count[1]); }},
    {"others", [](const PopulationRow& p) { return std::to_string(p.count[2]); }},
    {"energy_predators", [](const PopulationRow& p) { return csv_value(p.energy[0]); }},
    {"energy_prey", [](const PopulationRow& p) { return csv_value(p.energy[1]); }},
    {"energy_others", [](const PopulationRow& p) { return csv_value(p.energy[2]); }},
};

struct VehicleRow {
    const VehicleView& vehicle;
    const Kind& kind;
};
constexpr CsvColumn<VehicleRow> energy_columns[]{
    {"id", [](const VehicleRow& row) { return std::to_string(row.vehicle.id); }},
    {"kind", [](const VehicleRow& row) { return csv_text(row.kind.name); }},
    {"role", [](const VehicleRow& row) { return std::string(word(row.vehicle.role)); }},
    {"energy", [](const VehicleRow& row) { return csv_value(row.vehicle.energy); }},
};

}  // namespace

std::string signals_csv(const History& history) { return csv(signal_columns, history.signals); }

std::string population_csv(const History& history) { return csv(population_columns, history.population); }

std::string energies_csv(const Snapshot& now) {
    std::vector<VehicleRow> rows;
    for (const VehicleView& vehicle : now.vehicles) rows.push_back({vehicle, kind_of(now, vehicle)});
    return csv(energy_columns, rows);
}

}  // namespace braitenlab::ui
