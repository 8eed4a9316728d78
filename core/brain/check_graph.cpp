// Validates a graph.
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "core/brain/brain.h"

namespace braitenlab {

namespace {

// "'bias' is nan, outside -1 .. 1", or nullopt. A number that is not finite is outside every range.
std::optional<std::string> outside(const char* name, float value, float low, float high) {
    if (value >= low && value <= high) return std::nullopt;
    return fmt::format("'{}' is {:.6g}, outside {:.6g} .. {:.6g}", name, value, low, high);
}

using Fault = std::optional<std::string>;

Fault fault_in(const Curve& curve) {
    if (auto fault = outside("peak", curve.peak, -limits::peak, limits::peak)) return fault;
    return outside("width", curve.width, limits::least_width, limits::width);
}

Fault fault_in(const Node& node) {
    if (auto fault = outside("bias", node.bias, -limits::bias, limits::bias)) return fault;
    if (auto fault = outside("time_constant", node.time_constant, 0, limits::time_constant)) return fault;
    if (node.place)
        for (const float along : {node.place->x, node.place->y})
            if (auto fault = outside("place", along, -limits::place, limits::place)) return fault;
    return fault_in(node.curve);
}

Fault fault_in(const Wire& wire) {
    if (auto fault = outside("weight", wire.weight, -limits::weight, limits::weight)) return fault;
    if (auto fault = outside("threshold", wire.threshold, 0, limits::threshold)) return fault;
    if (auto fault = outside("learning_rate", wire.learning_rate, 0, limits::learning_rate)) return fault;
    if (auto fault = outside("decay", wire.decay, 0, limits::decay)) return fault;
    return fault_in(wire.curve);
}

std::optional<Error> too_many(const char* what, std::size_t count, int most) {
    if (count <= static_cast<std::size_t>(most)) return std::nullopt;
    return Error{fmt::format("a brain may have {} {}, this one has {}; take some away", most, what, count)};
}

std::optional<Error> check_counts(const BrainGraph& graph) {
    std::size_t sensors = 0, neurons = 0;
    for (const Node& node : graph.nodes) {
        sensors += node.kind == NodeKind::sensor;
        neurons += node.kind == NodeKind::neuron;
    }
    if (auto error = too_many("sensors", sensors, limits::sensors)) return error;
    if (auto error = too_many("neurons", neurons, limits::neurons)) return error;
    return too_many("wires", graph.wires.size(), limits::wires);
}

std::optional<Error> check_nodes(const BrainGraph& graph) {
    std::set<NodeId> ids;
    std::set<std::string> names;
    for (const Node& node : graph.nodes) {
        if (node.id < 0) return Error{fmt::format("node '{}' has the id {}; ids begin at 0", node.name, node.id)};
        if (!ids.insert(node.id).second)
            return Error{fmt::format("two nodes have the id {}; give each its own", node.id)};
        if (!names.insert(node.name).second)
            return Error{fmt::format("two nodes are called '{}'; give each its own name", node.name)};
        if (node.kind == NodeKind::motor && node.name != "ML" && node.name != "MR")
            return Error{fmt::format("motor '{}' is unknown; a vehicle has the motors ML and MR", node.name)};
        if (const auto fault = fault_in(node)) return Error{fmt::format("node '{}': {}", node.name, *fault)};
    }
    return std::nullopt;
}

std::optional<Error> check_wires(const BrainGraph& graph) {
    std::map<NodeId, const Node*> nodes;
    for (const Node& node : graph.nodes) nodes[node.id] = &node;
    std::set<std::pair<NodeId, NodeId>> ends;
    for (const Wire& wire : graph.wires) {
        const auto from = nodes.find(wire.from), to = nodes.find(wire.to);
        if (from == nodes.end() || to == nodes.end())
            return Error{
                fmt::format("a wire runs from node {} to node {}, and one of them does not exist", wire.from, wire.to)};
        const std::string &start = from->second->name, &end = to->second->name;
        if (to->second->kind == NodeKind::sensor)
            return Error{fmt::format("a wire runs into the sensor '{}'; sensors only send", end)};
        if (!ends.insert({wire.from, wire.to}).second)
            return Error{fmt::format("two wires run from '{}' to '{}'; make them one", start, end)};
        if (const auto fault = fault_in(wire))
            return Error{fmt::format("the wire from '{}' to '{}': {}", start, end, *fault)};
    }
    return std::nullopt;
}

}  // namespace

std::optional<Error> check_graph(const BrainGraph& graph) {
    if (auto error = check_counts(graph)) return error;
    if (auto error = check_nodes(graph)) return error;
    return check_wires(graph);
}

}  // namespace braitenlab
