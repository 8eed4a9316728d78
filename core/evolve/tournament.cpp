#include "core/evolve/tournament.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "core/maths/fnv.h"

namespace braitenlab::evolve {

namespace {

std::vector<int> tournament_generations(const BreedingBase& base, const BreedingState& state, int most) {
    const int count = complete_generations(base, state);
    const int size = std::min(count, std::max(2, most));
    std::vector<int> generations;
    for (int i = 0; i < size; ++i) generations.push_back(size == 1 ? 0 : i * (count - 1) / (size - 1));
    return generations;
}

float mean_of_range(const std::vector<float>& numbers, std::size_t from, std::size_t to) {
    return std::accumulate(numbers.begin() + static_cast<std::ptrdiff_t>(from),
                           numbers.begin() + static_cast<std::ptrdiff_t>(to), 0.0F) /
           static_cast<float>(to - from);
}

}  // namespace

float Tournament::master_score(Side side, std::size_t own) const {
    float sum = 0;
    for (std::size_t i = 0; i < size(); ++i) sum += score(side, own, i);
    return sum / static_cast<float>(size());
}

std::vector<Trial> trials_of_tournament(const BreedingBase& base, const BreedingState& state, int most) {
    BySide<std::vector<std::shared_ptr<const Kind>>> kinds;
    const std::vector<int> generations = tournament_generations(base, state, most);
    for (const Side side : {Side::predator, Side::prey})
        for (const int generation : generations)
            at(kinds, side)
                .push_back(std::make_shared<const Kind>(base.kind_of(
                    side, at(state.main.generations, side)[static_cast<std::size_t>(generation)].champion)));
    std::vector<Trial> trials;
    for (std::size_t predator = 0; predator < generations.size(); ++predator)
        for (std::size_t prey = 0; prey < generations.size(); ++prey)
            for (int repeat = 0; repeat < tournament_trials; ++repeat)
                trials.push_back({{at(kinds, Side::predator)[predator], at(kinds, Side::prey)[prey]},
                                  maths::fnv(fmt::format("tournament {} {} {} {}", base.breeding().seed,
                                                         generations[predator], generations[prey], repeat))});
    return trials;
}

Tournament tournament_of(const BreedingBase& base, const BreedingState& state, int most,
                         const std::vector<float>& numbers) {
    Tournament tournament{.generations = tournament_generations(base, state, most), .scores = {}};
    for (std::size_t next = 0; next < numbers.size(); next += tournament_trials) {
        float sum = 0;
        for (std::size_t i = 0; i < tournament_trials; ++i)
            sum += score_of(base.breeding(), Side::predator, numbers[next + i]);
        tournament.scores.push_back(sum / tournament_trials);
    }
    return tournament;
}

Trend trend_of(const std::vector<float>& scores) {
    const std::size_t count = scores.size(), quarter = std::max<std::size_t>(1, count / 4);
    if (count == 0) return {};
    Trend trend{.first = mean_of_range(scores, 0, quarter), .last = mean_of_range(scores, count - quarter, count)};
    const double mean = static_cast<double>(mean_of_range(scores, 0, count));
    const double middle = static_cast<double>(count - 1) / 2;
    double both = 0, own = 0, time = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double score = static_cast<double>(scores[i]) - mean, generation = static_cast<double>(i) - middle;
        both += score * generation, own += score * score, time += generation * generation;
    }
    if (own > 0 && time > 0) trend.correlation = static_cast<float>(both / std::sqrt(own * time));
    return trend;
}

}  // namespace braitenlab::evolve
