#include "core/world/snapshot.h"

#include <algorithm>

namespace braitenlab {

const VehicleView* find_vehicle(const Snapshot& now, VehicleId id) {
    const auto found = std::lower_bound(now.vehicles.begin(), now.vehicles.end(), id,
                                        [](const VehicleView& v, VehicleId wanted) { return v.id < wanted; });
    return found != now.vehicles.end() && found->id == id ? &*found : nullptr;
}

namespace {

float sensor_value(const Snapshot& now, const VehicleView& vehicle, const std::string& name) {
    const auto& sensors = now.scene->kinds[static_cast<std::size_t>(vehicle.kind)].sensors;
    for (std::size_t i = 0; i < sensors.size(); ++i)
        if (sensors[i].name == name) return now.sensed[static_cast<std::size_t>(vehicle.first_sensed) + i];
    return 0;
}

}  // namespace

float node_value(const Snapshot& now, const VehicleView& vehicle, NodeId id) {
    const BrainGraph& brain = *now.brains[static_cast<std::size_t>(vehicle.brain)];
    const Node* node = find_node(brain, id);
    if (!node || node->silenced) return 0;
    if (node->kind == NodeKind::sensor) return sensor_value(now, vehicle, node->name);
    // Units stand in the order of a compiled brain: hidden neurons by ascending id, the left motor, the right motor.
    auto unit = static_cast<std::size_t>(vehicle.first_neuron);
    if (node->kind == NodeKind::motor) {
        unit += static_cast<std::size_t>(vehicle.neuron_count) - (node->name == "ML" ? 2 : 1);
    } else {
        for (const Node& other : brain.nodes) unit += other.kind == NodeKind::neuron && other.id < id;
    }
    return now.neurons[unit];
}

float learned(const Snapshot& now, const VehicleView& vehicle, NodeId from, NodeId to) {
    const BrainGraph& brain = *now.brains[static_cast<std::size_t>(vehicle.brain)];
    const Wire* wire = find_wire(brain, from, to);
    if (!wire || !learns(*wire)) return 0;
    auto place = static_cast<std::size_t>(vehicle.first_neuron + vehicle.neuron_count);
    for (const Wire& other : brain.wires)
        if (learns(other) && std::pair(other.from, other.to) < std::pair(from, to)) ++place;
    return now.neurons[place];
}

}  // namespace braitenlab
