// Layout of a brain on the deck of its vehicle: positions of nodes and curves of wires, m, in the vehicle's frame.
#pragma once

#include <array>
#include <vector>

#include "core/brain/graph.h"
#include "core/maths/vec.h"
#include "core/scene/scene.h"

namespace braitenlab::render {

struct DeckNeuron {
    NodeId id = 0;
    maths::vec2 place;
    bool silenced = false;
};

struct DeckWire {
    std::size_t wire = 0;  // index in BrainGraph::wires
    maths::vec2 from, to, bend;
};

struct DeckPlan {
    std::vector<DeckNeuron> neurons;
    std::vector<DeckWire> wires;
    float neuron_radius = 0.04f;    // m
    std::vector<bool> covered;      // silenced sensors; index as in Kind::sensors
    std::array<bool, 2> stopped{};  // silenced motors, left and right
};

// The area of the neurons in the vehicle's frame, m: x of the first and of the last row, and largest |y|.
struct DeckRows {
    float front = 0, back = 0, half_width = 0;
};
DeckRows rows_on(const Body&);

// Sensors are at their mounts and motors beside their wheels. Neurons are in rows from the sensors back to the axle.
// The row of a neuron is its least number of wires from a sensor; its side is that of its inputs. Wires of weight 0
// that do not learn are omitted. A large brain is reduced to its first most_deck_neurons neurons and its
// most_deck_wires strongest wires.
DeckPlan plan_deck(const BrainGraph&, const Kind&, const DeckRows&);
inline DeckPlan plan_deck(const BrainGraph& brain, const Kind& kind) {
    return plan_deck(brain, kind, rows_on(kind.body));
}

inline constexpr std::size_t most_deck_neurons = 48, most_deck_wires = 160;

}  // namespace braitenlab::render
