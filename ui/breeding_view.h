// The breeding on its sheet, for the panels (LabView::breeding).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/evolve/duel.h"
#include "core/evolve/verdict.h"
#include "ui/request.h"

namespace braitenlab {

inline constexpr double rest_after_match = 1;  // s, before a match that is watched begins again
inline constexpr int most_in_matrix = 21;      // generations of each side

struct BreedingView {
    const std::vector<evolve::Breeding>* shipped = nullptr;  // null: none
    std::shared_ptr<const evolve::BreedingBase> base{};      // null: none is open
    const evolve::BreedingState* state = nullptr;            // null with `base`
    bool runs = false;
    float progress = 0;                                // 0..1, of the generation that is bred, also of the panel
    std::optional<float> seconds_left{};               // at the measured pace, while it runs; unset: not known yet
    const evolve::Tournament* matrix = nullptr;        // null with `base`; NaN: a score that is not known yet
    evolve::BySide<evolve::Verdict> verdicts{};        // of the matrix
    std::vector<BreedingCell> watched{};               // at most two, the newest first
    bool watches_by_itself = false;                    // no person has chosen what is watched
    bool watches_panel = false;                        // these are generations of the panel's breeding
    const std::vector<evolve::Duel>* duels = nullptr;  // of these, from the same start; null: not known yet
    evolve::MatchStart start{};                        // of `duels`; its match is an index in `watched`
    std::optional<Error> error{};                      // why it could not be opened, continued or kept
    std::string last{};                                // name or path of the one opened last, also by an earlier start
    int shown = 0;  // increases with each breeding that is opened from a file: its sheet is shown then
};

// The last generation that is complete, with its score against the panel; −1: none is.
inline int last_generation(const BreedingView& view) {
    return view.base ? complete_generations(*view.base, *view.state) - 1 : -1;
}

// The match that a person watches, else that of the last champions: what is taken.
inline BreedingCell chosen_cell(const BreedingView& view) {
    const int last = last_generation(view);
    return view.watched.empty() || view.watches_by_itself ? BreedingCell{last, last} : view.watched.front();
}

// Two matches of one predator: with an ancestor of the last prey, and with the last prey, which does worse if any match
// of the matrix shows that.
struct TellingMatches {
    BreedingCell ancestor, last;
};

// Those with the greatest difference of the scores. nullopt before the second generation.
inline std::optional<TellingMatches> telling_matches(const BreedingView& view) {
    std::optional<TellingMatches> found;
    float most = -2;
    const std::size_t size = view.base && view.matrix ? view.matrix->size() : 0;
    for (std::size_t predator = 0; predator < size; ++predator)
        for (std::size_t prey = 0; prey + 1 < size; ++prey) {
            const auto score_against = [&](std::size_t which) {
                return view.matrix->score(evolve::Side::predator, predator, which);
            };
            const float worse = score_against(size - 1) - score_against(prey);
            if (!(worse > most)) continue;  // no more, or a score is not known
            most = worse;
            const std::vector<int>& generations = view.matrix->generations;
            found = {{generations[predator], generations[prey]}, {generations[predator], generations[size - 1]}};
        }
    return found;
}

}  // namespace braitenlab
