#include "core/brain/graft.h"

#include <algorithm>
#include <map>
#include <set>

namespace braitenlab {

namespace {

// These nodes and the neurons that they feed, directly or through neurons.
std::set<NodeId> fed_by(const BrainGraph& brain, std::set<NodeId> nodes) {
    for (bool grows = true; grows;) {
        grows = false;
        for (const Wire& wire : brain.wires) {
            const Node* to = find_node(brain, wire.to);
            if (to && to->kind == NodeKind::neuron && nodes.count(wire.from) > 0) grows |= nodes.insert(wire.to).second;
        }
    }
    return nodes;
}

// The sensors that the preset does not have, and the neurons that only those feed.
std::set<NodeId> kept_nodes(const BrainGraph& brain, const BrainGraph& preset) {
    std::set<NodeId> others, replaced;
    for (const Node& node : brain.nodes) {
        const bool sensor = node.kind == NodeKind::sensor, known = find_node(preset, node.name) != nullptr;
        if (sensor && !known) others.insert(node.id);
        if ((sensor && known) || node.kind == NodeKind::motor) replaced.insert(node.id);
    }
    std::set<NodeId> stay = fed_by(brain, others);
    for (const NodeId id : fed_by(brain, replaced)) stay.erase(id);
    return stay;
}

std::string unused_name(const BrainGraph& brain, const std::string& wanted) {
    std::string name = wanted;
    for (int i = 2; find_node(brain, name); ++i) name = wanted + "-" + std::to_string(i);
    return name;
}

// Copies the positions of the preset's nodes from the brain. Removes all positions when the preset has neurons, because
// the brain has no positions for them.
void copy_positions(const BrainGraph& brain, const BrainGraph& preset, BrainGraph& made) {
    const bool brings_neurons = std::any_of(preset.nodes.begin(), preset.nodes.end(),
                                            [](const Node& node) { return node.kind == NodeKind::neuron; });
    if (brings_neurons) return void(made = without_places(std::move(made)));
    for (const Node& node : preset.nodes)
        if (const Node* before = find_node(brain, node.name)) find_node(made, node.name)->place = before->place;
}

}  // namespace

BrainGraph graft(const BrainGraph& brain, const BrainGraph& preset) {
    BrainGraph made = preset;
    std::map<NodeId, NodeId> new_ids;  // new ids of kept nodes and of motors
    NodeId next = 0;
    for (const Node& node : preset.nodes) next = std::max(next, node.id + 1);
    const std::set<NodeId> stay = kept_nodes(brain, preset);
    for (const Node& node : brain.nodes) {
        const Node* motor = node.kind == NodeKind::motor ? find_node(preset, node.name) : nullptr;
        if (motor) new_ids[node.id] = motor->id;
        if (stay.count(node.id) == 0) continue;
        Node moved = node;
        moved.id = new_ids[node.id] = next++;
        moved.name = unused_name(made, node.name);
        made.nodes.push_back(moved);
    }
    for (const Wire& wire : brain.wires) {
        if (stay.count(wire.from) == 0 || new_ids.count(wire.to) == 0) continue;
        Wire moved = wire;
        moved.from = new_ids[wire.from], moved.to = new_ids[wire.to];
        made.wires.push_back(moved);
    }
    copy_positions(brain, preset, made);
    return made;
}

std::vector<std::string> kept_by_graft(const BrainGraph& brain, const BrainGraph& preset) {
    const std::set<NodeId> stay = kept_nodes(brain, preset);
    std::vector<std::string> names;
    for (const Node& node : brain.nodes) {
        const bool wired = std::any_of(brain.wires.begin(), brain.wires.end(),
                                       [&](const Wire& w) { return w.from == node.id && w.weight != 0; });
        if (node.kind == NodeKind::sensor && stay.count(node.id) > 0 && wired) names.push_back(node.name);
    }
    return names;
}

}  // namespace braitenlab
