#include "ui/wiring/piece.h"

#include <algorithm>

namespace braitenlab {
namespace {

using maths::vec2;

// What the node is within the piece; nothing where it stays outside.
std::optional<BrainPiece::End> end_of(const BrainGraph& graph, const BrainPiece& piece, const std::set<NodeId>& chosen,
                                      NodeId id) {
    for (std::size_t i = 0; i < piece.neurons.size(); ++i)
        if (piece.neurons[i].id == id) return BrainPiece::End{static_cast<int>(i), {}};
    const Node* node = find_node(graph, id);
    if (node == nullptr || chosen.count(id) == 0) return {};
    return BrainPiece::End{-1, node->name};
}

std::optional<NodeId> id_of(const BrainGraph& graph, const std::vector<NodeId>& made, const BrainPiece::End& end) {
    if (end.neuron >= 0) return made[static_cast<std::size_t>(end.neuron)];
    const Node* node = find_node(graph, end.outer);
    return node == nullptr || node->kind == NodeKind::neuron ? std::nullopt : std::optional(node->id);
}

}  // namespace

BrainPiece copy(const BrainGraph& graph, const Layout& layout, const std::set<NodeId>& nodes) {
    BrainPiece piece;
    vec2 middle;
    for (const Node& node : graph.nodes) {
        if (node.kind != NodeKind::neuron || nodes.count(node.id) == 0) continue;
        piece.neurons.push_back(node);
        const NodeShape* shape = find_shape(layout, node.id);
        piece.places.push_back(shape == nullptr ? vec2{} : shape->centre);
        middle += piece.places.back();
    }
    for (vec2& place : piece.places) place -= middle / static_cast<float>(piece.places.size());
    for (const Wire& wire : graph.wires) {
        const auto from = end_of(graph, piece, nodes, wire.from), to = end_of(graph, piece, nodes, wire.to);
        const bool within = from && to && (from->neuron >= 0 || to->neuron >= 0);
        if (within) piece.wires.push_back({*from, *to, wire});
    }
    return piece;
}

Pasted paste(const BrainGraph& graph, const BrainPiece& piece, vec2 middle) {
    if (piece.empty()) return {{{}, "wiring.refused.nothing_copied"}, {}};
    Pasted pasted;
    BrainGraph edited = graph;
    std::vector<NodeId> made;
    for (std::size_t i = 0; i < piece.neurons.size(); ++i) {
        Edit added = add_neuron(edited, piece.neurons[i]);
        if (!added) return {added, {}};
        edited = std::move(*added.graph);
        made.push_back(edited.nodes.back().id);
        edited.nodes.back().place = on_canvas(middle + piece.places[i]);
        pasted.nodes.insert(made.back());
    }
    for (const BrainPiece::Joint& joint : piece.wires) {
        const auto from = id_of(edited, made, joint.from), to = id_of(edited, made, joint.to);
        if (!from || !to) continue;
        if (edited.wires.size() >= static_cast<std::size_t>(limits::wires)) return {{{}, "wiring.refused.wires"}, {}};
        edited.wires.push_back(joint.wire);
        edited.wires.back().from = *from, edited.wires.back().to = *to;
    }
    pasted.edit.graph = std::move(edited);
    return pasted;
}

}  // namespace braitenlab
