#include "core/insight/why.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/brain/brain.h"

namespace braitenlab::insight {

namespace {

const Node* working_motor(const BrainGraph& brain, const char* name) {
    const Node* motor = find_node(brain, std::string(name));
    return motor && !motor->silenced ? motor : nullptr;
}

// The sum of the wires from a node straight to a motor.
float straight(const Snapshot& now, const VehicleView& vehicle, const Node& from, const Node* motor) {
    const BrainGraph& brain = *brain_of(now, vehicle);
    const Wire* wire = motor ? find_wire(brain, from.id, motor->id) : nullptr;
    return wire ? signal(*wire, node_value(now, vehicle, from.id), learned(now, vehicle, from.id, motor->id)) : 0;
}

// Right − left motor at the last moment, not limited to −1..1, with the sensor `silenced` at 0 since the first moment.
float difference_without(const Brain& brain, std::span<const BrainMoment> past, std::optional<std::size_t> silenced) {
    std::vector<float> state = past.front().state;
    std::array<float, 2> motors{};
    for (const BrainMoment& moment : past.subspan(1)) {
        std::vector<float> sensed = moment.sensed;
        if (silenced) sensed[*silenced] = 0;
        think(brain, sensed, state, motors);
    }
    const auto right = static_cast<std::size_t>(brain.neuron_count()) - 1;
    return state[right] - state[right - 1];
}

// The moments fit the brain: it may have been edited since.
bool fit(const Brain& brain, std::size_t sensors, std::span<const BrainMoment> past) {
    return past.size() > 1 && std::all_of(past.begin(), past.end(), [&](const BrainMoment& moment) {
               return moment.sensed.size() == sensors &&
                      moment.state.size() == static_cast<std::size_t>(brain.state_size());
           });
}

void add_parts_through_neurons(Why& result, const Snapshot& now, const VehicleView& vehicle,
                               std::span<const BrainMoment> past) {
    const std::vector<Sensor>& sensors = kind_of(now, vehicle).sensors;
    std::vector<std::string> names;
    for (const Sensor& sensor : sensors) names.push_back(sensor.name);
    const auto brain = compile(*brain_of(now, vehicle), names);
    if (!brain || !fit(*brain, sensors.size(), past)) return;
    result.ticks = past.size() - 1;
    const float all = difference_without(*brain, past, std::nullopt);
    for (SensorPart& part : result.sensors) {
        const auto index = static_cast<std::size_t>(std::find(names.begin(), names.end(), part.sensor) - names.begin());
        if (index < names.size()) part.value = all - difference_without(*brain, past, index);
    }
}

}  // namespace

BrainMoment moment_of(const Snapshot& now, const VehicleView& vehicle) {
    const auto sensors = static_cast<std::ptrdiff_t>(kind_of(now, vehicle).sensors.size());
    const auto learning = std::count_if(brain_of(now, vehicle)->wires.begin(), brain_of(now, vehicle)->wires.end(),
                                        [](const Wire& wire) { return learns(wire); });
    const auto readings = now.sensed.begin() + vehicle.first_sensed;
    const auto values = now.neurons.begin() + vehicle.first_neuron;
    return {{readings, readings + sensors}, {values, values + vehicle.neuron_count + learning}};
}

std::optional<std::size_t> main_part(std::span<const float> parts) {
    const auto largest = std::max_element(parts.begin(), parts.end());
    if (largest == parts.end() || *largest < least_part) return std::nullopt;
    return static_cast<std::size_t>(largest - parts.begin());
}

bool has_hidden_neurons(const BrainGraph& brain) {
    return std::any_of(brain.nodes.begin(), brain.nodes.end(),
                       [](const Node& node) { return node.kind == NodeKind::neuron; });
}

Why why(const Snapshot& now, const VehicleView& vehicle, std::span<const BrainMoment> past) {
    const BrainGraph& brain = *brain_of(now, vehicle);
    const Node *left = working_motor(brain, "ML"), *right = working_motor(brain, "MR");
    Why result{.vehicle = vehicle.id, .tick = now.tick, .left = vehicle.motor[0], .right = vehicle.motor[1]};
    result.bias = (right ? right->bias : 0) - (left ? left->bias : 0);
    for (const Node& node : brain.nodes)
        if (node.kind == NodeKind::sensor)
            result.sensors.push_back({node.name, node_value(now, vehicle, node.id),
                                      straight(now, vehicle, node, right) - straight(now, vehicle, node, left)});
    if (has_hidden_neurons(brain)) add_parts_through_neurons(result, now, vehicle, past);
    std::stable_sort(result.sensors.begin(), result.sensors.end(),
                     [](const SensorPart& a, const SensorPart& b) { return std::fabs(a.value) > std::fabs(b.value); });
    result.rest = result.right - result.left - result.bias;
    for (const SensorPart& part : result.sensors) result.rest -= part.value;
    return result;
}

}  // namespace braitenlab::insight
