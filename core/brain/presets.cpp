#include "core/brain/presets.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/brain/four_neurons.h"

namespace braitenlab {

namespace {

Wire& add_wire(BrainGraph& graph, const char* from, const char* to, float weight) {
    return graph.wires.emplace_back(
        Wire{.from = find_node(graph, from)->id, .to = find_node(graph, to)->id, .weight = weight});
}

NodeId next_id(const BrainGraph& graph) { return static_cast<NodeId>(graph.nodes.size()); }

void add_sensor(BrainGraph& graph, const char* name) {
    graph.nodes.push_back({.id = next_id(graph), .kind = NodeKind::sensor, .name = name});
}

// A linear neuron without memory.
Node& add_linear(BrainGraph& graph, const char* name) {
    return graph.nodes.emplace_back(Node{.id = next_id(graph), .kind = NodeKind::neuron, .name = name});
}

// A threshold unit: 1 when the sum of its inputs reaches the threshold, else 0.
void add_threshold_unit(BrainGraph& graph, const char* name, float threshold) {
    add_linear(graph, name).curve = {.response = Response::step, .peak = threshold};
}

// Two sensors with wires to the motors of the same side, or of the other side when `crossed`.
void add_pair(BrainGraph& graph, const char* left, const char* right, float weight, bool crossed) {
    add_sensor(graph, left);
    add_sensor(graph, right);
    add_wire(graph, left, crossed ? "MR" : "ML", weight);
    add_wire(graph, right, crossed ? "ML" : "MR", weight);
}

// Vehicle 3c: coward for heat, aggressor for light, love for smell, explorer for oxygen.
BrainGraph values() {
    BrainGraph graph = make_graph({.LR = 0.8f, .RL = 0.8f, .LM = 0.4f, .RM = 0.4f});
    add_pair(graph, "HL", "HR", 1.5f, false);
    add_pair(graph, "NL", "NR", -1.0f, false);
    add_pair(graph, "AL", "AR", -0.6f, true);
    return graph;
}

// Vehicle 4a: an aggressor whose wires have their largest output for a medium signal. It turns towards a far lamp and
// away from a near one, so that it circles.
BrainGraph orbit() {
    BrainGraph graph = make_graph({.LR = 0.5f, .RL = 0.5f, .LM = 0.4f, .RM = 0.4f});
    for (Wire& wire : graph.wires)
        if (wire.weight != 0) wire.curve = {Response::hump, 0.15f, 0.12f};
    return graph;
}

// Vehicle 4b: the output of its wires is 0 below the step and full above it.
BrainGraph decision() {
    BrainGraph graph = make_graph({.LR = 1, .RL = 1, .LM = 0.3f, .RM = 0.3f});
    for (Wire& wire : graph.wires)
        if (wire.weight != 0) wire.curve = {.response = Response::step, .peak = 0.3f};
    return graph;
}

// Vehicle 5: a counter of threshold units. SEEN: a sensor has a stimulus (OR). WAS: SEEN one tick earlier. NEW: SEEN
// starts (SEEN and not WAS). ONE, TWO, THREE stay on; NEW switches each on when the previous one is on (AND). THREE
// stops the motors.
BrainGraph logic() {
    BrainGraph graph = make_graph({.LM = 0.5f, .RM = 0.5f});
    add_threshold_unit(graph, "SEEN", 0.5f);
    add_linear(graph, "WAS");
    add_threshold_unit(graph, "NEW", 0.5f);
    add_threshold_unit(graph, "ONE", 0.5f);
    add_threshold_unit(graph, "TWO", 1.5f);
    add_threshold_unit(graph, "THREE", 1.5f);
    add_wire(graph, "SL", "SEEN", 1);
    add_wire(graph, "SR", "SEEN", 1);
    add_wire(graph, "SEEN", "WAS", 1);
    add_wire(graph, "SEEN", "NEW", 1);
    add_wire(graph, "WAS", "NEW", -1);
    for (const char* count : {"ONE", "TWO", "THREE"}) {
        add_wire(graph, "NEW", count, 1);
        add_wire(graph, count, count, 2);
    }
    add_wire(graph, "ONE", "TWO", 1);
    add_wire(graph, "TWO", "THREE", 1);
    add_wire(graph, "THREE", "ML", -0.5f);
    add_wire(graph, "THREE", "MR", -0.5f);
    return graph;
}

// Vehicle 7: FEAR responds to heat and turns the vehicle away. A Hebbian wire links SEES to FEAR when both are on; then
// light alone switches FEAR on. The link fades.
BrainGraph mnemotrix() {
    BrainGraph graph = make_graph({.LM = 0.4f, .RM = 0.4f});
    for (const char* name : {"HL", "HR"}) add_sensor(graph, name);
    add_threshold_unit(graph, "SEES", 0.4f);
    add_threshold_unit(graph, "FEAR", 0.5f);
    for (const char* eye : {"SL", "SR"}) add_wire(graph, eye, "SEES", 1);
    for (const char* skin : {"HL", "HR"}) add_wire(graph, skin, "FEAR", 2);
    Wire& link = add_wire(graph, "SEES", "FEAR", 0);
    link.learning_rate = 4;
    link.decay = 0.02f;
    add_wire(graph, "FEAR", "ML", 0.3f);
    add_wire(graph, "FEAR", "MR", -0.7f);
    return graph;
}

// The tortoise's response to light. CIRCLE: a hump, as vehicle 4a. HUNGRY: on below energy 0.4 until energy 0.9; it
// shifts CIRCLE's input beyond the hump and enables SEEK, which drives to the light. HOME stops the motors below a
// bright lamp.
void add_homing(BrainGraph& graph) {
    add_sensor(graph, "EN");
    add_threshold_unit(graph, "HUNGRY", -0.4f);
    add_wire(graph, "EN", "HUNGRY", -1);
    add_wire(graph, "HUNGRY", "HUNGRY", 0.5f);
    add_sensor(graph, "UP");
    add_threshold_unit(graph, "HOME", 1.6f);
    add_wire(graph, "UP", "HOME", 1);
    add_wire(graph, "HUNGRY", "HOME", 1);
    add_wire(graph, "HOME", "ML", -0.4f);
    add_wire(graph, "HOME", "MR", -0.36f);
    for (const bool left : {true, false}) {
        const char *eye = left ? "SL" : "SR", *far_motor = left ? "MR" : "ML";
        const char *circle = left ? "CIRCLE_L" : "CIRCLE_R", *seek = left ? "SEEK_L" : "SEEK_R";
        add_linear(graph, circle).curve = {Response::hump, 0.15f, 0.12f};
        add_wire(graph, eye, circle, 1);
        add_wire(graph, "HUNGRY", circle, 2);
        add_wire(graph, circle, far_motor, 0.5f);
        Node& unit = add_linear(graph, seek);
        unit.bias = -1;
        unit.curve.response = Response::rectified;
        add_wire(graph, eye, seek, 1);
        add_wire(graph, "HUNGRY", seek, 1);
        add_wire(graph, "HOME", seek, -2);
        add_wire(graph, seek, far_motor, 1.2f);
    }
}

// The tortoise's response to contact. BUMPED stays on until LAPSE, which follows it slowly, switches it off: it backs
// off and turns for about half a second. Remembered obstacles (QL, QR) turn it away before contact.
void add_bumper(BrainGraph& graph) {
    add_sensor(graph, "TC");
    add_threshold_unit(graph, "BUMPED", 0.5f);
    add_linear(graph, "LAPSE").time_constant = 0.8f;
    add_wire(graph, "TC", "BUMPED", 1);
    add_wire(graph, "BUMPED", "BUMPED", 1);
    add_wire(graph, "BUMPED", "LAPSE", 1);
    add_wire(graph, "LAPSE", "BUMPED", -1);
    add_wire(graph, "BUMPED", "ML", -1.2f);
    add_wire(graph, "BUMPED", "MR", -0.7f);
    add_pair(graph, "QL", "QR", 0.4f, false);
    add_wire(graph, "QL", "MR", -0.4f);
    add_wire(graph, "QR", "ML", -0.4f);
}

// Grey Walter's Machina Speculatrix: explores in wide arcs, circles lights, backs off after contact, and drives to a
// bright light when its energy is low.
BrainGraph tortoise() {
    BrainGraph graph = make_graph({.LM = 0.4f, .RM = 0.36f});
    add_homing(graph);
    add_bumper(graph);
    return graph;
}

std::vector<Preset> make_presets() {
    std::vector<Preset> list;
    const auto add = [&](std::string_view name, BrainGraph brain) { list.push_back({name, name, std::move(brain)}); };
    const auto add_four = [&](std::string_view name, const FourNeurons& four) { add(name, make_graph(four)); };
    add_four("1-alive", {.LL = 0.5f, .LR = 0.5f, .RL = 0.5f, .RR = 0.5f, .LM = 0.1f, .RM = 0.1f});
    add_four("2a-coward", {.LL = 1.5f, .RR = 1.5f, .LM = 0.1f, .RM = 0.1f});
    add_four("2b-aggressor", {.LR = 1.5f, .RL = 1.5f, .LM = 0.1f, .RM = 0.1f});
    add_four("2c", {.LL = 0.75f, .LR = 0.75f, .RL = 0.75f, .RR = 0.75f, .LM = 0.1f, .RM = 0.1f});
    add_four("3a-love", {.LL = -1.0f, .RR = -1.0f, .LM = 0.5f, .RM = 0.5f});
    add_four("3b-explorer", {.LR = -1.0f, .RL = -1.0f, .LM = 0.6f, .RM = 0.6f});
    add("3c-values", values());
    add("4a-orbit", orbit());
    add("4b-decision", decision());
    add("5-logic", logic());
    add("7-mnemotrix", mnemotrix());
    add("tortoise", tortoise());
    add_four("predator", {.LR = 0.4f, .RL = 0.4f, .LM = 0.25f, .RM = 0.25f});
    add_four("prey", {.LL = 2, .RR = 2, .LM = 0.2f, .RM = 0.2f});
    for (Preset& hunt : list)
        if (hunt.name == "predator" || hunt.name == "prey") hunt.scene = "predator-prey";
    return list;
}

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

std::span<const Preset> presets() {
    static const std::vector<Preset> list = make_presets();
    return list;
}

const Preset* find_preset(std::string_view name) {
    const auto list = presets();
    const auto found = std::find_if(list.begin(), list.end(), [&](const Preset& p) { return p.name == name; });
    return found == list.end() ? nullptr : &*found;
}

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
