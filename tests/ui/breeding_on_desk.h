// A breeding on a desk: the shipped one with made-up scores.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "core/scene/file_kind.h"
#include "desk.h"

namespace braitenlab::tests {

struct BredOnDesk {
    std::vector<evolve::Breeding> shipped;
    std::shared_ptr<const evolve::BreedingBase> base;
    evolve::BreedingState state;
    evolve::Tournament matrix;
    std::vector<evolve::Duel> duels;

    // With so many complete generations and every `distance`th of them in the matrix, in an arms race.
    explicit BredOnDesk(int complete, int distance = 1, const char* file = "chase") {
        const std::filesystem::path folder = std::filesystem::path(BRAITENLAB_SOURCE) / "exercises" / "breeding";
        for (const char* id : {"chase", "chase-archive", "chase-random", "flee"}) {
            const auto path = folder / (std::string(id) + ".toml");
            shipped.push_back(*evolve::parse_breeding(*read_text(path), path.string()));
            if (std::string(file) != id) continue;
            const std::string scene = *read_text(folder / shipped.back().scene);
            base = *evolve::BreedingBase::create(shipped.back(), scene, "scene");
        }
        state = begin_breeding(*base);
        const evolve::Breeding& breeding = base->breeding();
        const bool has_panel = breeding.panel > 0;
        for (const evolve::Side side : {evolve::Side::predator, evolve::Side::prey}) {
            const evolve::Genome champion = at(state.main.population, side).front().genome;
            for (int i = 0; i < complete; ++i)
                at(state.main.generations, side)
                    .push_back({.champion = champion,
                                .best = 0.6f + 0.2f * std::sin(static_cast<float>(i)),
                                .panel = has_panel ? 0.4f + 0.005f * static_cast<float>(i) : -1});
            if (has_panel && complete > 0)
                at(state.panel.generations, side)
                    .resize(static_cast<std::size_t>(breeding.panel_generations + 1), {.champion = champion});
        }
        for (int i = 0; i < complete; i += distance) matrix.generations.push_back(i);
        for (std::size_t predator = 0; predator < matrix.size(); ++predator)
            for (std::size_t prey = 0; prey < matrix.size(); ++prey)
                matrix.scores.push_back(0.5f + 0.5f * (static_cast<float>(predator) - static_cast<float>(prey)) /
                                                   static_cast<float>(matrix.size()));
    }

    void show(Desk& desk) {
        BreedingView& view = desk.view.features.breeding;
        view.shipped = &shipped, view.base = base, view.state = &state, view.matrix = &matrix;
        for (const evolve::Side side : {evolve::Side::predator, evolve::Side::prey})
            at(view.verdicts, side) = verdict_of(matrix, side);
        desk.panels.sheet = ui::Sheet::breeding;
    }

    // Watches two matches of five seconds, in the first of which the prey is eaten.
    void watch(Desk& desk, BreedingCell newest, BreedingCell before) {
        std::vector<Pose> path;
        for (int tick = 0; tick <= 300; ++tick) path.push_back({static_cast<float>(tick) / 100 - 1.5f, 1, 0});
        duels = {{{path, path}, true}, {{path, path}, false}};
        desk.view.features.breeding.watched = {newest, before}, desk.view.features.breeding.duels = &duels;
    }
};

}  // namespace braitenlab::tests
