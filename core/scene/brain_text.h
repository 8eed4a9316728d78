// Between the brain that thinks, a graph, and the brain that a file shows: four dials first, then nodes and wires.
#pragma once

#include <optional>
#include <string>

#include "core/scene/schema.h"

namespace braitenlab {

// What is wrong with one value: its dotted path within whatever is being looked at, and what to do.
struct Fault {
    std::string path, what;
};

// Fills the graph; says what could not be done, nothing when all went well.
//
// With any dial given, the brain begins as four neurons (nodes SL, SR, ML, MR with ids 0..3); the nodes and wires
// beyond them follow. But where a node of the text already bears one of those four names, the given dials turn what
// nodes and wires make. Without dials the brain is its nodes and wires alone.
std::optional<Fault> to_graph(const BrainText&, BrainGraph&);

// The shortest text that to_graph() turns into this graph again; a four-neuron brain becomes dials alone, whatever the
// order of its nodes and wires was.
BrainText to_text(const BrainGraph&);

}  // namespace braitenlab
