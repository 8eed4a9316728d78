// A compiled brain: the graph as flat, read-only arrays that all vehicles with this brain share.
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

inline constexpr float tick_seconds = 1.0f / 60;  // simulated time of one tick of bodies and brains
inline double seconds_at(std::uint64_t tick) { return static_cast<double>(tick) / 60; }  // s of simulated time

struct Brain {
    // A wire, stored with the unit that it feeds.
    struct Tap {
        std::int32_t source;  // a sensor if below sensors.size(), else the unit source - sensors.size()
        float weight, threshold;
        Curve curve;
        std::int32_t learned = -1;  // index in learning_wires; −1: does not learn
        float learning_rate = 0, decay = 0;
    };
    // One neuron or motor: its sum runs over taps[first_tap, end_tap), in ascending order of source.
    struct Unit {
        std::int32_t first_tap, end_tap;
        float bias;
        float follow;  // 1 − exp(−period/time_constant): share of the way to the new value per tick
        Curve curve;
    };

    std::vector<std::int32_t>
        sensors;              // index of the vehicle's sensor for each sensor node; −1: none or silenced, reads 0
    std::vector<Unit> units;  // hidden neurons by ascending id, then the left motor, then the right one
    std::vector<Tap> taps;
    std::vector<NodeId> unit_ids;  // the graph's node of each unit; −1 for a motor that the graph does not have
    std::vector<std::pair<NodeId, NodeId>>
        learning_wires;  // ends of the Hebbian wires in ascending order, the order of their learned parts

    float period = tick_seconds;  // s between two calls of think()

    int neuron_count() const { return static_cast<int>(units.size()); }
    // Size of a vehicle's brain state: the values of the units, then the learned parts of learning_wires.
    int state_size() const { return static_cast<int>(units.size() + learning_wires.size()); }
};

// Returns the reason why the graph cannot be compiled, or nullopt: two nodes with one id or name, a motor other than ML
// and MR, a wire to a missing node or into a sensor, two wires with the same ends, a number that is not finite or
// outside its range, more nodes or wires than `limits` allows.
std::optional<Error> check_graph(const BrainGraph&);

// Flattens a graph for a vehicle with these sensors (names in the vehicle's order). The result does not depend on the
// order of nodes and wires: the same graph gives the same sums, bit for bit. Cut wires and wires into a silenced node
// have no tap; their learned parts stay in the state and do not change until they are healed. `period`: s between two
// calls of think(), above 0; another than the simulation's for a robot that computes its brain less often.
// Fails as check_graph() does.
Result<Brain> compile(const BrainGraph&, std::span<const std::string> sensor_names, float period = tick_seconds);

// Computes one tick. `sensed`: the vehicle's sensors, each 0..1. `state`: state_size() values, those of the previous
// tick in and those of this tick out. Hidden neurons read this tick's sensors and the previous tick's units; motors
// read this tick's neurons. Cycles therefore need no special case. `motors`: the left and the right value, clamped to
// −1..1.
void think(const Brain&, std::span<const float> sensed, std::span<float> state, std::span<float, 2> motors);

// Gives hidden neurons the values that they have once these readings have lasted, without computing a tick: those that
// have no memory (no time constant) and are in no cycle. The others keep theirs. `state`: as of think().
void settle_forward(const Brain&, std::span<const float> sensed, std::span<float> state);

}  // namespace braitenlab
