#include "core/lesson/selection.h"

#include <algorithm>

#include "core/brain/brain.h"
#include "core/brain/mutate.h"
#include "core/lesson/submission.h"

namespace braitenlab {

bool offers_selection(const Exercise& exercise) {
    return std::find(exercise.offers.begin(), exercise.offers.end(), offer_parts::selection) != exercise.offers.end();
}

std::vector<BrainGraph> children_of(const Exercise& exercise, const Parent& parent) {
    Mutation mutation = exercise.selection.mutation;
    if (exercise.selection.first > 0 && same_wiring(parent.brain, as_shipped(exercise).brain))
        mutation.strength = exercise.selection.first;
    std::vector<BrainGraph> children;
    for (int i = 0; i < exercise.selection.children; ++i) {
        maths::Random chance(parent.seed, static_cast<std::uint64_t>(i));
        children.push_back(mutated(parent.brain, mutation, chance));
    }
    return children;
}

// The seed is multiplied by the constant of Random's generator, so that those of all descendants differ.
Parent chosen(const Parent& parent, const BrainGraph& child, std::size_t index) {
    return {child, parent.seed * 6364136223846793005ULL + index + 1};
}

float seconds_survived(const StartResult& run) { return run.seconds; }

bool has_fallen(const Exercise& exercise, const StartResult& run) {
    return !run.passed && run.seconds < exercise.seconds - tick_seconds;
}

}  // namespace braitenlab
