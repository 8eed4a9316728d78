#include "core/brain/graph.h"

#include <algorithm>

namespace braitenlab {

float let_through(const Wire& wire, float input) { return respond(wire.curve, masked(input, wire.threshold)); }

float signal(const Wire& wire, float input, float learned) {
    if (wire.cut) return 0;
    return (wire.weight + learned) * let_through(wire, input);
}

BrainGraph without_places(BrainGraph graph) {
    for (Node& node : graph.nodes) node.place.reset();
    return graph;
}

bool same_wiring(const BrainGraph& one, const BrainGraph& other) {
    return without_places(one) == without_places(other);
}

const Node* find_node(const BrainGraph& graph, NodeId id) {
    const auto found = std::find_if(graph.nodes.begin(), graph.nodes.end(), [&](const Node& n) { return n.id == id; });
    return found == graph.nodes.end() ? nullptr : &*found;
}

const Node* find_node(const BrainGraph& graph, const std::string& name) {
    const auto found =
        std::find_if(graph.nodes.begin(), graph.nodes.end(), [&](const Node& n) { return n.name == name; });
    return found == graph.nodes.end() ? nullptr : &*found;
}

Node* find_node(BrainGraph& graph, const std::string& name) {
    return const_cast<Node*>(find_node(static_cast<const BrainGraph&>(graph), name));
}

const Wire* find_wire(const BrainGraph& graph, NodeId from, NodeId to) {
    const auto found = std::find_if(graph.wires.begin(), graph.wires.end(),
                                    [&](const Wire& w) { return w.from == from && w.to == to; });
    return found == graph.wires.end() ? nullptr : &*found;
}

Wire* find_wire(BrainGraph& graph, NodeId from, NodeId to) {
    return const_cast<Wire*>(find_wire(static_cast<const BrainGraph&>(graph), from, to));
}

}  // namespace braitenlab
