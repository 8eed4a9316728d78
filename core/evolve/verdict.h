// What a tournament says about the champions of one side, in a word.
//
// Its generations are cut into quarters of equal length; a rest belongs to the last one. Against the opponents of each
// earlier quarter the champions of the last quarter are compared with the champions of that quarter itself, the
// contemporaries of these opponents. The gain is the difference of both mean scores. It is clear if it is at least
// `least_gain`, and at least twice its standard error by the spread of the scores of the pairs.
#pragma once

#include "core/evolve/tournament.h"

namespace braitenlab::evolve {

enum class Course { too_early, unclear, circles, arms_race };
struct CourseTraits {
    Course value;
    std::string_view word, meaning;
};
inline constexpr auto course_table = std::to_array<CourseTraits>({
    {Course::too_early, "too_early", "there are fewer than `least_generations` generations, or scores are missing"},
    {Course::unclear, "unclear", "neither of the following"},
    {Course::circles, "circles", "against some earlier quarter the gain is clear and below 0: an ability is lost"},
    {Course::arms_race, "arms_race", "against every earlier quarter the gain is clear and above 0"},
});
static_assert(is_complete_table<course_table>());
constexpr const auto& table_of(Course) { return course_table; }

inline constexpr std::size_t least_generations = 8;
inline constexpr float least_gain = 0.1F;

// Generations from `first` to `last`, both included.
struct Generations {
    int first = 0, last = 0;
    friend bool operator==(const Generations&, const Generations&) = default;
};

struct Verdict {
    Course course = Course::too_early;
    // The last quarter, and an earlier one: that of the largest clear loss, without one that of the smallest gain.
    Generations late, earlier;
    float gain = 0;  // against the opponents of this one, −1..1
};

// A score that is not known is NaN.
Verdict verdict_of(const Tournament&, Side);

}  // namespace braitenlab::evolve
