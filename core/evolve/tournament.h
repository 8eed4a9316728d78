// Champions of many generations against each other: whether a breeding goes forward or round in circles. The score of a
// champion in its own generation does not show it, because its opponents change, too. Definitions: D. Cliff, G. F.
// Miller, "Tracking the Red Queen" (1995), current individual against ancestral opponents (CIAO); D. Floreano, S.
// Nolfi, "God Save the Red Queen" (1997), master tournament.
#pragma once

#include <optional>
#include <vector>

#include "core/evolve/breeding.h"

namespace braitenlab::evolve {

// The master tournament: every champion of one side against every one of the other.
struct Tournament {
    std::vector<int> generations;  // ascending; the first and the last complete one are among them
    std::vector<float> scores;     // of the predator, by its generation, then by that of the prey

    std::size_t size() const { return generations.size(); }
    // Of a side's champion against one of the other side; indices in `generations`.
    float score(Side side, std::size_t own, std::size_t opponent) const {
        return side == Side::predator ? scores[own * size() + opponent] : 1 - scores[opponent * size() + own];
    }
    // Mean against all opponents.
    float master_score(Side side, std::size_t own) const;
};

inline constexpr int tournament_trials = 4;  // of each pair

// The runs of champions of these two generations, and the score of the predator by run_of() each of them in their
// order. Precondition: both generations are complete.
std::vector<Trial> trials_of_match(const BreedingBase&, const BreedingState&, int predator, int prey);
float score_of_match(const BreedingBase&, const std::vector<float>& numbers);
// Those of the panel's breeding. Precondition: it has this generation.
std::vector<Trial> trials_of_panel_match(const BreedingBase&, const BreedingState&, int generation);

// A start of matches: that of one run of one of them.
struct MatchStart {
    std::size_t match = 0, run = 0;
    friend bool operator==(const MatchStart&, const MatchStart&) = default;
};

// Every match at each start of all of them: by match and run of the start, then by match.
std::vector<Trial> trials_at_all_starts(const std::vector<std::vector<Trial>>& matches);

// The start at which the results of all matches, and the difference of two, are nearest to those of their scores.
// `numbers`: run_of() each of these trials in their order.
MatchStart nearest_start(const BreedingBase&, std::size_t matches, const std::vector<float>& numbers);

// At most this many generations of each side, spread evenly. Precondition: a generation is complete.
std::vector<Trial> trials_of_tournament(const BreedingBase&, const BreedingState&, int most);
// `numbers`: run_of() each of these trials in their order.
Tournament tournament_of(const BreedingBase&, const BreedingState&, int most, const std::vector<float>& numbers);

// How a series of scores changes with the generation.
struct Trend {
    float first = 0, last = 0;  // mean of the first and of the last quarter
    float correlation = 0;      // of score and generation, −1..1 (Pearson); 0 for a constant series
};
Trend trend_of(const std::vector<float>& scores);

// A 95 % interval of the correlation, by a bootstrap of blocks of neighbouring generations, because these are alike
// (H. R. Künsch, "The Jackknife and the Bootstrap for General Stationary Observations", 1989). The same scores give the
// same interval. nullopt for fewer than 8 scores and for a constant series.
struct Interval {
    float low = 0, high = 0;
};
std::optional<Interval> correlation_interval(const std::vector<float>& scores);

}  // namespace braitenlab::evolve
