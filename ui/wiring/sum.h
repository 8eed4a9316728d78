// A neuron's or motor's sum in numbers, as a person would write it down.
#pragma once

#include <functional>
#include <string>

#include "core/brain/graph.h"

namespace braitenlab {

// "0.42·0.80 + 0.10 → 0.44": what each wire lets through times its weight, the bias, and the value that came of it.
// A curve f stands in a line of its own: "0.42·0.80 = 0.34", then "f(0.34) = 0.71 → 0.70"; the arrow leads to what a
// leaky memory or a lesion has made of the answer. Wires of weight 0 and cut ones are left out; a line is broken after
// three terms. `value` gives a node's value of this moment, `learned` what a Hebbian wire adds to its weight.
// Empty for a sensor, and for a node that the graph does not have.
std::string sum_text(const BrainGraph&, NodeId, const std::function<float(NodeId)>& value,
                     const std::function<float(const Wire&)>& learned = {});

// The sum itself, before the curve. 0 for a node that the graph does not have.
float sum_of(const BrainGraph&, NodeId, const std::function<float(NodeId)>& value,
             const std::function<float(const Wire&)>& learned = {});

}  // namespace braitenlab
