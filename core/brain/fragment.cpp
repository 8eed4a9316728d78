#include "core/brain/fragment.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace braitenlab {
namespace {

using maths::vec2;

// The end of a connection that refers to the node; nullopt for a node that is not part of the fragment.
std::optional<BrainFragment::End> end_within(const BrainGraph& graph, const BrainFragment& fragment,
                                             const std::set<NodeId>& chosen, NodeId id) {
    for (std::size_t i = 0; i < fragment.neurons.size(); ++i)
        if (fragment.neurons[i].id == id) return BrainFragment::End{static_cast<int>(i)};
    const Node* node = find_node(graph, id);
    if (node == nullptr || chosen.count(id) == 0) return std::nullopt;
    return BrainFragment::End{-1, node->name};
}

// The node of the graph that an end of a fragment refers to; nullopt if the graph does not have it.
std::optional<NodeId> id_of(const BrainGraph& graph, const std::vector<NodeId>& added, const BrainFragment::End& end) {
    if (end.neuron >= 0) return added[static_cast<std::size_t>(end.neuron)];
    const Node* node = find_node(graph, end.outer_name);
    return node == nullptr || node->kind == NodeKind::neuron ? std::nullopt : std::optional(node->id);
}

}  // namespace

BrainFragment copy_fragment(const BrainGraph& graph, const std::set<NodeId>& nodes) {
    BrainFragment fragment;
    vec2 sum;
    for (const Node& node : graph.nodes) {
        if (node.kind != NodeKind::neuron || nodes.count(node.id) == 0) continue;
        fragment.neurons.push_back(node);
        sum += node.place.value_or(vec2{});
    }
    for (Node& node : fragment.neurons)
        node.place = node.place.value_or(vec2{}) - sum / static_cast<float>(fragment.neurons.size());
    for (const Wire& wire : graph.wires) {
        const auto from = end_within(graph, fragment, nodes, wire.from),
                   to = end_within(graph, fragment, nodes, wire.to);
        const bool joins_a_neuron = from && to && (from->neuron >= 0 || to->neuron >= 0);
        if (joins_a_neuron) fragment.connections.push_back({*from, *to, wire});
    }
    return fragment;
}

Pasted paste_fragment(const BrainGraph& graph, const BrainFragment& fragment, vec2 middle) {
    if (fragment.empty()) return {Refusal::empty_fragment, {}};
    BrainGraph edited = graph;
    std::vector<NodeId> added;
    for (const Node& neuron : fragment.neurons) {
        Edit edit = add_neuron(edited, neuron);
        if (!edit) return {edit, {}};
        edited = std::move(*edit.graph);
        edited.nodes.back().place = rounded_position(middle + neuron.place.value_or(vec2{}));
        added.push_back(edited.nodes.back().id);
    }
    for (const BrainFragment::Connection& connection : fragment.connections) {
        const auto from = id_of(edited, added, connection.from), to = id_of(edited, added, connection.to);
        if (!from || !to) continue;
        if (edited.wires.size() >= static_cast<std::size_t>(limits::wires)) return {Refusal::too_many_wires, {}};
        edited.wires.push_back(connection.parameters);
        edited.wires.back().from = *from, edited.wires.back().to = *to;
    }
    return {std::move(edited), {added.begin(), added.end()}};
}

vec2 rounded_position(vec2 position) {
    return {std::clamp(std::round(position.x), -limits::place, limits::place),
            std::clamp(std::round(position.y), -limits::place, limits::place)};
}

}  // namespace braitenlab
