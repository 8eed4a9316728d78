#include "core/brain/four_neurons.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace braitenlab {

namespace {

// A dial's word, its number in FourNeurons, and the wire or motor that it belongs to.
struct DialEntry {
    std::string_view word;
    float FourNeurons::*value;
    std::string SensorPair::*sensor;  // null for a bias
    const char* motor;
};

constexpr std::array<DialEntry, all_dials.size()> entries{{
    {"LL", &FourNeurons::LL, &SensorPair::left, "ML"},
    {"LR", &FourNeurons::LR, &SensorPair::right, "ML"},
    {"RL", &FourNeurons::RL, &SensorPair::left, "MR"},
    {"RR", &FourNeurons::RR, &SensorPair::right, "MR"},
    {"threshold_LL", &FourNeurons::threshold_LL, &SensorPair::left, "ML"},
    {"threshold_LR", &FourNeurons::threshold_LR, &SensorPair::right, "ML"},
    {"threshold_RL", &FourNeurons::threshold_RL, &SensorPair::left, "MR"},
    {"threshold_RR", &FourNeurons::threshold_RR, &SensorPair::right, "MR"},
    {"LM", &FourNeurons::LM, nullptr, "ML"},
    {"RM", &FourNeurons::RM, nullptr, "MR"},
}};

static_assert(has_enumerators<Dial, entries.size()>());

const DialEntry& entry(Dial dial) { return entries[static_cast<std::size_t>(dial)]; }

const Node* sensor_of(const BrainGraph& graph, Dial dial, const SensorPair& pair) {
    return find_node(graph, pair.*entry(dial).sensor);
}

struct Ends {
    NodeId left_eye, right_eye, left_motor, right_motor;
};

std::optional<Ends> ends(const BrainGraph& brain, const SensorPair& pair) {
    const auto id = [&](const std::string& name, NodeKind kind) {
        const Node* node = find_node(brain, name);
        return node && node->kind == kind ? node->id : NodeId{-1};
    };
    const Ends e{id(pair.left, NodeKind::sensor), id(pair.right, NodeKind::sensor), id("ML", NodeKind::motor),
                 id("MR", NodeKind::motor)};
    const bool whole = e.left_eye >= 0 && e.right_eye >= 0 && e.left_motor >= 0 && e.right_motor >= 0;
    return whole ? std::optional(e) : std::nullopt;
}

// Sets the wire from `from` to `to` to the model, or removes it when the model is null. Lesions stay.
void copy_wire(BrainGraph& brain, const Wire* model, NodeId from, NodeId to) {
    Wire* wire = find_wire(brain, from, to);
    if (!model) {
        std::erase_if(brain.wires, [&](const Wire& w) { return w.from == from && w.to == to; });
        return;
    }
    Wire made = *model;
    made.from = from, made.to = to;
    made.cut = wire && wire->cut;
    if (wire)
        *wire = made;
    else
        brain.wires.push_back(made);
}

// Swaps the parameters of two wires, except lesions.
void swap_wires(BrainGraph& brain, NodeId eye, NodeId one_motor, NodeId other_motor) {
    const Wire* one = find_wire(brain, eye, one_motor);
    const Wire* other = find_wire(brain, eye, other_motor);
    const std::optional<Wire> first = one ? std::optional(*one) : std::nullopt;
    const std::optional<Wire> second = other ? std::optional(*other) : std::nullopt;
    copy_wire(brain, second ? &*second : nullptr, eye, one_motor);
    copy_wire(brain, first ? &*first : nullptr, eye, other_motor);
}

}  // namespace

std::string_view name(Dial dial) { return entry(dial).word; }

std::optional<Dial> dial_named(std::string_view word) {
    for (const Dial dial : all_dials)
        if (name(dial) == word) return dial;
    return std::nullopt;
}

DialRange range(Dial dial) {
    if (is_weight(dial)) return {-limits::weight, limits::weight};
    if (is_bias(dial)) return {-limits::bias, limits::bias};
    return {0, limits::threshold};
}

Dial threshold_of(Dial weight) {
    assert(is_weight(weight));
    return static_cast<Dial>(static_cast<int>(weight) + 4);
}

float& at(FourNeurons& four, Dial dial) { return four.*entry(dial).value; }
float at(const FourNeurons& four, Dial dial) { return four.*entry(dial).value; }

BrainGraph make_graph(const FourNeurons& four) {
    using namespace four_neuron_ids;
    BrainGraph graph;
    graph.nodes = {{.id = SL, .kind = NodeKind::sensor, .name = "SL"},
                   {.id = SR, .kind = NodeKind::sensor, .name = "SR"},
                   {.id = ML, .kind = NodeKind::motor, .name = "ML", .bias = four.LM},
                   {.id = MR, .kind = NodeKind::motor, .name = "MR", .bias = four.RM}};
    for (const Dial dial : weight_dials)
        graph.wires.push_back({.from = sensor_of(graph, dial, {})->id,
                               .to = find_node(graph, entry(dial).motor)->id,
                               .weight = at(four, dial),
                               .threshold = at(four, threshold_of(dial))});
    return graph;
}

