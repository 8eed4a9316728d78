// Two edits of a two-eyed brain that people make again and again: both sides alike, and the wires crossed.
//
// They touch what the sliders show, the direct wires from the eyes SL and SR to the motors ML and MR, with all that a
// wire has: threshold, curve, learning. Lesions stay where they are. A brain without these four nodes stays as it is.
#pragma once

#include "core/brain/graph.h"

namespace braitenlab {

// The right motor gets the mirror image of what the left motor has: RR becomes LL, RL becomes LR, and bias, curve and
// time constant are those of the left motor.
BrainGraph mirrored(BrainGraph);

// Every eye's wires change motors: LL and RL swap, and so do RR and LR. A coward becomes an aggressor.
BrainGraph crossed(BrainGraph);

}  // namespace braitenlab
