// How a brain is laid out on its vehicle's deck: where its nodes stand and how its wires run. Metres in the vehicle's
// frame.
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
    std::size_t wire = 0;  // in BrainGraph::wires
    maths::vec2 from, to, bend;
};

struct DeckPlan {
    std::vector<DeckNeuron> neurons;
    std::vector<DeckWire> wires;
    float neuron_radius = 0.04f;    // m
    std::vector<bool> covered;      // a lid over the eye; as Kind::sensors
    std::array<bool, 2> stopped{};  // the motors, left and right
};

// Eyes stand where they are mounted and motors beside their wheels; what is between stands in rows from the eyes back
// to the axle, by how few wires lead there, each neuron on the side that it hears from. Wires of weight 0 that learn
// nothing are left out. Of a large brain the first neurons and the strongest wires are kept: what a deck has room for.
DeckPlan plan_deck(const BrainGraph&, const Kind&);

inline constexpr std::size_t most_deck_neurons = 48, most_deck_wires = 160;

}  // namespace braitenlab::render
