// A part of a brain that was copied: neurons and the wires among them, ready to be put into any brain.
#pragma once

#include <string>
#include <vector>

#include "ui/wiring/layout.h"

namespace braitenlab {

struct BrainPiece {
    struct End {
        int neuron = -1;    // in `neurons`; −1: a sensor or motor, found by its name
        std::string outer;  // "SL"
    };
    struct Joint {
        End from, to;
        Wire wire;  // its numbers; its ends mean nothing here
    };
    std::vector<Node> neurons;
    std::vector<maths::vec2> places;  // as neurons, against the middle of them all
    std::vector<Joint> wires;
    bool empty() const { return neurons.empty(); }
};

// The neurons among these nodes, the wires between them, and those that join them to sensors and motors among these
// nodes. Sensors and motors themselves are the vehicle's and cannot be copied.
BrainPiece copy(const BrainGraph&, const Layout&, const std::set<NodeId>& nodes);

// The brain with the piece in it, under new ids and free names, around `middle` (canvas units). A wire to a sensor or
// motor that this brain lacks is left out. Refused: an empty piece, more neurons or wires than a brain may have.
struct Pasted {
    Edit edit;
    std::set<NodeId> nodes;  // the new ones
};
Pasted paste(const BrainGraph&, const BrainPiece&, maths::vec2 middle);

}  // namespace braitenlab
