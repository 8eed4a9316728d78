// What a brain's nodes and wires carry at the snapshot's moment, beside the layout's shapes.
#pragma once

#include <vector>

#include "core/world/snapshot.h"
#include "ui/wiring/layout.h"

namespace braitenlab {

// Not core's Moment: two types of one name would share one destructor when linked into one program.
struct CanvasMoment {
    std::vector<float> nodes;    // as Layout::nodes: a reading, a neuron's or a motor's value
    std::vector<float> learned;  // as Layout::wires: what a Hebbian wire adds to its weight; 0 for any other
    std::vector<float> carried;  // as Layout::wires: what arrives at the end
};

// Fills `moment`; the same as node_value(), learned() and signal() say, one after the other. Precondition: the layout
// is that of the vehicle's brain, `graph`.
void read(CanvasMoment& moment, const Snapshot&, const VehicleView&, const BrainGraph& graph, const Layout&);

}  // namespace braitenlab
