#include "app/reports/breeding_table.h"

#include <vector>

#include <fmt/format.h>

#include "core/evolve/verdict.h"
#include "core/io/checked_json.h"

namespace braitenlab {

namespace {

using evolve::BreedingBase;
using evolve::BreedingState;
using evolve::Generation;
using evolve::Side;
using evolve::Tournament;
using BreedingJson = nlohmann::ordered_json;

std::vector<Generation> complete_ones(const BreedingBase& base, const BreedingState& state, Side side) {
    const auto& all = at(state.main.generations, side);
    return {all.begin(), all.begin() + complete_generations(base, state)};
}

BreedingJson trend_json(const std::vector<float>& scores) {
    const evolve::Trend trend = evolve::trend_of(scores);
    const auto interval = evolve::correlation_interval(scores);
    return {{"first_quarter", trend.first},
            {"last_quarter", trend.last},
            {"correlation", trend.correlation},
            {"interval", interval ? BreedingJson::array({interval->low, interval->high}) : BreedingJson()},
            {"generations", scores.size()}};
}

BreedingJson verdict_json(const evolve::Verdict& verdict) {
    return {{"course", word(verdict.course)},
            {"late", {verdict.late.first, verdict.late.last}},
            {"earlier", {verdict.earlier.first, verdict.earlier.last}},
            {"gain", verdict.gain}};
}

BreedingJson side_json(const std::vector<Generation>& generations, const Tournament& tournament, Side side) {
    BreedingJson json{{"generations", BreedingJson::array()}};
    std::vector<float> panel, master;
    for (std::size_t i = 0; i < generations.size(); ++i) {
        const Generation& each = generations[i];
        json["generations"].push_back({{"generation", i},
                                       {"best", each.best},
                                       {"median", each.median},
                                       {"diversity", each.diversity},
                                       {"panel", each.panel < 0 ? BreedingJson() : BreedingJson(each.panel)},
                                       {"champion", each.index},
                                       {"genome", each.champion},
                                       {"parents", each.parents}});
        if (each.panel >= 0) panel.push_back(each.panel);
    }
    for (std::size_t own = 0; own < tournament.size(); ++own) master.push_back(tournament.master_score(side, own));
    json["panel"] = panel.empty() ? BreedingJson() : trend_json(panel);
    json["master"] = trend_json(master);
    json["verdict"] = verdict_json(evolve::verdict_of(tournament, side));
    return json;
}

BreedingJson tournament_json(const Tournament& tournament) {
    BreedingJson rows = BreedingJson::array();
    for (std::size_t predator = 0; predator < tournament.size(); ++predator) {
        BreedingJson row = BreedingJson::array();
        for (std::size_t prey = 0; prey < tournament.size(); ++prey)
            row.push_back(tournament.score(Side::predator, predator, prey));
        rows.push_back(std::move(row));
    }
    return {{"generations", tournament.generations}, {"predator_scores", std::move(rows)}};
}

}  // namespace

std::size_t opponents_of(const Tournament& tournament, MatrixKind kind, std::size_t own) {
    return kind == MatrixKind::ciao ? own + 1 : tournament.size();
}

std::string matrix_table(const Tournament& tournament, MatrixKind kind) {
    std::string text = "side,generation,opponent_generation,score\n";
    for (const Side side : evolve::both_sides)
        for (std::size_t own = 0; own < tournament.size(); ++own)
            for (std::size_t opponent = 0; opponent < opponents_of(tournament, kind, own); ++opponent)
                text += fmt::format("{},{},{},{:.4f}\n", word(side), tournament.generations[own],
                                    tournament.generations[opponent], tournament.score(side, own, opponent));
    return text;
}

std::string breeding_table(const BreedingBase& base, const BreedingState& state, const Tournament* tournament) {
    std::string text = "measure,side,generation,of,value\n";
    for (const Side side : base.bred_sides()) {
        const std::vector<Generation> generations = complete_ones(base, state, side);
        for (std::size_t i = 0; i < generations.size(); ++i) {
            const Generation& each = generations[i];
            const auto add = [&](std::string_view measure, float number) {
                text += fmt::format("{},{},{},,{:.4f}\n", measure, word(side), i, number);
            };
            add("best", each.best), add("median", each.median), add("diversity", each.diversity);
            if (each.panel >= 0) add("panel", each.panel);
            text += fmt::format("champion,{},{},,{}\n", word(side), i, each.index);
            for (std::size_t k = 0; i > 0 && k < each.parents.size(); ++k)
                text += fmt::format("parent,{},{},{},{}\n", word(side), i, k, each.parents[k]);
        }
        for (std::size_t own = 0; tournament && own < tournament->size(); ++own)
            for (std::size_t opponent = 0; opponent < tournament->size(); ++opponent)
                text += fmt::format("score,{},{},{},{:.4f}\n", word(side), tournament->generations[own],
                                    tournament->generations[opponent], tournament->score(side, own, opponent));
    }
    return text;
}

std::string breeding_json(const BreedingBase& base, const BreedingState& state, const Tournament& tournament) {
    const evolve::Breeding& breeding = base.breeding();
    BreedingJson json{{"title", breeding.title},
                      {"opponents", word(breeding.opponents)},
                      {"seed", breeding.seed},
                      {"generation", complete_generations(base, state) - 1}};
    for (const Side side : base.bred_sides())
        json[std::string(word(side))] = side_json(complete_ones(base, state, side), tournament, side);
    json["tournament"] = tournament_json(tournament);
    return io::json_text(json, 1) + "\n";
}

}  // namespace braitenlab
