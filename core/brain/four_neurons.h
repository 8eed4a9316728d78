// The four-neuron brain: what the sliders show and what a scene file's short form holds.
//
//     ML = SL·LL + SR·LR + LM          MR = SR·RR + SL·RL + RM
//
// The first letter of a weight is the motor, the second the sensor: LR is the neuron from the right sensor to the left
// motor. Each neuron has a weight and a threshold, each motor a bias.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/brain/graph.h"

namespace braitenlab {

// One number of the four-neuron brain, the thing a slider moves.
enum class Dial { LL, LR, RL, RR, threshold_LL, threshold_LR, threshold_RL, threshold_RR, LM, RM };
inline constexpr std::array<Dial, 10> all_dials{
    Dial::LL,           Dial::LR,           Dial::RL,           Dial::RR, Dial::threshold_LL,
    Dial::threshold_LR, Dial::threshold_RL, Dial::threshold_RR, Dial::LM, Dial::RM};
inline constexpr std::array<Dial, 4> weight_dials{Dial::LL, Dial::LR, Dial::RL, Dial::RR};

struct DialRange {
    float low, high;
};

// "LL", "LR", "RL", "RR", "threshold_LL" …, "LM", "RM": the keys of a brain in a scene file.
std::string_view name(Dial);
std::optional<Dial> dial_named(std::string_view);

// Weights −2..2, thresholds 0..1, biases −1..1.
DialRange range(Dial);

// The threshold that belongs to a weight. Precondition: one of weight_dials.
Dial threshold_of(Dial weight);

struct FourNeurons {
    float LL = 0, LR = 0, RL = 0, RR = 0;
    float threshold_LL = 0, threshold_LR = 0, threshold_RL = 0, threshold_RR = 0;
    float LM = 0, RM = 0;
    friend bool operator==(const FourNeurons&, const FourNeurons&) = default;
};

float& at(FourNeurons&, Dial);
float at(const FourNeurons&, Dial);

// Nodes SL, SR, ML, MR with ids 0..3 and the four wires, those of weight 0 included.
BrainGraph make_graph(const FourNeurons&);

// True when the graph is exactly what make_graph gives for some FourNeurons, in any order and wherever its nodes stand.
bool is_four_neurons(const BrainGraph&);

// The direct wires from SL and SR to ML and MR and those motors' biases; 0 where there is none.
FourNeurons read_dials(const BrainGraph&);

// Turns one dial, making the wire where the graph has none; clamps to the dial's range and ignores what is not finite.
// A graph without the eye or the motor in question is left as it is.
void turn(BrainGraph&, Dial, float value);

}  // namespace braitenlab
