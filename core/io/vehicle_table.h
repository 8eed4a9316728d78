// The columns of a table with one row per vehicle and time: for `braitenctl run --csv` and for the charts of the
// window. docs/command-line.md explains each column.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/enum_table.h"
#include "core/io/csv.h"
#include "core/world/snapshot.h"

namespace braitenlab::io {

struct VehicleRow {
    const Snapshot& now;
    const VehicleView& vehicle;  // in `now`
};

using VehicleColumn = CsvColumn<VehicleRow>;

// Columns that a table has only if they are asked for.
enum class ColumnGroup { sensors, neurons, learned, distances };

inline constexpr auto column_group_table = std::to_array<Word<ColumnGroup>>({{ColumnGroup::sensors, "sensors"},
                                                                             {ColumnGroup::neurons, "neurons"},
                                                                             {ColumnGroup::learned, "learned"},
                                                                             {ColumnGroup::distances, "distances"}});
constexpr const auto& table_of(ColumnGroup) { return column_group_table; }
static_assert(is_complete_table<column_group_table>());

// The columns of every table: seconds, id, kind, role, pose, speed, energy, wheel commands.
const std::vector<VehicleColumn>& vehicle_columns();

// The column of vehicle_columns() with this name. Precondition: there is one.
const VehicleColumn& vehicle_column(std::string_view name);

// Reading 0..1 of the sensor with this name; 0 while the brain's sensor node of this name is silenced; NaN for a
// vehicle without such a sensor. Its name is "sensor_" and the sensor's name.
VehicleColumn sensor_column(std::string sensor);

// vehicle_columns(), then those of the groups in the order of ColumnGroup:
// sensors    "sensor_NAME": see sensor_column()
// neurons    "neuron_NAME": value of the hidden neuron after this tick; 0 while it is silenced
// learned    "learned_FROM>TO": learned part of the Hebbian wire's weight, which adds to the weight in the scene
// distances  "distance_NAME_m": from the vehicle's origin to the source, across the seam of a torus if that is shorter
// A cell is empty for a vehicle that has no such sensor, neuron or wire. There is one column per name in the kinds and
// brains of the snapshot; brains that are edited later add none.
std::vector<VehicleColumn> vehicle_columns(const Snapshot&, const std::set<ColumnGroup>&);

// A value of the brain of one vehicle, with the name that its column has without "neuron_" or "learned_".
struct BrainValue {
    std::string name;
    double value = 0;
};
// The hidden neurons, and the learned parts of the Hebbian wires, in the order of the graph; the first `most` of them.
std::vector<BrainValue> neuron_values(const Snapshot&, const VehicleView&, std::size_t most = SIZE_MAX);
std::vector<BrainValue> learned_values(const Snapshot&, const VehicleView&, std::size_t most = SIZE_MAX);

}  // namespace braitenlab::io
