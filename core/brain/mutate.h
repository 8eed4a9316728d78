// Copies of a brain with random errors.
#pragma once

#include "core/brain/graph.h"
#include "core/maths/random.h"

namespace braitenlab {

// What a copy can get wrong, and how far it is off.
struct Mutation {
    float strength = 0.4f;    // standard deviation of the error of a weight, 0..2; 0: exact copies
    bool weights = true;      // every wire's weight gets an error
    bool thresholds = false;  // every wire's threshold; its error is a quarter of a weight's, as its range is
    bool biases = false;      // every neuron's and motor's bias; its error is half of a weight's, as its range is
    float rewiring = 0;       // 0..1: probability that the copy loses a wire or gets a new one, either equally likely
    friend bool operator==(const Mutation&, const Mutation&) = default;
};

// A copy with errors. All values stay within `limits`; an error beyond a limit gives the limit. The same graph,
// mutation and state of `chance` give the same copy. A new wire joins two nodes that no wire joins and has the weight
// of an error from 0; there is none when all are joined, or the brain has limits::wires wires.
BrainGraph mutated(BrainGraph, const Mutation&, maths::Random& chance);

}  // namespace braitenlab
