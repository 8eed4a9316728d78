// Where nodes stand that nobody has put anywhere: sensors left, hidden neurons in columns, motors right.
#pragma once

#include <map>

#include "core/brain/graph.h"
#include "core/maths/vec.h"

namespace braitenlab {

using Places = std::map<NodeId, maths::vec2>;  // centres of nodes, canvas units

// A place for every node. The same graph gives the same places, whatever the order of its nodes and wires; a signal
// runs rightwards, what belongs to the vehicle's left side stands above what belongs to its right.
Places tidy(const BrainGraph&);

}  // namespace braitenlab
