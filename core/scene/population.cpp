#include "core/scene/population.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace braitenlab {

namespace {

constexpr float largest_share = 1000;

}  // namespace

int most_wanted(const Scene& scene, const std::vector<int>& counts) {
    int total = 1, wanted = 0;
    float all_shares = 0, largest_lack = -INFINITY;
    for (std::size_t k = 0; k < counts.size(); ++k) total += counts[k], all_shares += scene.kinds[k].share;
    if (all_shares <= 0) return 0;
    for (std::size_t k = 0; k < counts.size(); ++k) {
        if (scene.kinds[k].share <= 0) continue;
        const float lack =
            scene.kinds[k].share / all_shares * static_cast<float>(total) - static_cast<float>(counts[k]);
        if (lack > largest_lack) largest_lack = lack, wanted = static_cast<int>(k);
    }
    return wanted;
}

std::vector<int> population_kinds(const Scene& scene) {
    constexpr int by_share = -1;
    std::vector<int> kinds(static_cast<std::size_t>(scene.ecology.population), by_share), counts(scene.kinds.size(), 0);
    for (const Member& member : scene.members) {
        if (member.kind.empty()) continue;
        const int kind = find_kind(scene, member.kind);
        kinds[static_cast<std::size_t>(number_of(member))] = kind;
        ++counts[static_cast<std::size_t>(kind)];
    }
    for (int& kind : kinds) {
        if (kind != by_share) continue;
        kind = most_wanted(scene, counts);
        ++counts[static_cast<std::size_t>(kind)];
    }
    return kinds;
}

StartNumbers start_numbers(const Scene& scene) {
    StartNumbers numbers{std::vector<int>(scene.kinds.size(), 0), std::vector<int>(scene.kinds.size(), 0)};
    for (const Start& start : scene.starts)
        ++numbers.with_start[static_cast<std::size_t>(find_kind(scene, start.kind))];
    for (const int kind : population_kinds(scene)) ++numbers.in_population[static_cast<std::size_t>(kind)];
    return numbers;
}

void set_population(Scene& scene, const std::vector<int>& in_population) {
    scene.ecology.population = std::accumulate(in_population.begin(), in_population.end(), 0);
    std::erase_if(scene.members, [&](const Member& m) { return number_of(m) >= scene.ecology.population; });
    const int most = *std::max_element(in_population.begin(), in_population.end());
    if (most == 0) return;
    const float scale = std::min(1.0f, largest_share / static_cast<float>(most));
    for (std::size_t k = 0; k < in_population.size(); ++k)
        scene.kinds[k].share = static_cast<float>(in_population[k]) * scale;
}

}  // namespace braitenlab
