#include "ui/wiring/edit.h"

#include <algorithm>
#include <cmath>

namespace braitenlab {
namespace {

struct DirectNames {
    Dial dial;
    const char *sensor, *motor;
};
constexpr DirectNames direct_names[] = {
    {Dial::LL, "SL", "ML"}, {Dial::LR, "SR", "ML"}, {Dial::RL, "SL", "MR"}, {Dial::RR, "SR", "MR"}};

std::string_view why_not(const BrainGraph& graph, WireEnds ends) {
    const Node* from = find_node(graph, ends.from);
    const Node* to = find_node(graph, ends.to);
    if (from == nullptr || to == nullptr) return "wiring.refused.gone";
    if (to->kind == NodeKind::sensor) return "wiring.refused.into_sensor";
    return {};
}

std::string free_name(const BrainGraph& graph) {
    for (int number = 1;; ++number) {
        std::string name = "N" + std::to_string(number);
        if (find_node(graph, name) == nullptr) return name;
    }
}

}  // namespace

Edit connect(const BrainGraph& graph, WireEnds ends) {
    if (const auto reason = why_not(graph, ends); !reason.empty()) return {{}, reason};
    const Wire* there = find_wire(graph, ends.from, ends.to);
    if (there != nullptr && (there->weight != 0 || learns(*there))) return {{}, "wiring.refused.duplicate"};
    return set_weight(graph, ends, 1);
}

Edit set_weight(const BrainGraph& graph, WireEnds ends, float weight) {
    if (const auto reason = why_not(graph, ends); !reason.empty()) return {{}, reason};
    BrainGraph edited = graph;
    if (!std::isfinite(weight)) return {edited, {}};
    weight = std::clamp(weight, -limits::weight, limits::weight);
    if (Wire* wire = find_wire(edited, ends.from, ends.to)) {
        wire->weight = weight;
        return {edited, {}};
    }
    if (edited.wires.size() >= static_cast<std::size_t>(limits::wires)) return {{}, "wiring.refused.wires"};
    Wire wire;
    wire.from = ends.from, wire.to = ends.to, wire.weight = weight;
    edited.wires.push_back(wire);
    return {edited, {}};
}

Edit add_neuron(const BrainGraph& graph, const Node& like) {
    const auto neurons =
        std::count_if(graph.nodes.begin(), graph.nodes.end(), [](const Node& n) { return n.kind == NodeKind::neuron; });
    if (neurons >= limits::neurons) return {{}, "wiring.refused.neurons"};
    BrainGraph edited = graph;
    Node node = like;
    node.id = fresh_id(graph);
    node.kind = NodeKind::neuron;
    if (node.name.empty() || find_node(graph, node.name) != nullptr) node.name = free_name(graph);
    edited.nodes.push_back(node);
    return {edited, {}};
}

NodeId fresh_id(const BrainGraph& graph) {
    NodeId largest = -1;
    for (const Node& node : graph.nodes) largest = std::max(largest, node.id);
    return largest + 1;
}

Edit remove(const BrainGraph& graph, const std::set<NodeId>& nodes, const std::set<WireEnds>& wires) {
    BrainGraph edited = graph;
    const auto goes = [&](NodeId id) {
        const Node* node = find_node(graph, id);
        return nodes.count(id) > 0 && node != nullptr && node->kind == NodeKind::neuron;
    };
    std::erase_if(edited.nodes, [&](const Node& node) { return goes(node.id); });
    std::erase_if(edited.wires, [&](const Wire& wire) {
        const WireEnds ends{wire.from, wire.to};
        return goes(wire.from) || goes(wire.to) || (wires.count(ends) > 0 && !direct_dial(graph, ends));
    });
    for (Wire& wire : edited.wires) {
        if (wires.count({wire.from, wire.to}) == 0) continue;
        Wire empty;  // the place without its wire: no weight, no threshold, no curve
        empty.from = wire.from, empty.to = wire.to, empty.weight = 0;
        wire = empty;
    }
    if (edited == graph) return {{}, nodes.empty() ? "wiring.refused.nothing" : "wiring.refused.fixed"};
    return {edited, {}};
}

std::optional<Dial> direct_dial(const BrainGraph& graph, WireEnds ends) {
    for (const Dial dial : weight_dials)
        if (direct_ends(graph, dial) == ends) return dial;
    return {};
}

std::optional<WireEnds> direct_ends(const BrainGraph& graph, Dial weight) {
    for (const DirectNames& direct : direct_names) {
        if (direct.dial != weight) continue;
        const Node* sensor = find_node(graph, std::string(direct.sensor));
        const Node* motor = find_node(graph, std::string(direct.motor));
        if (sensor == nullptr || sensor->kind != NodeKind::sensor) return {};
        if (motor == nullptr || motor->kind != NodeKind::motor) return {};
        return WireEnds{sensor->id, motor->id};
    }
    return {};
}

float weight_of(const BrainGraph& graph, WireEnds ends) {
    const Wire* wire = find_wire(graph, ends.from, ends.to);
    return wire == nullptr ? 0 : wire->weight;
}

std::string wire_name(const BrainGraph& graph, WireEnds ends) {
    if (const auto dial = direct_dial(graph, ends)) return std::string(name(*dial));
    const Node* from = find_node(graph, ends.from);
    const Node* to = find_node(graph, ends.to);
    return (from == nullptr ? "?" : from->name) + "-" + (to == nullptr ? "?" : to->name);
}

}  // namespace braitenlab
