#include "core/evolve/tournament.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "core/maths/fnv.h"
#include "core/maths/random.h"

namespace braitenlab::evolve {

namespace {

std::vector<int> tournament_generations(const BreedingBase& base, const BreedingState& state, int most) {
    const int count = complete_generations(base, state);
    const int size = std::min(count, std::max(2, most));
    std::vector<int> generations;
    for (int i = 0; i < size; ++i) generations.push_back(size == 1 ? 0 : i * (count - 1) / (size - 1));
    return generations;
}

BredKind champion_kind(const BreedingBase& base, const BreedingState& state, Side side, int generation) {
    return {base, side, at(state.main.generations, side)[static_cast<std::size_t>(generation)].champion};
}

void add_match(std::vector<Trial>& trials, const BreedingBase& base, const BySide<BredKind>& kinds, int predator,
               int prey) {
    for (int repeat = 0; repeat < tournament_trials; ++repeat)
        trials.push_back(
            {kinds, maths::fnv(fmt::format("tournament {} {} {} {}", base.breeding().seed, predator, prey, repeat))});
}

float mean_of_range(const std::vector<float>& numbers, std::size_t from, std::size_t to) {
    return std::accumulate(numbers.begin() + static_cast<std::ptrdiff_t>(from),
                           numbers.begin() + static_cast<std::ptrdiff_t>(to), 0.0F) /
           static_cast<float>(to - from);
}

// Pearson's correlation of score and generation in these generations; 0 where one of them is constant.
double correlation_of(const std::vector<float>& scores, const std::vector<std::size_t>& generations) {
    double mean = 0, middle = 0, both = 0, own = 0, time = 0;
    for (const std::size_t i : generations) mean += static_cast<double>(scores[i]), middle += static_cast<double>(i);
    mean /= static_cast<double>(generations.size()), middle /= static_cast<double>(generations.size());
    for (const std::size_t i : generations) {
        const double score = static_cast<double>(scores[i]) - mean, generation = static_cast<double>(i) - middle;
        both += score * generation, own += score * score, time += generation * generation;
    }
    return own > 0 && time > 0 ? both / std::sqrt(own * time) : 0;
}

}  // namespace

float Tournament::master_score(Side side, std::size_t own) const {
    float sum = 0;
    for (std::size_t i = 0; i < size(); ++i) sum += score(side, own, i);
    return sum / static_cast<float>(size());
}

std::vector<Trial> trials_of_match(const BreedingBase& base, const BreedingState& state, int predator, int prey) {
    std::vector<Trial> trials;
    add_match(trials, base,
              {champion_kind(base, state, Side::predator, predator), champion_kind(base, state, Side::prey, prey)},
              predator, prey);
    return trials;
}

float score_of_match(const BreedingBase& base, const std::vector<float>& numbers) {
    float sum = 0;
    for (const float each : numbers) sum += score_of(base.breeding(), Side::predator, each);
    return sum / static_cast<float>(numbers.size());
}

std::vector<Trial> trials_of_panel_match(const BreedingBase& base, const BreedingState& state, int generation) {
    BySide<BredKind> kinds;
    for (const Side side : both_sides) {
        const Generation& bred = at(state.panel.generations, side)[static_cast<std::size_t>(generation)];
        at(kinds, side) = BredKind(base, side, bred.champion);
    }
    std::vector<Trial> trials;
    add_match(trials, base, kinds, generation, generation);
    return trials;
}

std::vector<Trial> trials_at_all_starts(const std::vector<std::vector<Trial>>& matches) {
    std::vector<Trial> trials;
    for (const std::vector<Trial>& starts : matches)
        for (const Trial& start : starts)
            for (const std::vector<Trial>& match : matches) trials.push_back({match.front().kinds, start.seed});
    return trials;
}

MatchStart nearest_start(const BreedingBase& base, std::size_t matches, const std::vector<float>& numbers) {
    const auto result = [&](MatchStart start, std::size_t match) {
        const std::size_t which = (start.match * tournament_trials + start.run) * matches + match;
        return score_of(base.breeding(), Side::predator, numbers[which]);
    };
    std::vector<float> scores(matches, 0.0F);
    for (std::size_t match = 0; match < matches; ++match)
        for (std::size_t run = 0; run < tournament_trials; ++run)
            scores[match] += result({match, run}, match) / tournament_trials;
    const auto distance = [&](MatchStart start) {
        float sum = 0;
        for (std::size_t match = 0; match < matches; ++match) {
            const float error = result(start, match) - scores[match];
            sum += std::fabs(error);
            if (match > 0) sum += std::fabs(error - (result(start, match - 1) - scores[match - 1]));
        }
        return sum;
    };
    MatchStart nearest;
    for (std::size_t match = 0; match < matches; ++match)
        for (std::size_t run = 0; run < tournament_trials; ++run)
            if (const MatchStart start{match, run}; distance(start) < distance(nearest)) nearest = start;
    return nearest;
}

std::vector<Trial> trials_of_tournament(const BreedingBase& base, const BreedingState& state, int most) {
    BySide<std::vector<BredKind>> kinds;
    const std::vector<int> generations = tournament_generations(base, state, most);
    for (const Side side : {Side::predator, Side::prey})
        for (const int generation : generations)
            at(kinds, side).push_back(champion_kind(base, state, side, generation));
    std::vector<Trial> trials;
    for (std::size_t predator = 0; predator < generations.size(); ++predator)
        for (std::size_t prey = 0; prey < generations.size(); ++prey)
            add_match(trials, base, {at(kinds, Side::predator)[predator], at(kinds, Side::prey)[prey]},
                      generations[predator], generations[prey]);
    return trials;
}

Tournament tournament_of(const BreedingBase& base, const BreedingState& state, int most,
                         const std::vector<float>& numbers) {
    Tournament tournament{.generations = tournament_generations(base, state, most), .scores = {}};
    for (auto next = numbers.begin(); next != numbers.end(); next += tournament_trials)
        tournament.scores.push_back(score_of_match(base, {next, next + tournament_trials}));
    return tournament;
}

Trend trend_of(const std::vector<float>& scores) {
    const std::size_t count = scores.size(), quarter = std::max<std::size_t>(1, count / 4);
    if (count == 0) return {};
    Trend trend{.first = mean_of_range(scores, 0, quarter), .last = mean_of_range(scores, count - quarter, count)};
    std::vector<std::size_t> all(count);
    std::iota(all.begin(), all.end(), std::size_t{0});
    trend.correlation = static_cast<float>(correlation_of(scores, all));
    return trend;
}

std::optional<Interval> correlation_interval(const std::vector<float>& scores) {
    constexpr std::size_t least = 8, resamples = 2000;
    const std::size_t count = scores.size();
    const bool is_constant = std::adjacent_find(scores.begin(), scores.end(), std::not_equal_to<>()) == scores.end();
    if (count < least || is_constant) return std::nullopt;
    const auto block = static_cast<std::size_t>(std::lround(std::cbrt(static_cast<double>(count))));
    maths::Random random(1, maths::fnv("correlation_interval"));
    std::vector<double> correlations;
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < resamples; ++i) {
        chosen.clear();
        while (chosen.size() < count) {
            const std::size_t first = random.next() % (count - block + 1);
            for (std::size_t k = 0; k < block && chosen.size() < count; ++k) chosen.push_back(first + k);
        }
        correlations.push_back(correlation_of(scores, chosen));
    }
    std::sort(correlations.begin(), correlations.end());
    return Interval{static_cast<float>(correlations[resamples / 40]),
                    static_cast<float>(correlations[resamples - 1 - resamples / 40])};
}

}  // namespace braitenlab::evolve
