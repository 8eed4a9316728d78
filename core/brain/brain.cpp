#include "core/brain/brain.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "core/maths/portable.h"

namespace braitenlab {

namespace {

bool finite(const Curve& curve) { return std::isfinite(curve.peak) && std::isfinite(curve.width) && curve.width > 0; }

std::optional<Error> check_nodes(const BrainGraph& graph) {
    std::set<NodeId> ids;
    std::set<std::string> names;
    int sensors = 0, neurons = 0;
    for (const Node& node : graph.nodes) {
        if (!ids.insert(node.id).second)
            return Error{fmt::format("two nodes have the id {}; give each its own", node.id)};
        if (!names.insert(node.name).second)
            return Error{fmt::format("two nodes are called '{}'; give each its own name", node.name)};
        if (!std::isfinite(node.bias) || !std::isfinite(node.time_constant) || node.time_constant < 0 ||
            !finite(node.curve))
            return Error{
                fmt::format("node '{}' holds a number that is not usable; use finite numbers, a time constant of "
                            "0 or more and a width above 0",
                            node.name)};
        if (node.kind == NodeKind::motor && node.name != "ML" && node.name != "MR")
            return Error{fmt::format("motor '{}' is unknown; a vehicle has the motors ML and MR", node.name)};
        ++(node.kind == NodeKind::sensor ? sensors : neurons);
    }
    if (sensors > limits::sensors)
        return Error{fmt::format("a brain may have {} sensors, this one has {}", limits::sensors, sensors)};
    if (neurons > limits::neurons)
        return Error{fmt::format("a brain may have {} neurons, this one has {}", limits::neurons, neurons)};
    return std::nullopt;
}

std::optional<Error> check_wires(const BrainGraph& graph) {
    if (graph.wires.size() > static_cast<std::size_t>(limits::wires))
        return Error{fmt::format("a brain may have {} wires, this one has {}", limits::wires, graph.wires.size())};
    std::map<NodeId, const Node*> nodes;
    for (const Node& node : graph.nodes) nodes[node.id] = &node;
    std::set<std::pair<NodeId, NodeId>> ends;
    for (const Wire& wire : graph.wires) {
        const auto from = nodes.find(wire.from), to = nodes.find(wire.to);
        if (from == nodes.end() || to == nodes.end())
            return Error{
                fmt::format("a wire runs from node {} to node {}, and one of them does not exist", wire.from, wire.to)};
        if (to->second->kind == NodeKind::sensor)
            return Error{fmt::format("a wire runs into the sensor '{}'; sensors only send", to->second->name)};
        if (!ends.insert({wire.from, wire.to}).second)
            return Error{
                fmt::format("two wires run from '{}' to '{}'; make them one", from->second->name, to->second->name)};
        if (!std::isfinite(wire.weight) || !std::isfinite(wire.threshold) || !finite(wire.curve))
            return Error{
                fmt::format("the wire from '{}' to '{}' holds a number that is not usable; use finite numbers and a "
                            "width above 0",
                            from->second->name, to->second->name)};
    }
    return std::nullopt;
}

// Hidden neurons by ascending id, then the two motors (a missing motor is a unit without a node).
std::vector<const Node*> unit_order(const BrainGraph& graph) {
    std::vector<const Node*> order;
    for (const Node& node : graph.nodes)
        if (node.kind == NodeKind::neuron) order.push_back(&node);
    std::sort(order.begin(), order.end(), [](const Node* a, const Node* b) { return a->id < b->id; });
    for (const char* motor : {"ML", "MR"}) {
        const Node* node = find_node(graph, motor);
        order.push_back(node && node->kind == NodeKind::motor ? node : nullptr);
    }
    return order;
}

float follow_per_tick(float time_constant) {
    return time_constant > 0 ? 1 - maths::exponential(-tick_seconds / time_constant) : 1.0f;
}

}  // namespace

Result<Brain> compile(const BrainGraph& graph, std::span<const std::string> sensor_names) {
    if (auto error = check_nodes(graph)) return *error;
    if (auto error = check_wires(graph)) return *error;

    Brain brain;
    std::map<NodeId, std::int32_t> source_of;  // where a tap finds a node's value
    std::vector<const Node*> sensors;
    for (const Node& node : graph.nodes)
        if (node.kind == NodeKind::sensor) sensors.push_back(&node);
    std::sort(sensors.begin(), sensors.end(), [](const Node* a, const Node* b) { return a->id < b->id; });
    for (const Node* node : sensors) {
        const auto named = std::find(sensor_names.begin(), sensor_names.end(), node->name);
        source_of[node->id] = static_cast<std::int32_t>(brain.sensors.size());
        brain.sensors.push_back(named == sensor_names.end() ? -1
                                                            : static_cast<std::int32_t>(named - sensor_names.begin()));
    }
    const std::vector<const Node*> order = unit_order(graph);
    for (std::size_t i = 0; i < order.size(); ++i)
        if (order[i]) source_of[order[i]->id] = static_cast<std::int32_t>(brain.sensors.size() + i);

    for (const Node* node : order) {
        Brain::Unit unit{static_cast<std::int32_t>(brain.taps.size()), 0, 0, 1, {}};
        if (node) {
            unit.bias = node->bias;
            unit.follow = follow_per_tick(node->time_constant);
            unit.curve = node->curve;
            for (const Wire& wire : graph.wires)
                if (wire.to == node->id)
                    brain.taps.push_back({source_of[wire.from], wire.weight, wire.threshold, wire.curve});
        }
        // Summed in this order whatever the order of editing: the same graph gives the same bits.
        std::sort(brain.taps.begin() + unit.first_tap, brain.taps.end(),
                  [](const Brain::Tap& a, const Brain::Tap& b) { return a.source < b.source; });
        unit.end_tap = static_cast<std::int32_t>(brain.taps.size());
        brain.units.push_back(unit);
        brain.unit_ids.push_back(node ? node->id : -1);
    }
    return brain;
}

namespace {

// One unit's new value from what its taps find now.
template <class Read>
float settle(const Brain& brain, const Brain::Unit& unit, float held, Read read) {
    float sum = unit.bias;
    for (std::int32_t t = unit.first_tap; t < unit.end_tap; ++t) {
        const Brain::Tap& tap = brain.taps[static_cast<std::size_t>(t)];
        const float input = read(static_cast<std::size_t>(tap.source));
        const float passed = std::fabs(input) < tap.threshold ? 0.0f : input;
        sum += tap.weight * (tap.curve.response == Response::linear ? passed : respond(tap.curve, passed));
    }
    const float target = unit.curve.response == Response::linear ? sum : respond(unit.curve, sum);
    // Bounded, so that a growing loop of wires saturates instead of running off to infinity.
    return std::clamp(held + unit.follow * (target - held), -1e3f, 1e3f);
}

}  // namespace

void think(const Brain& brain, std::span<const float> sensed, std::span<float> neurons, std::span<float, 2> motors) {
    const std::size_t sensor_count = brain.sensors.size(), count = brain.units.size(), hidden = count - 2;
    const auto sensor = [&](std::size_t source) {
        const std::int32_t index = brain.sensors[source];
        return index < 0 ? 0.0f : sensed[static_cast<std::size_t>(index)];
    };

    // Hidden neurons all read what the previous tick latched, so they settle into a second array and go over together.
    constexpr std::size_t most = static_cast<std::size_t>(limits::neurons) + 2;
    float settled[most];
    const auto read_latched = [&](std::size_t source) {
        return source < sensor_count ? sensor(source) : neurons[source - sensor_count];
    };
    for (std::size_t u = 0; u < hidden; ++u) settled[u] = settle(brain, brain.units[u], neurons[u], read_latched);

    // Motors read this tick's neurons; another motor they read as it was.
    const auto read_settled = [&](std::size_t source) {
        if (source < sensor_count) return sensor(source);
        const std::size_t unit = source - sensor_count;
        return unit < hidden ? settled[unit] : neurons[unit];
    };
    for (std::size_t u = hidden; u < count; ++u) settled[u] = settle(brain, brain.units[u], neurons[u], read_settled);

    std::copy(settled, settled + count, neurons.begin());
    motors[0] = std::clamp(neurons[hidden], -1.0f, 1.0f);
    motors[1] = std::clamp(neurons[hidden + 1], -1.0f, 1.0f);
}

}  // namespace braitenlab
