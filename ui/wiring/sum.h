// A neuron's or motor's sum in numbers, as a person would write it down.
#pragma once

#include <functional>
#include <string>

#include "core/brain/graph.h"

namespace braitenlab {

// "0.42·0.80 + 0.10 → 0.44": what each wire lets through times its weight, the bias, and the value that came of it.
// Wires of weight 0 are left out; a line is broken after three terms. `value` gives a node's value of this moment.
// Empty for a sensor, and for a node that the graph does not have.
std::string sum_text(const BrainGraph&, NodeId, const std::function<float(NodeId)>& value);

}  // namespace braitenlab
