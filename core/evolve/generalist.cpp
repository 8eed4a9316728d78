#include "core/evolve/generalist.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace braitenlab::evolve {

namespace {

bool is_better_against_all(const std::vector<float>& own, const std::vector<float>& others) {
    return own != others && std::equal(own.begin(), own.end(), others.begin(), std::greater_equal<>());
}

double distance(const Genome& a, const Genome& b, const Breed& breed) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double share =
            static_cast<double>(a[i] - b[i]) / static_cast<double>(breed.genes[i].high - breed.genes[i].low);
        sum += share * share;
    }
    return sum;
}

}  // namespace

std::vector<std::size_t> ranks_of(const std::vector<float>& scores) {
    std::vector<std::size_t> ranks(scores.size());
    std::iota(ranks.begin(), ranks.end(), std::size_t{0});
    std::stable_sort(ranks.begin(), ranks.end(), [&](std::size_t a, std::size_t b) { return scores[a] > scores[b]; });
    return ranks;
}

std::vector<std::size_t> generalists(const std::vector<std::vector<float>>& scores, const std::vector<float>& means,
                                     std::size_t parents) {
    const std::vector<std::size_t> ranks = ranks_of(means);
    std::vector<std::size_t> kept;
    for (const std::size_t each : ranks)
        if (each < parents) kept.push_back(each);
    for (const std::size_t child : ranks) {
        if (child < parents || !is_better_against_all(scores[child], scores[kept.back()])) continue;
        kept.pop_back();
        const auto place =
            std::find_if(kept.begin(), kept.end(), [&](std::size_t k) { return means[k] < means[child]; });
        kept.insert(place, child);
    }
    return kept;
}

std::vector<Genome> most_different(const std::vector<Genome>& genomes, const Breed& breed, std::size_t count) {
    std::vector<double> nearest(genomes.size(), std::numeric_limits<double>::infinity());
    std::vector<Genome> chosen;
    std::size_t next = 0;
    for (std::size_t i = 0; i < std::min(count, genomes.size()); ++i) {
        chosen.push_back(genomes[next]);
        for (std::size_t k = 0; k < genomes.size(); ++k)
            nearest[k] = std::min(nearest[k], distance(genomes[k], genomes[next], breed));
        nearest[next] = -1;  // chosen
        next = static_cast<std::size_t>(std::max_element(nearest.begin(), nearest.end()) - nearest.begin());
    }
    for (std::size_t i = 0; chosen.size() < count; ++i) chosen.push_back(chosen[i]);
    return chosen;
}

}  // namespace braitenlab::evolve