bool is_four_neurons(const BrainGraph& graph) {
    BrainGraph given = without_places(graph), made = make_graph(read_dials(graph));
    const auto by_id = [](const Node& a, const Node& b) { return a.id < b.id; };
    const auto by_ends = [](const Wire& a, const Wire& b) { return a.from != b.from ? a.from < b.from : a.to < b.to; };
    for (BrainGraph* g : {&given, &made}) {
        std::sort(g->nodes.begin(), g->nodes.end(), by_id);
        std::sort(g->wires.begin(), g->wires.end(), by_ends);
    }
    return given == made;
}

FourNeurons read_dials(const BrainGraph& graph, const SensorPair& pair) {
    FourNeurons four;
    for (const Dial dial : weight_dials) {
        const Node* sensor = sensor_of(graph, dial, pair);
        const Node* motor = find_node(graph, entry(dial).motor);
        const Wire* wire = sensor && motor ? find_wire(graph, sensor->id, motor->id) : nullptr;
        if (!wire) continue;
        at(four, dial) = wire->weight;
        at(four, threshold_of(dial)) = wire->threshold;
    }
    for (const Dial dial : {Dial::LM, Dial::RM})
        if (const Node* motor = find_node(graph, entry(dial).motor)) at(four, dial) = motor->bias;
    return four;
}

std::optional<Dial> direct_dial(const BrainGraph& graph, WireEnds ends, const SensorPair& pair) {
    for (const Dial dial : weight_dials)
        if (direct_ends(graph, dial, pair) == ends) return dial;
    return std::nullopt;
}

std::optional<WireEnds> direct_ends(const BrainGraph& graph, Dial weight, const SensorPair& pair) {
    assert(is_weight(weight));
    const Node* sensor = sensor_of(graph, weight, pair);
    const Node* motor = find_node(graph, entry(weight).motor);
    if (sensor == nullptr || sensor->kind != NodeKind::sensor) return std::nullopt;
    if (motor == nullptr || motor->kind != NodeKind::motor) return std::nullopt;
    return WireEnds{sensor->id, motor->id};
}

std::string wire_name(const BrainGraph& graph, WireEnds ends, const SensorPair& pair) {
    if (const auto dial = direct_dial(graph, ends, pair)) return std::string(name(*dial));
    const Node* from = find_node(graph, ends.from);
    const Node* to = find_node(graph, ends.to);
    return (from == nullptr ? "?" : from->name) + "-" + (to == nullptr ? "?" : to->name);
}

void turn(BrainGraph& graph, Dial dial, float value, const SensorPair& pair) {
    if (!std::isfinite(value)) return;
    value = std::clamp(value, range(dial).low, range(dial).high);
    if (graph.nodes.empty()) graph = make_graph(FourNeurons{});
    Node* motor = find_node(graph, entry(dial).motor);
    if (!motor) return;
    if (is_bias(dial)) {
        motor->bias = value;
        return;
    }
    const Node* sensor = sensor_of(graph, dial, pair);
    if (!sensor) return;
    Wire* wire = find_wire(graph, sensor->id, motor->id);
    if (!wire) wire = &graph.wires.emplace_back(Wire{.from = sensor->id, .to = motor->id, .weight = 0});
    (is_weight(dial) ? wire->weight : wire->threshold) = value;
}

BrainGraph mirrored(BrainGraph brain, const SensorPair& pair) {
    const auto e = ends(brain, pair);
    if (!e) return brain;
    const auto wire = [&](NodeId from, NodeId to) {
        const Wire* found = find_wire(brain, from, to);
        return found ? std::optional(*found) : std::nullopt;
    };
    const auto straight = wire(e->left_eye, e->left_motor), across = wire(e->right_eye, e->left_motor);
    copy_wire(brain, straight ? &*straight : nullptr, e->right_eye, e->right_motor);
    copy_wire(brain, across ? &*across : nullptr, e->left_eye, e->right_motor);
    const Node left = *find_node(brain, std::string("ML"));
    Node& right = *find_node(brain, std::string("MR"));
    right.bias = left.bias;
    right.curve = left.curve;
    right.time_constant = left.time_constant;
    return brain;
}

BrainGraph crossed(BrainGraph brain, const SensorPair& pair) {
    const auto e = ends(brain, pair);
    if (!e) return brain;
    swap_wires(brain, e->left_eye, e->left_motor, e->right_motor);
    swap_wires(brain, e->right_eye, e->right_motor, e->left_motor);
    return brain;
}

}  // namespace braitenlab
