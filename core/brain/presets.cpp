#include "core/brain/presets.h"

#include <algorithm>
#include <string>
#include <vector>

#include "core/brain/four_neurons.h"

namespace braitenlab {

namespace {

Wire& connect(BrainGraph& graph, const char* from, const char* to, float weight) {
    return graph.wires.emplace_back(
        Wire{.from = find_node(graph, from)->id, .to = find_node(graph, to)->id, .weight = weight});
}

NodeId next_id(const BrainGraph& graph) { return static_cast<NodeId>(graph.nodes.size()); }

void add_sensor(BrainGraph& graph, const char* name) {
    graph.nodes.push_back({.id = next_id(graph), .kind = NodeKind::sensor, .name = name});
}

// A neuron that answers at once with its sum.
Node& add_neuron(BrainGraph& graph, const char* name) {
    return graph.nodes.emplace_back(Node{.id = next_id(graph), .kind = NodeKind::neuron, .name = name});
}

// A threshold unit: 1 where what its wires deliver adds up to the threshold, else 0.
void add_threshold_unit(BrainGraph& graph, const char* name, float threshold) {
    add_neuron(graph, name).curve = {.response = Response::step, .peak = threshold};
}

// Two eyes whose wires run to the wheels on their own side, or crossed to the other's.
void add_pair(BrainGraph& graph, const char* left, const char* right, float weight, bool crossed) {
    add_sensor(graph, left);
    add_sensor(graph, right);
    connect(graph, left, crossed ? "MR" : "ML", weight);
    connect(graph, right, crossed ? "ML" : "MR", weight);
}

// Vehicle 3c: it dislikes heat, attacks light, loves smell and explores for oxygen.
BrainGraph values() {
    BrainGraph graph = make_graph({.LR = 0.8f, .RL = 0.8f, .LM = 0.4f, .RM = 0.4f});
    add_pair(graph, "HL", "HR", 1.5f, false);
    add_pair(graph, "NL", "NR", -1.0f, false);
    add_pair(graph, "AL", "AR", -0.6f, true);
    return graph;
}

// Vehicle 4a: the crossed wires of the aggressor, but a strong signal counts for less than a middling one. It turns
// towards a faint lamp and away from a near one, and so it circles.
BrainGraph orbit() {
    BrainGraph graph = make_graph({.LR = 0.5f, .RL = 0.5f, .LM = 0.4f, .RM = 0.4f});
    for (Wire& wire : graph.wires)
        if (wire.weight != 0) wire.curve = {Response::hump, 0.15f, 0.12f};
    return graph;
}

// Vehicle 4b: nothing happens below the step, and everything above it.
BrainGraph decision() {
    BrainGraph graph = make_graph({.LR = 1, .RL = 1, .LM = 0.3f, .RM = 0.3f});
    for (Wire& wire : graph.wires)
        if (wire.weight != 0) wire.curve = {.response = Response::step, .peak = 0.3f};
    return graph;
}

// Vehicle 5: threshold units that count. SEEN says whether either eye sees anything (OR), WAS what SEEN said a tick
// before, NEW whether that has just begun (SEEN and not WAS). ONE, TWO, THREE hold for good once they are on: each
// takes the next NEW, provided the one before it was on already (AND). THREE stops the motors.
BrainGraph logic() {
    BrainGraph graph = make_graph({.LM = 0.5f, .RM = 0.5f});
    add_threshold_unit(graph, "SEEN", 0.5f);
    add_neuron(graph, "WAS");
    add_threshold_unit(graph, "NEW", 0.5f);
    add_threshold_unit(graph, "ONE", 0.5f);
    add_threshold_unit(graph, "TWO", 1.5f);
    add_threshold_unit(graph, "THREE", 1.5f);
    connect(graph, "SL", "SEEN", 1);
    connect(graph, "SR", "SEEN", 1);
    connect(graph, "SEEN", "WAS", 1);
    connect(graph, "SEEN", "NEW", 1);
    connect(graph, "WAS", "NEW", -1);
    for (const char* count : {"ONE", "TWO", "THREE"}) {
        connect(graph, "NEW", count, 1);
        connect(graph, count, count, 2);
    }
    connect(graph, "ONE", "TWO", 1);
    connect(graph, "TWO", "THREE", 1);
    connect(graph, "THREE", "ML", -0.5f);
    connect(graph, "THREE", "MR", -0.5f);
    return graph;
}

// Vehicle 7: FEAR answers to heat by birth, and turns the vehicle away. What it SEES together with heat becomes linked
// to FEAR, and then frightens by itself; the link fades.
BrainGraph mnemotrix() {
    BrainGraph graph = make_graph({.LM = 0.4f, .RM = 0.4f});
    for (const char* name : {"HL", "HR"}) add_sensor(graph, name);
    add_threshold_unit(graph, "SEES", 0.4f);
    add_threshold_unit(graph, "FEAR", 0.5f);
    for (const char* eye : {"SL", "SR"}) connect(graph, eye, "SEES", 1);
    for (const char* skin : {"HL", "HR"}) connect(graph, skin, "FEAR", 2);
    Wire& link = connect(graph, "SEES", "FEAR", 0);
    link.learning_rate = 4;
    link.decay = 0.02f;
    connect(graph, "FEAR", "ML", 0.3f);
    connect(graph, "FEAR", "MR", -0.7f);
    return graph;
}

// Light for the tortoise: a middling signal counts for most, so it CIRCLEs every lamp as vehicle 4a does. HUNGRY below
// 0.4 of its energy and until it is full again to 0.9, it does not (2 is far beyond the hump) but SEEKs the light, and
// rests HOME right below a bright one.
void add_homing(BrainGraph& graph) {
    add_sensor(graph, "EN");
    add_threshold_unit(graph, "HUNGRY", -0.4f);
    connect(graph, "EN", "HUNGRY", -1);
    connect(graph, "HUNGRY", "HUNGRY", 0.5f);
    add_sensor(graph, "UP");
    add_threshold_unit(graph, "HOME", 1.6f);
    connect(graph, "UP", "HOME", 1);
    connect(graph, "HUNGRY", "HOME", 1);
    connect(graph, "HOME", "ML", -0.4f);
    connect(graph, "HOME", "MR", -0.36f);
    for (const bool left : {true, false}) {
        const char *eye = left ? "SL" : "SR", *far_motor = left ? "MR" : "ML";
        const char *circle = left ? "CIRCLE_L" : "CIRCLE_R", *seek = left ? "SEEK_L" : "SEEK_R";
        add_neuron(graph, circle).curve = {Response::hump, 0.15f, 0.12f};
        connect(graph, eye, circle, 1);
        connect(graph, "HUNGRY", circle, 2);
        connect(graph, circle, far_motor, 0.5f);
        Node& unit = add_neuron(graph, seek);
        unit.bias = -1;
        unit.curve.response = Response::rectified;
        connect(graph, eye, seek, 1);
        connect(graph, "HUNGRY", seek, 1);
        connect(graph, "HOME", seek, -2);
        connect(graph, seek, far_motor, 1.2f);
    }
}

// BUMPED holds itself on until LAPSE, which follows slowly, takes it away again: for about half a second it backs off,
// turning. What it remembers to have bumped into turns it away in time.
void add_bumper(BrainGraph& graph) {
    add_sensor(graph, "TC");
    add_threshold_unit(graph, "BUMPED", 0.5f);
    add_neuron(graph, "LAPSE").time_constant = 0.8f;
    connect(graph, "TC", "BUMPED", 1);
    connect(graph, "BUMPED", "BUMPED", 1);
    connect(graph, "BUMPED", "LAPSE", 1);
    connect(graph, "LAPSE", "BUMPED", -1);
    connect(graph, "BUMPED", "ML", -1.2f);
    connect(graph, "BUMPED", "MR", -0.7f);
    add_pair(graph, "QL", "QR", 0.4f, false);
    connect(graph, "QL", "MR", -0.4f);
    connect(graph, "QR", "ML", -0.4f);
}

// Grey Walter's Machina Speculatrix: explores in wide arcs, circles lights, backs off what it bumps into, and goes home
// when it is hungry.
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

}  // namespace braitenlab
