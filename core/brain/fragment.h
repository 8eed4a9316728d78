// Copy and paste of a part of a brain.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "core/brain/edit.h"

namespace braitenlab {

struct BrainFragment {
    struct End {
        int neuron = -1;           // index in `neurons`; −1: a sensor or motor
        std::string outer_name{};  // of that sensor or motor: "SL"
    };
    struct Connection {
        End from, to;
        Wire parameters;  // Wire::from and Wire::to are not used
    };
    std::vector<Node> neurons;  // Node::place is relative to the mean position
    std::vector<Connection> connections;
    bool empty() const { return neurons.empty(); }
};

// Copies the neurons among these nodes, the wires between them, and the wires that join them to sensors and motors
// among these nodes. Sensors and motors belong to the vehicle and are not copied. A neuron without a position counts as
// (0, 0).
BrainFragment copy_fragment(const BrainGraph&, const std::set<NodeId>& nodes);

struct Pasted {
    Edit edit;
    std::set<NodeId> added;  // ids of the new neurons; empty when refused
};

// The brain with the fragment added under new ids and free names, its neurons around `middle` (canvas units). A wire to
// a sensor or motor that this brain does not have is left out.
// Refused: empty_fragment, too_many_neurons, too_many_wires.
Pasted paste_fragment(const BrainGraph&, const BrainFragment&, maths::vec2 middle);

// Rounds to whole canvas units, which keep files short, and clamps to limits::place.
maths::vec2 rounded_position(maths::vec2);

}  // namespace braitenlab
