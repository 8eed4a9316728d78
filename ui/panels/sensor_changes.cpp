#include "ui/panels/sensor_changes.h"

#include <algorithm>

#include "core/scene/sensor_edits.h"

namespace braitenlab::ui {

namespace {

// The sensors that are in the first list, by name, and not in the second.
std::vector<Sensor> difference_of(const std::vector<Sensor>& sensors, const std::vector<Sensor>& others) {
    std::vector<Sensor> found;
    for (const Sensor& sensor : sensors)
        if (std::none_of(others.begin(), others.end(), [&](const Sensor& o) { return o.name == sensor.name; }))
            found.push_back(sensor);
    return found;
}

// Applies an edit to the brains of the target; nothing is requested if it changes none.
template <class Edit>
void request_brains(const LabView& view, Outbox& outbox, const Target& target, std::uint64_t gesture, Edit edit) {
    const Snapshot& now = *view.now;
    const auto request = [&](const Target& whose, BrainGraph brain) {
        outbox.push_back(EditRequest{SetBrain{whose, std::move(brain)}, gesture});
    };
    if (const VehicleView* vehicle = find_vehicle(now, target.vehicle)) {
        const BrainGraph& brain = *brain_of(now, *vehicle);
        if (BrainGraph edited = edit(brain); edited != brain) request(target, std::move(edited));
        return;
    }
    const auto kind = static_cast<std::size_t>(target.kind);
    if (kind >= now.kind_brains.size()) return;
    const BrainGraph& of_kind = *now.kind_brains[kind];
    bool is_edited = edit(of_kind) != of_kind;
    for (const VehicleView& vehicle : now.vehicles)
        is_edited |= vehicle.kind == target.kind && edit(*brain_of(now, vehicle)) != *brain_of(now, vehicle);
    if (!is_edited) return;
    request(target, edit(of_kind));  // also replaces the brains of single vehicles
    for (const VehicleView& vehicle : now.vehicles)
        if (const BrainGraph& own = *brain_of(now, vehicle); vehicle.kind == target.kind && own != of_kind)
            request({.vehicle = vehicle.id}, edit(own));
}

}  // namespace

void request_sensors(const LabView& view, Outbox& outbox, const VehicleView& vehicle, std::vector<Sensor> sensors,
                     std::uint64_t gesture) {
    const Target target = target_of(view, vehicle);
    const std::vector<Sensor>& before = kind_of(*view.now, vehicle).sensors;
    const std::vector<Sensor> added = difference_of(sensors, before);
    std::vector<std::string> removed;
    for (const Sensor& sensor : difference_of(before, sensors)) removed.push_back(sensor.name);
    outbox.push_back(EditRequest{SetSensors{target, std::move(sensors)}, gesture});
    if (added.empty() && removed.empty()) return;
    request_brains(view, outbox, target, gesture, [&](const BrainGraph& brain) {
        return with_sensor_nodes(without_idle_sensors(brain, removed), added);
    });
}

void request_brain_and_sensors(const LabView& view, Outbox& outbox, const VehicleView& vehicle, BrainGraph brain,
                               std::vector<Sensor> sensors, std::uint64_t gesture) {
    const Target target = target_of(view, vehicle);
    outbox.push_back(EditRequest{SetSensors{target, std::move(sensors)}, gesture});
    outbox.push_back(EditRequest{SetBrain{target, std::move(brain)}, gesture});
}

void request_renamed_sensor(const LabView& view, Outbox& outbox, const VehicleView& vehicle, const std::string& from,
                            const std::string& to, std::uint64_t gesture) {
    const Target target = target_of(view, vehicle);
    std::vector<Sensor> sensors = kind_of(*view.now, vehicle).sensors;
    for (Sensor& sensor : sensors)
        if (sensor.name == from) sensor.name = to;
    outbox.push_back(EditRequest{SetSensors{target, std::move(sensors)}, gesture});
    request_brains(view, outbox, target, gesture, [&](BrainGraph brain) {
        for (Node& node : brain.nodes)
            if (node.kind == NodeKind::sensor && node.name == from) node.name = to;
        return brain;
    });
}

bool is_name_taken(const LabView& view, const VehicleView& vehicle, const std::string& name) {
    const Snapshot& now = *view.now;
    const Target target = target_of(view, vehicle);
    const auto has_it = [&](const auto& all) {
        return std::any_of(all.begin(), all.end(), [&](const auto& each) { return each.name == name; });
    };
    const auto is_affected = [&](const VehicleView& v) {
        return target.vehicle != no_vehicle ? v.id == target.vehicle : v.kind == target.kind;
    };
    if (has_it(kind_of(now, vehicle).sensors)) return true;
    return std::any_of(now.vehicles.begin(), now.vehicles.end(),
                       [&](const VehicleView& v) { return is_affected(v) && has_it(brain_of(now, v)->nodes); });
}

std::vector<std::string> names_taken(const LabView& view, const VehicleView& vehicle) {
    std::vector<std::string> names;
    for (const Node& node : brain_of(*view.now, vehicle)->nodes)
        if (node.kind != NodeKind::sensor) names.push_back(node.name);
    return names;
}

}  // namespace braitenlab::ui
