// A brain made ready to think: the graph as flat arrays, read-only and shared by all vehicles that have it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/brain/graph.h"
#include "core/result.h"

namespace braitenlab {

inline constexpr float tick_seconds = 1.0f / 60;  // simulated time of one tick, of bodies and brains alike

struct Brain {
    // One wire, seen from the node it feeds.
    struct Tap {
        std::int32_t source;  // < sensors.size(): a sensor, else neuron source - sensors.size()
        float weight, threshold;
        Curve curve;
        std::int32_t learned = -1;  // where its learned part stands after the units in a vehicle's state; −1: none
        float learning_rate = 0, decay = 0;
    };
    // One neuron or motor: its sum runs over taps[first_tap, end_tap), in ascending order of source.
    struct Unit {
        std::int32_t first_tap, end_tap;
        float bias;
        float follow;  // 1 − exp(−tick/time_constant): how far a tick moves it towards its sum's response
        Curve curve;
    };

    std::vector<std::int32_t>
        sensors;              // the vehicle's sensor that each sensor node reads; −1: none or covered, reads 0
    std::vector<Unit> units;  // hidden neurons by ascending id, then the left motor, then the right one
    std::vector<Tap> taps;
    std::vector<NodeId> unit_ids;  // the graph's node behind each unit; −1 for a motor the graph does not have
    std::vector<std::pair<NodeId, NodeId>>
        learning_wires;  // ends of the Hebbian wires, ascending: the order of their learned parts

    int neuron_count() const { return static_cast<int>(units.size()); }
    // Numbers that a vehicle with this brain carries from tick to tick: its units, then its wires' learned parts.
    int state_size() const { return static_cast<int>(units.size() + learning_wires.size()); }
};

// Why this graph cannot think, or nothing: two nodes of one id or name, a motor other than ML and MR, a wire to nowhere
// or into a sensor, two wires between the same nodes, a number that is not finite or outside its range, more nodes or
// wires than `limits` allows.
std::optional<Error> check_graph(const BrainGraph&);

// Flattens a graph for a vehicle with these sensors (names in the vehicle's own order). The order of editing does not
// matter: the same graph gives the same sums, bit for bit. A cut wire and one into a silenced node are left out; what
// they learned keeps its place and rests until they are healed.
// Fails as check_graph() does.
Result<Brain> compile(const BrainGraph&, std::span<const std::string> sensor_names);

// One tick. `sensed` holds the vehicle's sensors, each 0..1. `state` has state_size() values: what each unit held and
// each Hebbian wire had learned a tick ago comes in, what they hold now goes out. Hidden neurons read sensors as they
// are now and neurons as the previous tick left them; motors read this tick's neurons; so cycles need no special case.
// `motors` gets the left and the right sum, clamped to −1..1.
void think(const Brain&, std::span<const float> sensed, std::span<float> state, std::span<float, 2> motors);

}  // namespace braitenlab
