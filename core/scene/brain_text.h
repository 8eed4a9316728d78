// Converts a brain between its graph and its text in a file: first the four-neuron dials, then nodes and wires.
#pragma once

#include <optional>
#include <string>

#include "core/messages.h"
#include "core/scene/schema.h"

namespace braitenlab {

// An error in one value: its dotted path within the scene or brain, and what is wrong with what to do.
struct Fault {
    std::string path;
    Message what;
};

// Sets `graph` from the text; returns the first error, or nullopt.
//
// With at least one dial given, the graph begins with the four neurons (nodes SL, SR, ML, MR with ids 0..3), followed
// by the nodes and wires of the text. Exception: where a node of the text has one of these four names, the dials set
// the weights and biases of the text's own nodes. Without dials the graph consists of the text's nodes and wires.
std::optional<Fault> to_graph(const BrainText&, BrainGraph&);

// The shortest text from which to_graph() makes this graph. A four-neuron brain becomes dials only; the order of its
// nodes and wires is lost.
BrainText to_text(const BrainGraph&);

}  // namespace braitenlab
