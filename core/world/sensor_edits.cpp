// Replacement of sensors, of one vehicle or of all vehicles of a kind.
#include "core/world/edits.h"

namespace braitenlab::world {

namespace {

// The readings of one vehicle in the flat arrays.
struct Readings {
    const std::vector<Sensor>& sensors;
    std::size_t first_sensed = 0, first_delayed = 0;
};

// Appends the reading of the sensor and its readings that the brain has not received yet: those of the sensor of this
// name in `before`, or 0.
void append_readings(const Vehicles& v, const Readings& before, const Sensor& sensor, std::vector<float>& sensed,
                     std::vector<float>& delayed) {
    std::size_t ring = before.first_delayed;
    const std::uint32_t delay = sensing::delay_ticks(sensor);
    for (std::size_t i = 0; i < before.sensors.size(); ++i) {
        const std::uint32_t old_delay = sensing::delay_ticks(before.sensors[i]);
        if (before.sensors[i].name == sensor.name) {
            sensed.push_back(v.sensed[before.first_sensed + i]);
            const auto slots = v.delayed.begin() + static_cast<std::ptrdiff_t>(ring);
            if (delay == old_delay)
                delayed.insert(delayed.end(), slots, slots + delay);
            else
                delayed.insert(delayed.end(), delay, 0.0f);
            return;
        }
        ring += old_delay;
    }
    sensed.push_back(0);
    delayed.insert(delayed.end(), delay, 0.0f);
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
        for (const Sensor& sensor : sensors_of(row)) append_readings(v, before, sensor, sensed, delayed);
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
    return check_scene(with_sensors(s, kind, sensors));
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
