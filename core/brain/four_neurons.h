// The four-neuron brain: the brain of the sliders and of a scene file's short form.
//
//     ML = SL·LL + SR·LR + LM          MR = SR·RR + SL·RL + RM
//
// The first letter of a weight is the motor, the second the sensor: LR is the neuron from the right sensor to the left
// motor. Each neuron has a weight and a threshold, each motor a bias.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/brain/graph.h"

namespace braitenlab {

// One number of the four-neuron brain; a slider sets it.
enum class Dial { LL, LR, RL, RR, threshold_LL, threshold_LR, threshold_RL, threshold_RR, LM, RM };
inline constexpr std::array<Dial, 10> all_dials{
    Dial::LL,           Dial::LR,           Dial::RL,           Dial::RR, Dial::threshold_LL,
    Dial::threshold_LR, Dial::threshold_RL, Dial::threshold_RR, Dial::LM, Dial::RM};
inline constexpr std::array<Dial, 4> weight_dials{Dial::LL, Dial::LR, Dial::RL, Dial::RR};
constexpr bool is_weight(Dial dial) { return dial <= Dial::RR; }
constexpr bool is_bias(Dial dial) { return dial >= Dial::LM; }

struct DialRange {
    float low, high;
};

// "LL", "LR", "RL", "RR", "threshold_LL" …, "LM", "RM": the keys of a brain in a scene file.
std::string_view name(Dial);
std::optional<Dial> dial_named(std::string_view);

// Weights −2..2, thresholds 0..1, biases −1..1.
DialRange range(Dial);

// The threshold of the wire that has this weight. Precondition: one of weight_dials.
Dial threshold_of(Dial weight);

// Names of the two sensors whose wires the weights are. A vehicle can have several pairs (core/scene/sensor_pairs.h);
// the dials of one pair do not depend on the others, but the biases are common to all.
struct SensorPair {
    std::string left = "SL", right = "SR";
    friend bool operator==(const SensorPair&, const SensorPair&) = default;
};

struct FourNeurons {
    float LL = 0, LR = 0, RL = 0, RR = 0;
    float threshold_LL = 0, threshold_LR = 0, threshold_RL = 0, threshold_RR = 0;
    float LM = 0, RM = 0;
    friend bool operator==(const FourNeurons&, const FourNeurons&) = default;
};

float& at(FourNeurons&, Dial);
float at(const FourNeurons&, Dial);

// Ids of the nodes of make_graph().
namespace four_neuron_ids {
inline constexpr NodeId SL = 0, SR = 1, ML = 2, MR = 3;
}

// The nodes SL, SR, ML, MR and the four wires, those of weight 0 included.
BrainGraph make_graph(const FourNeurons&);

// True when the graph equals make_graph() of some FourNeurons, apart from order and canvas positions.
bool is_four_neurons(const BrainGraph&);

// The dial that holds the weight of this wire; nullopt unless it joins a sensor of the pair to ML or MR.
std::optional<Dial> direct_dial(const BrainGraph&, WireEnds, const SensorPair& = {});

// The ends of a dial's wire; nullopt when the graph does not have the sensor or the motor. Precondition: one of
// weight_dials.
std::optional<WireEnds> direct_ends(const BrainGraph&, Dial weight, const SensorPair& = {});

// "LR" for a direct wire of the pair, else the names of both ends: "N1-ML". An end that the graph does not have is "?".
std::string wire_name(const BrainGraph&, WireEnds, const SensorPair& = {});

// The dials of any graph: its direct wires from the pair to ML and MR and those motors' biases; 0 where one is missing.
FourNeurons read_dials(const BrainGraph&, const SensorPair& = {});

// Sets one dial, adding the wire where the graph has none. Clamps to the dial's range; a value that is not finite
// changes nothing. An empty graph becomes make_graph() first. A dial whose sensor or motor the graph does not have
// changes nothing.
void turn(BrainGraph&, Dial, float value, const SensorPair& = {});

// mirrored() and crossed() change the direct wires of the pair with all parameters (threshold, curve, learning).
// Lesions do not move. A brain without the two sensors, ML and MR is returned unchanged.

// Makes the right motor the mirror image of the left one: RR becomes LL, RL becomes LR, and bias, curve and time
// constant are those of the left motor.
BrainGraph mirrored(BrainGraph, const SensorPair& = {});

// Swaps the motors of each sensor's wires: LL and RL, RR and LR. A coward becomes an aggressor.
BrainGraph crossed(BrainGraph, const SensorPair& = {});

}  // namespace braitenlab
