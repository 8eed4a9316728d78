// What can be done to a brain's graph by hand: a graph in, a graph out, or the reason why not.
//
// The canvas keeps no graph of its own; it reads the running brain, makes one of these edits and asks for the result.
#pragma once

#include <compare>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "core/brain/four_neurons.h"
#include "core/brain/graph.h"

namespace braitenlab {

// A wire as a person means it: its two ends. At most one wire joins them.
struct WireEnds {
    NodeId from = 0, to = 0;
    friend auto operator<=>(const WireEnds&, const WireEnds&) = default;
};

// The edited graph, or the string key of the reason why it was refused ("wiring.refused.duplicate").
struct Edit {
    std::optional<BrainGraph> graph{};
    std::string_view refused{};
    explicit operator bool() const { return graph.has_value(); }
};

// Joins two nodes with weight 1. A wire of weight 0 is a free place and takes the weight, keeping its threshold and
// curve. Refused: into a sensor, a wire that is there already, more wires than limits::wires.
Edit connect(const BrainGraph&, WireEnds);

// Sets a wire's weight, making the wire where there is none; clamps to -2..2, ignores what is not finite.
// Refused: into a sensor.
Edit set_weight(const BrainGraph&, WireEnds, float weight);

// Adds a hidden neuron like the one given, with the id fresh_id() and the first free name of N1, N2 … unless its own is
// free. Refused: more than limits::neurons.
Edit add_neuron(const BrainGraph&, const Node& like = {});

// The id that the next node gets: one above the largest.
NodeId fresh_id(const BrainGraph&);

// Takes out neurons with their wires, and wires. A direct wire keeps its place and reads 0, as its slider does. Sensors
// and motors are the vehicle's, not the brain's: they stay. Refused: when nothing is left to remove.
Edit remove(const BrainGraph&, const std::set<NodeId>& nodes, const std::set<WireEnds>& wires);

// The slider that holds this wire's weight, for the wires from SL and SR to ML and MR.
std::optional<Dial> direct_dial(const BrainGraph&, WireEnds);

// The ends of a slider's wire, or nothing when the graph lacks the eye or the motor. Precondition: one of weight_dials.
std::optional<WireEnds> direct_ends(const BrainGraph&, Dial weight);

// The wire's weight; 0 where there is no wire.
float weight_of(const BrainGraph&, WireEnds);

// "LR" for a direct wire, else "N1-ML": the wire's name on screen and, after "wire.", its anchor.
std::string wire_name(const BrainGraph&, WireEnds);

}  // namespace braitenlab
