#include "core/evolve/breeding_json.h"

#include <fmt/format.h>

#include "core/io/json.h"
#include "core/messages.h"

namespace braitenlab::evolve {

using io::Json;

void to_json(Json& json, const Individual& each) { json = {{"genes", each.genome}, {"parent", each.parent}}; }
void from_json(const Json& json, Individual& each) {
    json.at("genes").get_to(each.genome), json.at("parent").get_to(each.parent);
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Generation, champion, index, best, median, diversity, panel, parents)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Lineage, population, generations)

namespace {

bool fits(const BreedingBase& base, Side side, const Genome& genome) {
    const Breed* breed = base.breed(side);
    if (!breed) return genome.empty();
    if (genome.size() != breed->genes.size()) return false;
    for (std::size_t i = 0; i < genome.size(); ++i)
        if (!(genome[i] >= breed->genes[i].low && genome[i] <= breed->genes[i].high)) return false;
    return true;
}

// `is_bred`: a lineage that has begun.
bool fits(const BreedingBase& base, const Lineage& lineage, bool is_bred) {
    const auto& both = lineage.generations;
    if (both.front().size() != both.back().size()) return false;
    for (const Side side : {Side::predator, Side::prey}) {
        const std::size_t count = !is_bred           ? 0
                                  : base.breed(side) ? static_cast<std::size_t>(base.breeding().population)
                                                     : 1;
        if (at(lineage.population, side).size() != count) return false;
        for (const Individual& each : at(lineage.population, side))
            if (!fits(base, side, each.genome)) return false;
        for (const Generation& each : at(lineage.generations, side))
            if (!is_bred || !fits(base, side, each.champion)) return false;
    }
    return true;
}

}  // namespace

std::string write_state(const BreedingBase& base, const BreedingState& state) {
    const Json json{{"format", 1},
                    {"breeding", fmt::format("{:016x}", base.fingerprint())},
                    {"panel", state.panel},
                    {"main", state.main}};
    return io::json_text(json) + "\n";
}

Result<BreedingState> read_state(const BreedingBase& base, std::string_view text, const std::string& file_name) {
    try {
        const Json json = Json::parse(text);
        if (json.at("breeding") != fmt::format("{:016x}", base.fingerprint()))
            return error_of(message_of("other_breeding"), file_name);
        BreedingState state;
        json.at("panel").get_to(state.panel), json.at("main").get_to(state.main);
        if (json.at("format") == 1 && fits(base, state.main, true) &&
            fits(base, state.panel, base.breeding().panel > 0))
            return state;
    } catch (const Json::exception&) {
    }
    return error_of(message_of("damaged_breeding"), file_name);
}

}  // namespace braitenlab::evolve
