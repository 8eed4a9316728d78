// Two frequent edits of a brain: mirroring one side, and crossing the wires.
//
// They change the direct wires from the sensors of a pair to the motors ML and MR with all parameters (threshold,
// curve, learning). Lesions do not move. A brain without these four nodes is returned unchanged.
#pragma once

#include "core/brain/four_neurons.h"

namespace braitenlab {

// Makes the right motor the mirror image of the left one: RR becomes LL, RL becomes LR, and bias, curve and time
// constant are those of the left motor.
BrainGraph mirrored(BrainGraph, const SensorPair& = {});

// Swaps the motors of each sensor's wires: LL and RL, RR and LR. A coward becomes an aggressor.
BrainGraph crossed(BrainGraph, const SensorPair& = {});

}  // namespace braitenlab
