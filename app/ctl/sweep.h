// Several runs of one scene: every combination of the values and seeds that the command line gives.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/scene/settings.h"

namespace braitenlab {

inline constexpr std::size_t most_runs = 10'000;  // of one sweep

// The values of one --set argument, at least one.
struct SweptValue {
    std::vector<std::string> paths;  // that get the same value, at least one
    std::vector<std::string> values;

    std::string name() const;  // "LR=RL"
};

struct Sweep {
    std::vector<SweptValue> values;  // in the order of the arguments
    std::uint64_t first_seed = 1;
    std::size_t seeds = 1;  // first_seed, first_seed + 1, …
    bool is_sweep = false;  // an argument is a range or a list, perhaps with one value; false: a single run

    std::size_t combinations() const;  // of values, without the seeds
    std::size_t runs() const { return combinations() * seeds; }
};

// Reads the arguments of --set and --seed:
//
//     LR=RL=VALUE      one value, or values as below, for several dials of a brain
//     PATH=VALUE       one value; text with a comma or a colon is in quotes
//     PATH=V1,V2,…     a list
//     PATH=A:B:STEP    the numbers A, A + STEP, … up to B; a negative STEP counts down
//     SEED, A:B        one seed; all seeds from A to B. An empty text is seed 1
//
// Fails for an argument of another form, a step that does not lead from A to B, a path given twice in a sweep, and more
// than most_runs runs. The message names the argument.
Result<Sweep> parse_sweep(const std::vector<std::string>& settings, const std::string& seed);

// The values of combination `index` < combinations(), in the order of Sweep::values. The last value varies fastest.
std::vector<std::string> values_of(const Sweep&, std::size_t index);

// The same as cells of a table: where a value is a list of numbers and one is not whole, each has a point, "0.0".
std::vector<std::string> cells_of(const Sweep&, std::size_t index);

// The same as settings, one for each path.
std::vector<Setting> combination(const Sweep&, std::size_t index);

}  // namespace braitenlab
