#include "core/evolve/verdict.h"

#include <algorithm>
#include <cmath>

namespace braitenlab::evolve {

namespace {

// Indices in Tournament::generations.
struct Quarter {
    std::size_t first = 0, end = 0;
};

Quarter quarter_of(const Tournament& tournament, std::size_t number) {
    const std::size_t length = tournament.size() / 4;
    return {number * length, number == 3 ? tournament.size() : (number + 1) * length};
}

Generations generations_of(const Tournament& tournament, Quarter quarter) {
    return {tournament.generations[quarter.first], tournament.generations[quarter.end - 1]};
}

struct Mean {
    double value = 0, squared_error = 0;  // the square of its standard error
};

Mean mean_of_pairs(const Tournament& tournament, Side side, Quarter own, Quarter opponents) {
    std::vector<double> scores;
    for (std::size_t i = own.first; i < own.end; ++i)
        for (std::size_t k = opponents.first; k < opponents.end; ++k)
            scores.push_back(static_cast<double>(tournament.score(side, i, k)));
    const auto count = static_cast<double>(scores.size());
    double sum = 0, squares = 0;
    for (const double score : scores) sum += score;
    for (const double score : scores) squares += (score - sum / count) * (score - sum / count);
    return {sum / count, squares / (count - 1) / count};
}

// Of the last quarter with an earlier one, against the opponents of that one.
struct Comparison {
    Generations earlier;
    double gain = 0;
    bool is_clear = false;
};

Comparison comparison_of(const Tournament& tournament, Side side, Quarter then) {
    const Mean now = mean_of_pairs(tournament, side, quarter_of(tournament, 3), then);
    const Mean before = mean_of_pairs(tournament, side, then, then);
    const double gain = now.value - before.value, error = std::sqrt(now.squared_error + before.squared_error);
    const bool is_clear = std::fabs(gain) >= static_cast<double>(least_gain) && std::fabs(gain) >= 2 * error;
    return {generations_of(tournament, then), gain, is_clear};
}

}  // namespace

Verdict verdict_of(const Tournament& tournament, Side side) {
    const bool is_known =
        std::none_of(tournament.scores.begin(), tournament.scores.end(), [](float score) { return std::isnan(score); });
    if (tournament.size() < least_generations || !is_known) return {};
    std::vector<Comparison> all;
    for (std::size_t number = 0; number < 3; ++number)
        all.push_back(comparison_of(tournament, side, quarter_of(tournament, number)));
    const auto is_loss = [](const Comparison& each) { return each.is_clear && each.gain < 0; };
    const auto by_loss_and_gain = [&](const Comparison& a, const Comparison& b) {
        return is_loss(a) != is_loss(b) ? is_loss(a) : a.gain < b.gain;
    };
    const Comparison& worst = *std::min_element(all.begin(), all.end(), by_loss_and_gain);
    const bool gains =
        std::all_of(all.begin(), all.end(), [](const Comparison& each) { return each.is_clear && each.gain > 0; });
    return {.course = is_loss(worst) ? Course::circles
                      : gains        ? Course::arms_race
                                     : Course::unclear,
            .late = generations_of(tournament, quarter_of(tournament, 3)),
            .earlier = worst.earlier,
            .gain = static_cast<float>(worst.gain)};
}

}  // namespace braitenlab::evolve
