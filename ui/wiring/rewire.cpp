#include "ui/wiring/rewire.h"

#include <algorithm>
#include <cmath>

namespace braitenlab {
namespace {

constexpr float longest_memory = 600;  // s, of a time constant

// Into its range; what is not finite gives way to the number that was there.
float ranged(float wanted, float before, float low, float high) {
    return std::isfinite(wanted) ? std::clamp(wanted, low, high) : before;
}

Curve ranged(const Curve& wanted, const Curve& before) {
    Curve curve = wanted;
    curve.peak = ranged(wanted.peak, before.peak, -2, 2);
    curve.width = ranged(wanted.width, before.width, 0.001f, 10);
    return curve;
}

bool has(const std::set<NodeId>& nodes, NodeId id) { return nodes.count(id) > 0; }

NeuronKind kind_of(std::string_view words, Response response, float time_constant = 0) {
    NeuronKind kind{words, {}};
    kind.made.curve.response = response;
    kind.made.time_constant = time_constant;
    return kind;
}

}  // namespace

Edit reconnect(const BrainGraph& graph, WireEnds wire, WireEnds to) {
    const Wire* found = find_wire(graph, wire.from, wire.to);
    if (found == nullptr || (found->weight == 0 && !learns(*found))) return {{}, "wiring.refused.gone"};
    const Wire numbers = *found;
    Edit moved = remove(graph, {}, {wire});
    if (moved) moved = connect(*moved.graph, to);
    if (!moved) return moved;
    Wire& there = *find_wire(*moved.graph, to.from, to.to);
    there = numbers;
    there.from = to.from, there.to = to.to;
    return moved;
}

Edit insert(const BrainGraph& graph, NodeId neuron, WireEnds into) {
    if (into.from == neuron || into.to == neuron) return {{}, "wiring.refused.own_wire"};
    const Edit moved = reconnect(graph, into, {into.from, neuron});
    return moved ? connect(*moved.graph, {neuron, into.to}) : moved;
}

Edit detach(const BrainGraph& graph, const std::set<NodeId>& nodes) {
    std::set<WireEnds> wires;
    for (const Wire& wire : graph.wires)
        if (has(nodes, wire.from) || has(nodes, wire.to)) wires.insert({wire.from, wire.to});
    return wires.empty() ? Edit{{}, "wiring.refused.no_wires"} : remove(graph, {}, wires);
}

Edit lesion(const BrainGraph& graph, const std::set<NodeId>& nodes, const std::set<WireEnds>& wires, bool hurt) {
    BrainGraph edited = graph;
    for (Node& node : edited.nodes)
        if (has(nodes, node.id)) node.silenced = hurt;
    for (Wire& wire : edited.wires)
        if (wires.count({wire.from, wire.to}) > 0) wire.cut = hurt;
    if (edited == graph) return {{}, "wiring.refused.nothing_to_cut"};
    return {edited, {}};
}

bool all_hurt(const BrainGraph& graph, const std::set<NodeId>& nodes, const std::set<WireEnds>& wires) {
    bool any = false;
    for (const Node& node : graph.nodes)
        if (has(nodes, node.id)) {
            any = true;
            if (!node.silenced) return false;
        }
    for (const Wire& wire : graph.wires)
        if (wires.count({wire.from, wire.to}) > 0) {
            any = true;
            if (!wire.cut) return false;
        }
    return any;
}

Edit replace(const BrainGraph& graph, const Node& wanted) {
    BrainGraph edited = graph;
    const auto found =
        std::find_if(edited.nodes.begin(), edited.nodes.end(), [&](const Node& n) { return n.id == wanted.id; });
    if (found == edited.nodes.end()) return {{}, "wiring.refused.gone"};
    found->curve = ranged(wanted.curve, found->curve);
    found->bias = ranged(wanted.bias, found->bias, -limits::bias, limits::bias);
    found->time_constant = ranged(wanted.time_constant, found->time_constant, 0, longest_memory);
    found->silenced = wanted.silenced;
    return {edited, {}};
}

Edit replace(const BrainGraph& graph, const Wire& wanted) {
    BrainGraph edited = graph;
    Wire* found = find_wire(edited, wanted.from, wanted.to);
    if (found == nullptr) return {{}, "wiring.refused.gone"};
    found->weight = ranged(wanted.weight, found->weight, -limits::weight, limits::weight);
    found->threshold = ranged(wanted.threshold, found->threshold, 0, limits::threshold);
    found->curve = ranged(wanted.curve, found->curve);
    found->learning_rate = ranged(wanted.learning_rate, found->learning_rate, 0, limits::learning_rate);
    found->decay = ranged(wanted.decay, found->decay, 0, limits::decay);
    found->cut = wanted.cut;
    return {edited, {}};
}

bool is_wired(const BrainGraph& graph, NodeId node) {
    return std::any_of(graph.wires.begin(), graph.wires.end(),
                       [&](const Wire& wire) { return (wire.from == node || wire.to == node) && wire.weight != 0; });
}

const std::array<NeuronKind, neuron_kind_count>& neuron_kinds() {
    static const std::array<NeuronKind, neuron_kind_count> kinds{
        kind_of("wiring.kind.linear", Response::linear),      kind_of("wiring.kind.rectified", Response::rectified),
        kind_of("wiring.kind.step", Response::step),          kind_of("wiring.kind.sigmoid", Response::sigmoid),
        kind_of("wiring.kind.hump", Response::hump),          kind_of("wiring.kind.inverted", Response::inverted),
        kind_of("wiring.kind.leaky", Response::linear, 0.5f),
    };
    return kinds;
}

}  // namespace braitenlab
