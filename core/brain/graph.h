// Graph of a brain, the form that is edited: sensors, neurons and motors, and the wires between them.
//
// Cycles are allowed. The four-neuron brain of the sliders (core/brain/four_neurons.h) is the special case of two
// sensors, two motors and four wires.
#pragma once

#include <cmath>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/brain/curve.h"
#include "core/enum_table.h"
#include "core/maths/vec.h"

namespace braitenlab {

using NodeId = std::int32_t;  // stable through edits; unique within a graph

enum class NodeKind { sensor, neuron, motor };

inline constexpr auto node_kind_table = std::to_array<Word<NodeKind>>(
    {{NodeKind::sensor, "sensor"}, {NodeKind::neuron, "neuron"}, {NodeKind::motor, "motor"}});
constexpr const auto& table_of(NodeKind) { return node_kind_table; }
static_assert(is_complete_table<node_kind_table>());

struct Node {
    NodeId id = 0;
    NodeKind kind = NodeKind::neuron;
    std::string name;         // unique; identifies sensors and motors: "SL", "SR", "ML", "MR"
    Curve curve{};            // of the sum; a sensor has none
    float bias = 0;           // added to the sum, -1..1; a sensor has none
    float time_constant = 0;  // s, of leaky memory; 0: none
    bool silenced = false;    // a lesion (covered eye, stopped motor, dead neuron): gives 0, keeps its parameters
    // Centre of its card on the wiring canvas, in canvas units (a layout pixel at zoom 1), x to the right, y down, each
    // -100000..100000. nullopt: the canvas arranges it. It does not affect what the brain computes.
    std::optional<maths::vec2> place{};
    friend bool operator==(const Node&, const Node&) = default;
};

struct Wire {
    NodeId from = 0, to = 0;
    float weight = 1;     // -2..2: amplifies, attenuates, inverts
    float threshold = 0;  // 0..1: an input of a smaller absolute value counts as 0
    Curve curve{};        // of the input, before the weight
    bool cut = false;     // a lesion: delivers 0, keeps its parameters
    // Hebbian wires (vehicle 7): activity at both ends at once strengthens the wire; the learned part fades. The
    // learned part h adds to the weight:  dh/dt = learning_rate · from · to − decay · h,  weight + h within −2..2.
    float learning_rate = 0;  // 1/s, 0..10; 0: does not learn
    float decay = 0;          // 1/s, 0..10
    friend bool operator==(const Wire&, const Wire&) = default;
};

// The two nodes that a wire joins. At most one wire joins them in this direction.
struct WireEnds {
    NodeId from = 0, to = 0;
    friend auto operator<=>(const WireEnds&, const WireEnds&) = default;
};

struct BrainGraph {
    std::vector<Node> nodes;
    std::vector<Wire> wires;  // at most one per WireEnds
    friend bool operator==(const BrainGraph&, const BrainGraph&) = default;
};

namespace limits {
inline constexpr float weight = 2, bias = 1, threshold = 1;         // largest absolute values
inline constexpr float peak = 2, least_width = 0.001f, width = 10;  // of a curve
inline constexpr float time_constant = 600;                         // s
inline constexpr float learning_rate = 10, decay = 10;              // 1/s
inline constexpr float place = 100000;                              // canvas units
inline constexpr int sensors = 64, neurons = 1024, wires = 8192;    // of one brain; motors are not counted
}  // namespace limits

// The brain without canvas positions (Node::place).
BrainGraph without_places(BrainGraph);

// True when two brains are equal apart from canvas positions.
bool same_wiring(const BrainGraph&, const BrainGraph&);

// True for a Hebbian wire.
inline bool learns(const Wire& wire) { return wire.learning_rate > 0; }

// The input, or 0 when its absolute value is below the threshold.
inline float masked(float input, float threshold) { return std::fabs(input) < threshold ? 0.0f : input; }

// The input after the wire's threshold and curve, before its weight.
float let_through(const Wire&, float input);

// Output of the wire for an `input`: applies the threshold and the curve, then multiplies by weight + `learned`, the
// learned part of a Hebbian wire. 0 for a cut wire.
float signal(const Wire&, float input, float learned = 0);

// The node with this id or name, or null. Linear search.
const Node* find_node(const BrainGraph&, NodeId);
const Node* find_node(const BrainGraph&, const std::string& name);
Node* find_node(BrainGraph&, const std::string& name);

// The wire from one node to another, or null. Linear search.
const Wire* find_wire(const BrainGraph&, NodeId from, NodeId to);
Wire* find_wire(BrainGraph&, NodeId from, NodeId to);

}  // namespace braitenlab
