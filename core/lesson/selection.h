// Selection by hand: a brain gets children, copies of it with random errors; one of them is chosen, and the next
// children are copies of that one.
#pragma once

#include <cstdint>
#include <vector>

#include "core/lesson/exercise.h"
#include "core/lesson/grade.h"

namespace braitenlab {

// True if the exercise has "selection" among its offers; Exercise::selection has the values.
bool offers_selection(const Exercise&);

// A brain that has children. The seed decides their errors.
struct Parent {
    BrainGraph brain;
    std::uint64_t seed = 0;
    friend bool operator==(const Parent&, const Parent&) = default;
};

// The brains of the parent's children, SelectionRules::children of them. Those of the shipped brain have errors of
// SelectionRules::first.
std::vector<BrainGraph> children_of(const Exercise&, const Parent&);

// The child as a parent. Children of one parent have different seeds, and so do a parent and its child, so that no
// error repeats.
Parent chosen(const Parent&, const BrainGraph& child, std::size_t index);

// How long the run lasted: until the vehicle fell over the edge, else to its end.
float seconds_survived(const StartResult&);

// True if the run ended before its time and did not pass.
bool has_fallen(const Exercise&, const StartResult&);

}  // namespace braitenlab
