// Exercises as TOML files: the opposite of load_exercise().
#pragma once

#include <string>

#include "core/lesson/exercise.h"

namespace braitenlab {

// The file of the exercise, with its scene in it and without values at their defaults. parse_exercise() of it gives the
// same exercise, except that a four-neuron brain loses the order of its nodes and wires. Comments are not kept.
std::string write_exercise(const Exercise&);

}  // namespace braitenlab
