// Compiles a graph to flat arrays.
#include <algorithm>
#include <map>
#include <tuple>

#include "core/brain/brain.h"
#include "core/maths/portable.h"

namespace braitenlab {

namespace {

std::vector<const Node*> by_ascending_id(const BrainGraph& graph, NodeKind kind) {
    std::vector<const Node*> nodes;
    for (const Node& node : graph.nodes)
        if (node.kind == kind) nodes.push_back(&node);
    std::sort(nodes.begin(), nodes.end(), [](const Node* a, const Node* b) { return a->id < b->id; });
    return nodes;
}

// Hidden neurons by ascending id, then the two motors (a missing motor is a unit without a node).
std::vector<const Node*> unit_order(const BrainGraph& graph) {
    std::vector<const Node*> order = by_ascending_id(graph, NodeKind::neuron);
    for (const char* motor : {"ML", "MR"}) {
        const Node* node = find_node(graph, motor);
        order.push_back(node && node->kind == NodeKind::motor ? node : nullptr);
    }
    return order;
}

float follow_per_tick(float time_constant, float period) {
    return time_constant > 0 ? 1 - maths::exponential(-period / time_constant) : 1.0f;
}

// The value of a missing or silenced node is always 0.
Brain::Unit unit_of(const Node* node, float period) {
    if (!node || node->silenced) return {0, 0, 0, 1, {}};
    return {0, 0, node->bias, follow_per_tick(node->time_constant, period), node->curve};
}

std::int32_t sensor_index(const Node& sensor, std::span<const std::string> sensor_names) {
    const auto named = std::find(sensor_names.begin(), sensor_names.end(), sensor.name);
    if (sensor.silenced || named == sensor_names.end()) return -1;
    return static_cast<std::int32_t>(named - sensor_names.begin());
}

std::vector<std::pair<NodeId, NodeId>> learning_wires_of(const BrainGraph& graph) {
    std::vector<std::pair<NodeId, NodeId>> ends;
    for (const Wire& wire : graph.wires)
        if (learns(wire)) ends.emplace_back(wire.from, wire.to);
    std::sort(ends.begin(), ends.end());
    return ends;
}

// The index of a wire in Brain::learning_wires; −1 when it does not learn.
std::int32_t learned_index(const Brain& brain, const Wire& wire) {
    if (!learns(wire)) return -1;
    const auto& all = brain.learning_wires;
    const auto at = std::lower_bound(all.begin(), all.end(), std::pair(wire.from, wire.to));
    return static_cast<std::int32_t>(at - all.begin());
}

}  // namespace

Result<Brain> compile(const BrainGraph& graph, std::span<const std::string> sensor_names, float period) {
    if (auto error = check_graph(graph)) return *error;

    Brain brain;
    brain.period = period;
    std::map<NodeId, std::int32_t> source_of;  // index of a node's value for Tap::source
    for (const Node* sensor : by_ascending_id(graph, NodeKind::sensor)) {
        source_of[sensor->id] = static_cast<std::int32_t>(brain.sensors.size());
        brain.sensors.push_back(sensor_index(*sensor, sensor_names));
    }
    const auto first_unit = static_cast<std::int32_t>(brain.sensors.size());
    const std::vector<const Node*> order = unit_order(graph);
    for (const Node* node : order) {
        if (node) source_of[node->id] = first_unit + brain.neuron_count();
        brain.units.push_back(unit_of(node, period));
        brain.unit_ids.push_back(node ? node->id : -1);
    }
    brain.learning_wires = learning_wires_of(graph);

    // Sorted by unit, then by source: sums do not depend on the order of editing.
    std::vector<std::pair<std::int32_t, Brain::Tap>> feeds;
    for (const Wire& wire : graph.wires) {
        const std::int32_t unit = source_of[wire.to] - first_unit;
        const Node* fed = order[static_cast<std::size_t>(unit)];
        if (wire.cut || fed->silenced) continue;
        feeds.push_back({unit,
                         {source_of[wire.from], wire.weight, wire.threshold, wire.curve, learned_index(brain, wire),
                          wire.learning_rate, wire.decay}});
    }
    std::sort(feeds.begin(), feeds.end(), [](const auto& a, const auto& b) {
        return std::tie(a.first, a.second.source) < std::tie(b.first, b.second.source);
    });
    auto feed = feeds.begin();
    for (std::int32_t u = 0; u < brain.neuron_count(); ++u) {
        Brain::Unit& unit = brain.units[static_cast<std::size_t>(u)];
        unit.first_tap = static_cast<std::int32_t>(brain.taps.size());
        for (; feed != feeds.end() && feed->first == u; ++feed) brain.taps.push_back(feed->second);
        unit.end_tap = static_cast<std::int32_t>(brain.taps.size());
    }
    return brain;
}

}  // namespace braitenlab
