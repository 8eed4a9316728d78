// Validates a graph.
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "core/brain/brain.h"
#include "core/messages.h"

namespace braitenlab {

namespace {

// "'bias' is nan, outside -1 .. 1", or nullopt. A number that is not finite is outside every range.
std::optional<Message> outside(const char* name, float value, float low, float high) {
    if (value >= low && value <= high) return std::nullopt;
    const auto shown = [](float number) { return fmt::format("{:.6g}", number); };
    const float limit = value < low ? low : high;
    const auto [number, passed] = told_apart(static_cast<double>(value), static_cast<double>(limit), Digits::in_all, 6);
    return message_of("out_of_range", name, number, shown(low), shown(high));
}

using GraphFault = std::optional<Message>;

GraphFault fault_in(const Curve& curve) {
    if (auto fault = outside("peak", curve.peak, -limits::peak, limits::peak)) return fault;
    return outside("width", curve.width, limits::least_width, limits::width);
}

GraphFault fault_in(const Node& node) {
    if (auto fault = outside("bias", node.bias, -limits::bias, limits::bias)) return fault;
    if (auto fault = outside("time_constant", node.time_constant, 0, limits::time_constant)) return fault;
    if (node.place)
        for (const float along : {node.place->x, node.place->y})
            if (auto fault = outside("place", along, -limits::place, limits::place)) return fault;
    return fault_in(node.curve);
}

GraphFault fault_in(const Wire& wire) {
    if (auto fault = outside("weight", wire.weight, -limits::weight, limits::weight)) return fault;
    if (auto fault = outside("threshold", wire.threshold, 0, limits::threshold)) return fault;
    if (auto fault = outside("learning_rate", wire.learning_rate, 0, limits::learning_rate)) return fault;
    if (auto fault = outside("decay", wire.decay, 0, limits::decay)) return fault;
    return fault_in(wire.curve);
}

std::optional<Error> too_many(MessageId<2> message, std::size_t count, int most) {
    if (count <= static_cast<std::size_t>(most)) return std::nullopt;
    return error_of(message_of(message, most, count));
}

std::optional<Error> check_counts(const BrainGraph& graph) {
    std::size_t sensors = 0, neurons = 0;
    for (const Node& node : graph.nodes) {
        sensors += node.kind == NodeKind::sensor;
        neurons += node.kind == NodeKind::neuron;
    }
    if (auto error = too_many("too_many_sensors", sensors, limits::sensors)) return error;
    if (auto error = too_many("too_many_neurons", neurons, limits::neurons)) return error;
    return too_many("too_many_wires", graph.wires.size(), limits::wires);
}

std::optional<Error> check_nodes(const BrainGraph& graph) {
    std::set<NodeId> ids;
    std::set<std::string> names;
    for (const Node& node : graph.nodes) {
        if (node.id < 0) return error_of(message_of("negative_node_id", node.name, node.id));
        if (!ids.insert(node.id).second) return error_of(message_of("same_node_id", node.id));
        if (!names.insert(node.name).second) return error_of(message_of("same_node_name", node.name));
        if (node.kind == NodeKind::motor && node.name != "ML" && node.name != "MR")
            return error_of(message_of("unknown_motor", node.name));
        if (const auto fault = fault_in(node)) return error_of(message_of("in_node", node.name) + *fault);
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
            return error_of(message_of("wire_without_end", wire.from, wire.to));
        const std::string &start = from->second->name, &end = to->second->name;
        if (to->second->kind == NodeKind::sensor) return error_of(message_of("wire_into_sensor", end));
        if (!ends.insert({wire.from, wire.to}).second) return error_of(message_of("same_wire", start, end));
        if (const auto fault = fault_in(wire)) return error_of(message_of("in_wire", start, end) + *fault);
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
