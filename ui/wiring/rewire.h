// What the menu, the inspector and a drop do to whole neurons and wires: a graph in, a graph or a reason out.
#pragma once

#include "ui/wiring/edit.h"

namespace braitenlab {

// Moves a wire to other ends, with all its numbers; the place it leaves reads 0. Refused as connect() refuses, and when
// the wire is gone.
Edit reconnect(const BrainGraph&, WireEnds wire, WireEnds to);

// Puts a neuron into a wire: the wire, with all its numbers, then ends at the neuron, and a wire of weight 1 goes on
// from there. Refused: when the neuron is an end of the wire or has a wire to one of its ends already.
Edit insert(const BrainGraph&, NodeId neuron, WireEnds into);

// Takes all wires off these nodes, sensors and motors included. Refused: when they have none.
Edit detach(const BrainGraph&, const std::set<NodeId>&);

// Lesions: silences nodes and cuts wires, or heals them; no number is lost. Refused: when nothing is left to do.
Edit lesion(const BrainGraph&, const std::set<NodeId>&, const std::set<WireEnds>&, bool hurt);

// Whether every one of them is silenced or cut, and there is one.
bool all_hurt(const BrainGraph&, const std::set<NodeId>&, const std::set<WireEnds>&);

// Gives the node or wire of the same id or ends these numbers, each brought into its range; what is not finite leaves
// the old number. Its name, kind and ends stay. Refused: when it is gone.
Edit replace(const BrainGraph&, const Node&);
Edit replace(const BrainGraph&, const Wire&);

// Whether any wire of a weight begins or ends at the node.
bool is_wired(const BrainGraph&, NodeId);

// What can be chosen when a neuron is made.
struct NeuronKind {
    std::string_view words;  // string key: "wiring.kind.hump"
    Node made;               // its curve and time constant
};
inline constexpr std::size_t neuron_kind_count = 7;
const std::array<NeuronKind, neuron_kind_count>& neuron_kinds();

}  // namespace braitenlab
