// Arranges nodes: all of a brain automatically, or selected ones in a column, a row or at even gaps. No Dear ImGui.
#pragma once

#include <map>
#include <set>

#include "core/brain/graph.h"
#include "core/maths/vec.h"

namespace braitenlab::wiring {

struct Layout;

using Positions = std::map<NodeId, maths::vec2>;  // centres of nodes, canvas units

// A position for every node: sensors left, neurons in columns by their distance from a sensor, motors right; names that
// end in L above names that end in R. Deterministic, and independent of the order of nodes and wires.
Positions tidy(const BrainGraph&);

enum class Arrangement { column, row, even_down, even_across };  // one x; one y; equal vertical or horizontal gaps

// New positions for these nodes. In a column or a row, cards that would overlap are moved apart. With even gaps, the
// two outermost nodes do not move. Empty for fewer than two nodes, or for fewer than three with even gaps.
Positions arranged(const Layout&, const std::set<NodeId>&, Arrangement);

}  // namespace braitenlab::wiring
