// Replacement of sensors, of one vehicle or of all vehicles of a kind.
#include "core/scene/sensor_edits.h"

#include <utility>

#include "core/world/edits.h"

namespace braitenlab::world {

namespace {

// The readings of one vehicle in the flat arrays.
struct Readings {
    const std::vector<Sensor>& sensors;
    std::size_t first_sensed = 0, first_delayed = 0;
};

// The earlier name of the sensor: its own if it had one, else that of the sensor at its index if both differ by their
// name only, and the earlier name is gone.
std::string earlier_name(const std::vector<Sensor>& before, const std::vector<Sensor>& sensors, std::size_t index) {
    Sensor sensor = sensors[index];
    if (find_sensor(before, sensor.name) || index >= before.size()) return sensor.name;
    const std::string& earlier = before[index].name;
    if (find_sensor(sensors, earlier)) return sensor.name;
    const std::string now = std::exchange(sensor.name, earlier);
    return sensor == before[index] ? earlier : now;
}

// Appends the reading of the sensor and its readings that the brain has not received yet: those of the sensor of its
// earlier name in `before`, or 0.
void append_readings(const Vehicles& v, const Readings& before, const std::vector<Sensor>& sensors, std::size_t index,
                     std::vector<float>& sensed, std::vector<float>& delayed) {
    std::size_t ring = before.first_delayed;
    const std::uint32_t kept = sensing::kept_readings(sensors[index]);
    const std::string earlier = earlier_name(before.sensors, sensors, index);
    for (std::size_t i = 0; i < before.sensors.size(); ++i) {
        const std::uint32_t old_kept = sensing::kept_readings(before.sensors[i]);
        if (before.sensors[i].name == earlier) {
            sensed.push_back(v.sensed[before.first_sensed + i]);
            const auto slots = v.delayed.begin() + static_cast<std::ptrdiff_t>(ring);
            const bool same =
                kept == old_kept && sensing::delay_ticks(sensors[index]) == sensing::delay_ticks(before.sensors[i]);
            if (same)
                delayed.insert(delayed.end(), slots, slots + kept);
            else
                delayed.insert(delayed.end(), kept, 0.0f);
            return;
        }
        ring += old_kept;
    }
    sensed.push_back(0);
    delayed.insert(delayed.end(), kept, 0.0f);
}

// Lays out the readings of all vehicles for new sensors: `sensors_of(row)`.
template <class SensorsOf>
void carry_readings(WorldData& s, const SensorsOf& sensors_of) {
    Vehicles& v = s.vehicles;
    std::vector<float> sensed, delayed;
    for (std::size_t row = 0; row < v.size(); ++row) {
        const Readings before{s.design(row).sensors, v.first_sensed[row], v.first_delayed[row]};
        v.first_sensed[row] = static_cast<std::uint32_t>(sensed.size());
        v.first_delayed[row] = static_cast<std::uint32_t>(delayed.size());
        const std::vector<Sensor>& sensors = sensors_of(row);
        for (std::size_t i = 0; i < sensors.size(); ++i) append_readings(v, before, sensors, i, sensed, delayed);
    }
    v.sensed = std::move(sensed);
    v.delayed = std::move(delayed);
}

Scene with_sensors(const WorldData& s, std::size_t kind, const std::vector<Sensor>& sensors) {
    Scene scene = *s.scene;
    scene.kinds[kind].sensors = sensors;
    scene.kinds[kind].brain = s.kind_brains[kind]->graph;
    return scene;
}

std::optional<Error> set_vehicle_sensors(WorldData& s, std::size_t row, const std::vector<Sensor>& sensors) {
    Vehicles& v = s.vehicles;
    const std::size_t kind = s.kind(row);
    if (auto error = check_sensors(s, kind, sensors)) return error;
    PresentParts parts = present_parts(s);
    parts.of_vehicles[row].sensors = sensors == s.scene->kinds[kind].sensors ? nullptr : &sensors;
    if (auto error = check_size(*s.scene, parts)) return error;
    SharedDesign design = own_design(s.scene->kinds[kind], sensors);
    carry_readings(
        s, [&](std::size_t r) -> const std::vector<Sensor>& { return r == row ? sensors : s.design(r).sensors; });
    const SharedBrain& of_kind = s.kind_brains[kind];
    const bool shares_brain = !design && v.brain[row]->graph == of_kind->graph;
    v.brain[row] =
        shares_brain ? of_kind : *compile_brain(v.brain[row]->graph, design ? design->kind : s.scene->kinds[kind]);
    v.design[row] = std::move(design);
    s.lay_out_grids();
    return std::nullopt;
}

std::optional<Error> set_kind_sensors(WorldData& s, std::size_t kind, const std::vector<Sensor>& sensors) {
    Scene scene = with_sensors(s, kind, sensors);
    if (auto error = check_scene(scene)) return error;
    PresentParts parts = present_parts(s);
    for (std::size_t row = 0; row < s.vehicles.size(); ++row)
        if (s.kind(row) == kind) parts.of_vehicles[row].sensors = nullptr;
    if (auto error = check_size(scene, parts)) return error;
    carry_readings(s, [&](std::size_t row) -> const std::vector<Sensor>& {
        return s.kind(row) == kind ? sensors : s.design(row).sensors;
    });
    for (std::size_t row = 0; row < s.vehicles.size(); ++row)
        if (s.kind(row) == kind) s.vehicles.design[row] = nullptr;
    compile_again(s, static_cast<int>(kind), scene.kinds[kind]);  // brains refer to sensors by name
    replace_scene(s, std::move(scene));
    return std::nullopt;
}

}  // namespace

std::optional<Error> check_sensors(const WorldData& s, std::size_t kind, const std::vector<Sensor>& sensors) {
    return check_edited(s, with_sensors(s, kind, sensors));
}

std::optional<Error> execute(WorldData& s, const SetSensors& c) {
    if (c.target.vehicle != no_vehicle) {
        const auto row = s.row_of(c.target.vehicle);
        return row ? set_vehicle_sensors(s, *row, c.sensors) : unknown_vehicle(c.target.vehicle);
    }
    if (auto error = missing(s.scene->kinds, c.target.kind, "kind")) return error;
    return set_kind_sensors(s, static_cast<std::size_t>(c.target.kind), c.sensors);
}

}  // namespace braitenlab::world
