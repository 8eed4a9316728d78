#include "core/brain/edit.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/brain/four_neurons.h"

namespace braitenlab {
namespace {

std::optional<Refusal> refusal_of_wire(const BrainGraph& graph, WireEnds ends) {
    const Node* from = find_node(graph, ends.from);
    const Node* to = find_node(graph, ends.to);
    if (from == nullptr || to == nullptr) return Refusal::missing;
    if (to->kind == NodeKind::sensor) return Refusal::into_sensor;
    return std::nullopt;
}

std::string free_neuron_name(const BrainGraph& graph) {
    for (int number = 1;; ++number) {
        std::string name = "N" + std::to_string(number);
        if (find_node(graph, name) == nullptr) return name;
    }
}

// `wanted` clamped to its range, or `before` if it is not finite.
float ranged(float wanted, float before, float low, float high) {
    return std::isfinite(wanted) ? std::clamp(wanted, low, high) : before;
}

Curve ranged(const Curve& wanted, const Curve& before) {
    Curve curve = wanted;
    curve.peak = ranged(wanted.peak, before.peak, -limits::peak, limits::peak);
    curve.width = ranged(wanted.width, before.width, limits::least_width, limits::width);
    return curve;
}

bool contains(const std::set<NodeId>& nodes, NodeId id) { return nodes.count(id) > 0; }

}  // namespace

std::string_view name(Refusal refusal) {
    for (const RefusalName& row : refusals)
        if (row.value == refusal) return row.word;
    return {};
}

Node make_neuron(const NeuronKind& kind) {
    Node node;
    node.curve = kind.curve;
    node.time_constant = kind.time_constant;
    return node;
}

NodeId fresh_id(const BrainGraph& graph) {
    NodeId largest = -1;
    for (const Node& node : graph.nodes) largest = std::max(largest, node.id);
    return largest + 1;
}

Edit add_neuron(const BrainGraph& graph, const Node& model) {
    const auto neurons =
        std::count_if(graph.nodes.begin(), graph.nodes.end(), [](const Node& n) { return n.kind == NodeKind::neuron; });
    if (neurons >= limits::neurons) return Refusal::too_many_neurons;
    BrainGraph edited = graph;
    Node node = model;
    node.id = fresh_id(graph);
    node.kind = NodeKind::neuron;
    if (node.name.empty() || find_node(graph, node.name) != nullptr) node.name = free_neuron_name(graph);
    edited.nodes.push_back(node);
    return edited;
}

Edit connect(const BrainGraph& graph, WireEnds ends) {
    if (const auto refusal = refusal_of_wire(graph, ends)) return *refusal;
    const Wire* wire = find_wire(graph, ends.from, ends.to);
    if (wire != nullptr && (wire->weight != 0 || learns(*wire))) return Refusal::duplicate;
    return set_weight(graph, ends, 1);
}

Edit set_weight(const BrainGraph& graph, WireEnds ends, float weight) {
    if (const auto refusal = refusal_of_wire(graph, ends)) return *refusal;
    BrainGraph edited = graph;
    if (!std::isfinite(weight)) return edited;
    weight = std::clamp(weight, -limits::weight, limits::weight);
    if (Wire* wire = find_wire(edited, ends.from, ends.to)) {
        wire->weight = weight;
        return edited;
    }
    if (edited.wires.size() >= static_cast<std::size_t>(limits::wires)) return Refusal::too_many_wires;
    Wire wire;
    wire.from = ends.from, wire.to = ends.to, wire.weight = weight;
    edited.wires.push_back(wire);
    return edited;
}

Edit set_parameters(const BrainGraph& graph, const Node& wanted) {
    BrainGraph edited = graph;
    const auto found =
        std::find_if(edited.nodes.begin(), edited.nodes.end(), [&](const Node& n) { return n.id == wanted.id; });
    if (found == edited.nodes.end()) return Refusal::missing;
    found->curve = ranged(wanted.curve, found->curve);
    found->bias = ranged(wanted.bias, found->bias, -limits::bias, limits::bias);
    found->time_constant = ranged(wanted.time_constant, found->time_constant, 0, limits::time_constant);
    found->silenced = wanted.silenced;
    return edited;
}

Edit set_parameters(const BrainGraph& graph, const Wire& wanted) {
    BrainGraph edited = graph;
    Wire* found = find_wire(edited, wanted.from, wanted.to);
    if (found == nullptr) return Refusal::missing;
    found->weight = ranged(wanted.weight, found->weight, -limits::weight, limits::weight);
    found->threshold = ranged(wanted.threshold, found->threshold, 0, limits::threshold);
    found->curve = ranged(wanted.curve, found->curve);
    found->learning_rate = ranged(wanted.learning_rate, found->learning_rate, 0, limits::learning_rate);
    found->decay = ranged(wanted.decay, found->decay, 0, limits::decay);
    found->cut = wanted.cut;
    return edited;
}

Edit reconnect(const BrainGraph& graph, WireEnds wire, WireEnds to) {
    const Wire* found = find_wire(graph, wire.from, wire.to);
    if (found == nullptr || (found->weight == 0 && !learns(*found))) return Refusal::missing;
    const Wire parameters = *found;
    Edit moved = remove(graph, {}, {wire});
    if (moved) moved = connect(*moved.graph, to);
    if (!moved) return moved;
    Wire& made = *find_wire(*moved.graph, to.from, to.to);
    made = parameters;
    made.from = to.from, made.to = to.to;
    return moved;
}

Edit insert_neuron(const BrainGraph& graph, NodeId neuron, WireEnds into) {
    if (into.from == neuron || into.to == neuron) return Refusal::own_wire;
    const Edit moved = reconnect(graph, into, {into.from, neuron});
    return moved ? connect(*moved.graph, {neuron, into.to}) : moved;
}

Edit remove(const BrainGraph& graph, const std::set<NodeId>& nodes, const std::set<WireEnds>& wires) {
    BrainGraph edited = graph;
    const auto is_removed = [&](NodeId id) {
        const Node* node = find_node(graph, id);
        return contains(nodes, id) && node != nullptr && node->kind == NodeKind::neuron;
    };
    std::erase_if(edited.nodes, [&](const Node& node) { return is_removed(node.id); });
    std::erase_if(edited.wires, [&](const Wire& wire) {
        const WireEnds ends{wire.from, wire.to};
        return is_removed(wire.from) || is_removed(wire.to) || (wires.count(ends) > 0 && !direct_dial(graph, ends));
    });
    for (Wire& wire : edited.wires) {
        if (wires.count({wire.from, wire.to}) == 0) continue;
        Wire empty;
        empty.from = wire.from, empty.to = wire.to, empty.weight = 0;
        wire = empty;
    }
    if (edited == graph) return nodes.empty() ? Refusal::nothing_to_remove : Refusal::fixed_node;
    return edited;
}

Edit detach(const BrainGraph& graph, const std::set<NodeId>& nodes) {
    std::set<WireEnds> wires;
    for (const Wire& wire : graph.wires)
        if (contains(nodes, wire.from) || contains(nodes, wire.to)) wires.insert({wire.from, wire.to});
    return wires.empty() ? Edit(Refusal::no_wires) : remove(graph, {}, wires);
}

Edit set_lesion(const BrainGraph& graph, const std::set<NodeId>& nodes, const std::set<WireEnds>& wires,
                bool lesioned) {
    BrainGraph edited = graph;
    for (Node& node : edited.nodes)
        if (contains(nodes, node.id)) node.silenced = lesioned;
    for (Wire& wire : edited.wires)
        if (wires.count({wire.from, wire.to}) > 0) wire.cut = lesioned;
    if (edited == graph) return Refusal::nothing_to_lesion;
    return edited;
}

bool all_lesioned(const BrainGraph& graph, const std::set<NodeId>& nodes, const std::set<WireEnds>& wires) {
    bool any = false;
    for (const Node& node : graph.nodes) {
        if (!contains(nodes, node.id)) continue;
        if (!node.silenced) return false;
        any = true;
    }
    for (const Wire& wire : graph.wires) {
        if (wires.count({wire.from, wire.to}) == 0) continue;
        if (!wire.cut) return false;
        any = true;
    }
    return any;
}

bool is_wired(const BrainGraph& graph, NodeId node) {
    return std::any_of(graph.wires.begin(), graph.wires.end(),
                       [&](const Wire& wire) { return (wire.from == node || wire.to == node) && wire.weight != 0; });
}

float weight_of(const BrainGraph& graph, WireEnds ends) {
    const Wire* wire = find_wire(graph, ends.from, ends.to);
    return wire == nullptr ? 0 : wire->weight;
}

}  // namespace braitenlab
