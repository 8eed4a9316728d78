#include "core/io/vehicle_table.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/scene/enums.h"
#include "core/scene/sensor_edits.h"
#include "core/sensing/seam.h"

namespace braitenlab::io {

namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

double sensor_input(const VehicleRow& row, const std::string& name) {
    const std::vector<Sensor>& sensors = kind_of(row.now, row.vehicle).sensors;
    const Sensor* sensor = find_sensor(sensors, name);
    if (!sensor) return no_value;
    const Node* node = find_node(*brain_of(row.now, row.vehicle), name);
    if (node && node->silenced) return 0;
    return row.now.sensed[static_cast<std::size_t>(row.vehicle.first_sensed + (sensor - sensors.data()))];
}

VehicleColumn neuron_column(const std::string& name) {
    return {"neuron_" + name, [name](const VehicleRow& row) -> CsvValue {
                const Node* node = find_node(*brain_of(row.now, row.vehicle), name);
                return node && node->kind == NodeKind::neuron ? node_value(row.now, row.vehicle, node->id) : no_value;
            }};
}

struct WireName {
    std::string from, to;
    friend bool operator==(const WireName&, const WireName&) = default;
};

VehicleColumn learned_column(const WireName& name) {
    return {"learned_" + name.from + ">" + name.to, [name](const VehicleRow& row) -> CsvValue {
                const BrainGraph& brain = *brain_of(row.now, row.vehicle);
                const Node *from = find_node(brain, name.from), *to = find_node(brain, name.to);
                const Wire* wire = from && to ? find_wire(brain, from->id, to->id) : nullptr;
                return wire && learns(*wire) ? learned(row.now, row.vehicle, wire->from, wire->to) : no_value;
            }};
}

VehicleColumn distance_column(const std::string& name, int source) {
    return {"distance_" + name + "_m", [source](const VehicleRow& row) -> CsvValue {
                const auto& sources = row.now.sources;
                const auto found = std::find_if(sources.begin(), sources.end(), [&](const SourceView& candidate) {
                    return candidate.source == source;
                });
                if (found == sources.end()) return no_value;
                const maths::vec2 way{found->x - row.vehicle.x, found->y - row.vehicle.y};
                return maths::length(sensing::Seam(row.now.scene->arena).shortest(way));
            }};
}

template <class Name>
void add_once(std::vector<Name>& names, const Name& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

// Calls f with the brain of each kind, then with each brain in use.
template <class F>
void for_each_brain(const Snapshot& now, F f) {
    for (const auto* brains : {&now.kind_brains, &now.brains})
        for (const auto& brain : *brains) f(*brain);
}

std::vector<std::string> names_of_sensors(const Snapshot& now) {
    std::vector<std::string> names;
    for (const Kind& kind : now.scene->kinds)
        for (const Sensor& sensor : kind.sensors) add_once(names, sensor.name);
    for (const auto& design : now.designs)
        for (const Sensor& sensor : design->sensors) add_once(names, sensor.name);
    return names;
}

std::vector<std::string> names_of_neurons(const Snapshot& now) {
    std::vector<std::string> names;
    for_each_brain(now, [&](const BrainGraph& brain) {
        for (const Node& node : brain.nodes)
            if (node.kind == NodeKind::neuron) add_once(names, node.name);
    });
    return names;
}

std::vector<WireName> names_of_learning_wires(const Snapshot& now) {
    std::vector<WireName> names;
    for_each_brain(now, [&](const BrainGraph& brain) {
        for (const Wire& wire : brain.wires)
            if (learns(wire)) add_once(names, {find_node(brain, wire.from)->name, find_node(brain, wire.to)->name});
    });
    return names;
}

}  // namespace

const std::vector<VehicleColumn>& vehicle_columns() {
    using Row = VehicleRow;
    static const std::vector<VehicleColumn> columns{
        {"seconds", [](const Row& row) -> CsvValue { return row.now.seconds; }},
        {"id", [](const Row& row) -> CsvValue { return std::int64_t{row.vehicle.id}; }},
        {"kind", [](const Row& row) -> CsvValue { return std::string_view(kind_of(row.now, row.vehicle).name); }},
        // csvkit reads "none" as a missing value.
        {"role",
         [](const Row& row) -> CsvValue {
             return row.vehicle.role == Role::none ? std::string_view("other") : word(row.vehicle.role);
         }},
        {"x_m", [](const Row& row) -> CsvValue { return row.vehicle.x; }},
        {"y_m", [](const Row& row) -> CsvValue { return row.vehicle.y; }},
        {"heading_rad", [](const Row& row) -> CsvValue { return row.vehicle.heading; }},
        {"speed_m_s", [](const Row& row) -> CsvValue { return row.vehicle.speed; }},
        {"energy", [](const Row& row) -> CsvValue { return row.vehicle.energy; }},
        {"left", [](const Row& row) -> CsvValue { return row.vehicle.motor[0]; }},
        {"right", [](const Row& row) -> CsvValue { return row.vehicle.motor[1]; }},
    };
    return columns;
}

const VehicleColumn& vehicle_column(std::string_view name) {
    const auto& columns = vehicle_columns();
    return *std::find_if(columns.begin(), columns.end(),
                         [&](const VehicleColumn& column) { return column.name == name; });
}

VehicleColumn sensor_column(std::string sensor) {
    std::string name = "sensor_" + sensor;
    return {std::move(name),
            [sensor = std::move(sensor)](const VehicleRow& row) -> CsvValue { return sensor_input(row, sensor); }};
}

std::vector<BrainValue> neuron_values(const Snapshot& now, const VehicleView& vehicle, std::size_t most) {
    std::vector<BrainValue> values;
    for (const Node& node : brain_of(now, vehicle)->nodes)
        if (node.kind == NodeKind::neuron && values.size() < most)
            values.push_back({node.name, node_value(now, vehicle, node.id)});
    return values;
}

std::vector<BrainValue> learned_values(const Snapshot& now, const VehicleView& vehicle, std::size_t most) {
    const BrainGraph& brain = *brain_of(now, vehicle);
    std::vector<std::pair<NodeId, NodeId>> stored;  // the order of the values in the snapshot, as in learned()
    for (const Wire& wire : brain.wires)
        if (learns(wire)) stored.emplace_back(wire.from, wire.to);
    std::sort(stored.begin(), stored.end());
    const auto first = static_cast<std::size_t>(vehicle.first_neuron + vehicle.neuron_count);
    std::vector<BrainValue> values;
    for (const Wire& wire : brain.wires) {
        if (!learns(wire) || values.size() == most) continue;
        const auto place = std::lower_bound(stored.begin(), stored.end(), std::pair(wire.from, wire.to));
        values.push_back({find_node(brain, wire.from)->name + ">" + find_node(brain, wire.to)->name,
                          now.neurons[first + static_cast<std::size_t>(place - stored.begin())]});
    }
    return values;
}

std::vector<VehicleColumn> vehicle_columns(const Snapshot& now, const std::set<ColumnGroup>& groups) {
    std::vector<VehicleColumn> columns = vehicle_columns();
    if (groups.contains(ColumnGroup::sensors))
        for (const std::string& name : names_of_sensors(now)) columns.push_back(sensor_column(name));
    if (groups.contains(ColumnGroup::neurons))
        for (const std::string& name : names_of_neurons(now)) columns.push_back(neuron_column(name));
    if (groups.contains(ColumnGroup::learned))
        for (const WireName& name : names_of_learning_wires(now)) columns.push_back(learned_column(name));
    if (groups.contains(ColumnGroup::distances))
        for (std::size_t i = 0; i < now.scene->sources.size(); ++i)
            columns.push_back(distance_column(now.scene->sources[i].name, static_cast<int>(i)));
    return columns;
}

}  // namespace braitenlab::io
