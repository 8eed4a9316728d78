// A brain as a person edits it: sensors, neurons and motors, and the wires between them.
//
// Every brain is such a graph, cycles included. The four-neuron brain of the sliders is the special case of two
// sensors, two motors and four wires (core/brain/four_neurons.h): the same type, not a second one.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/maths/vec.h"

namespace braitenlab {

using NodeId = std::int32_t;  // stable through edits; unique within a graph

enum class NodeKind { sensor, neuron, motor };

// How a node or a wire answers to its input x.
enum class Response {
    linear,     // x
    rectified,  // max(0, x)
    step,       // 1 from the threshold `peak` on, else 0
    sigmoid,    // 1 / (1 + exp(-(x - peak) / width))
    hump,       // exp(-((x - peak) / width)^2): vehicle 4, a strong enough signal slows the wheel down again
    inverted,   // 1 - x
};

struct Curve {
    Response response = Response::linear;
    float peak = 0.5f;   // where the step, the sigmoid's middle or the hump stands; -2..2
    float width = 0.2f;  // > 0
    friend bool operator==(const Curve&, const Curve&) = default;
};

struct Node {
    NodeId id = 0;
    NodeKind kind = NodeKind::neuron;
    std::string name;         // a sensor or motor is found by its name: "SL", "SR", "ML", "MR"
    Curve curve{};            // of the sum; a sensor has none
    float bias = 0;           // added to the sum, -1..1; a sensor has none
    float time_constant = 0;  // seconds of leaky memory; 0 answers at once
    bool silenced = false;    // a lesion: a covered eye, a stopped motor, a dead neuron; gives 0 and keeps its numbers
    // Where a person has put it on the wiring canvas: its middle in canvas units (a layout pixel at zoom 1), x to the
    // right, y down, each -100000..100000. None: where it is tidied to. What the brain does is not touched by it.
    std::optional<maths::vec2> place{};
    friend bool operator==(const Node&, const Node&) = default;
};

struct Wire {
    NodeId from = 0, to = 0;
    float weight = 1;     // -2..2: amplifies, attenuates, inverts
    float threshold = 0;  // 0..1: an input whose size is below it counts as 0
    Curve curve{};        // of the input, before the weight
    bool cut = false;     // a lesion: delivers 0 and keeps its numbers
    // Hebbian wires (vehicle 7): what stands at both ends together strengthens the wire, and that fades. The learned
    // part h adds to the weight:  dh/dt = learning_rate · from · to − decay · h,  weight + h within −2..2.
    float learning_rate = 0;  // 1/s, 0..10; 0: does not learn
    float decay = 0;          // 1/s, 0..10
    friend bool operator==(const Wire&, const Wire&) = default;
};

struct BrainGraph {
    std::vector<Node> nodes;
    std::vector<Wire> wires;  // at most one from any node to any other
    friend bool operator==(const BrainGraph&, const BrainGraph&) = default;
};

namespace limits {
inline constexpr float weight = 2, bias = 1, threshold = 1;         // largest sizes
inline constexpr float peak = 2, least_width = 0.001f, width = 10;  // of a curve
inline constexpr float time_constant = 600;                         // s
inline constexpr float learning_rate = 10, decay = 10;              // 1/s
inline constexpr float place = 100000;                              // canvas units
inline constexpr int sensors = 64, neurons = 1024, wires = 8192;    // of one brain; the two motors come on top
}  // namespace limits

// The brain with nobody put anywhere, and whether two brains differ in nothing but that.
BrainGraph without_places(BrainGraph);
bool same_wiring(const BrainGraph&, const BrainGraph&);

// Whether what happens at its ends changes the wire.
inline bool learns(const Wire& wire) { return wire.learning_rate > 0; }

// What a threshold leaves of an input: nothing where its size is below it.
inline float masked(float input, float threshold) { return std::fabs(input) < threshold ? 0.0f : input; }

// What the curve makes of x.
float respond(const Curve&, float x);

// What the wire's threshold and curve leave of an input, before its weight.
float let_through(const Wire&, float input);

// What the wire delivers to its end when its start stands at `input`: mask, curve, weight (with what a Hebbian wire
// has learned). A cut wire delivers 0.
float signal(const Wire&, float input, float learned = 0);

// The node with this id or name, or null.
const Node* find_node(const BrainGraph&, NodeId);
const Node* find_node(const BrainGraph&, const std::string& name);
Node* find_node(BrainGraph&, const std::string& name);

// The wire between two nodes, or null.
const Wire* find_wire(const BrainGraph&, NodeId from, NodeId to);
Wire* find_wire(BrainGraph&, NodeId from, NodeId to);

}  // namespace braitenlab
