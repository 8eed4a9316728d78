// Text about a node: its description, and its sum in numbers.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/brain/four_neurons.h"
#include "core/world/snapshot.h"

namespace braitenlab::wiring {

// A string key: SL, SR, ML and MR by their side, other sensors by their channel.
std::string_view description_key(const Snapshot&, const VehicleView&, const Node&);

// The icon of the channel; before "r", "g" or "b" the icon of a lamp.
std::string_view channel_symbol(Channel);

// True for letters that the program or a shipped file gives to a sensor: OL, KR2, EN.
bool has_code_as_name(const Sensor&);

// The icon of the channel and, for a sensor at a side or that looks to it, L or R.
std::string symbol_name(const Sensor&);

// The name of a node in a diagram: the icon of the channel and L or R for a sensor with a code as its name, else the
// name. SL and SR for light are names that the user learns, and stay.
std::string short_name(const std::vector<Sensor>&, const std::string& node);

// As wire_name() of the core, with the short names of sensors: "LL", else "rL-N1" where the sensor SL sees red.
std::string short_wire_name(const std::vector<Sensor>&, const BrainGraph&, WireEnds, const SensorPair& = {});

// "0.42·0.80 + 0.10 → 0.44": each wire's input after threshold and curve times its weight, the bias, and the node's
// value. A curve f is on a separate line: "0.42·0.80 = 0.34", then "f(0.34) = 0.71 → 0.70"; the value after the arrow
// includes leaky memory and lesions. Wires of weight 0 and cut wires are left out; lines have at most three terms.
// The sum of a motor is limited: "0.55·2.00 = 1.10 → 1.00". Where the rounded numbers give another sum, ≈ is before it:
// "0.36·1.50 + 0.10 ≈ 0.63".
// `value` gives a node's value, `learned` the learned part of a wire's weight, `named` the name of the node at which a
// wire begins, which then precedes its input: "SL 0.42·0.80 + 0.10 → 0.44".
// Empty for a sensor and for a node that the graph does not have.
std::string sum_text(const BrainGraph&, NodeId, const std::function<float(NodeId)>& value,
                     const std::function<float(const Wire&)>& learned = {}, char decimal_mark = '.',
                     const std::function<std::string(NodeId)>& named = {});

// The value that is shown for a node: of a motor the wheel command, which is limited to −1..1.
float shown_value(const Node&, float value);

// The sum before the curve. 0 for a node that the graph does not have.
float sum_of(const BrainGraph&, NodeId, const std::function<float(NodeId)>& value,
             const std::function<float(const Wire&)>& learned = {});

}  // namespace braitenlab::wiring
