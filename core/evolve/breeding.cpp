#include "core/evolve/breeding.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>
#include <span>

#include <fmt/format.h>

#include "core/evolve/generalist.h"
#include "core/maths/fnv.h"
#include "core/maths/random.h"
#include "core/messages.h"
#include "core/scene/nearest.h"
#include "core/scene/scene_file.h"
#include "core/scene/toml_tree.h"

namespace braitenlab::evolve {

namespace {

constexpr int panel_trials = 4;  // of a champion with each opponent of the panel

std::vector<Setting> settings_of(const Breeding& breeding, const Breed& breed, const Genome& genome) {
    std::vector<Setting> settings;
    for (std::size_t i = 0; i < genome.size(); ++i) {
        const Gene& gene = breed.genes[i];
        for (std::size_t k = 0; k < gene.paths.size(); ++k) {
            const std::string& path = gene.paths[k];
            const bool is_negative = path.starts_with('-');
            settings.push_back({fmt::format("kind.{}.{}", breed.kind, path.substr(is_negative ? 1 : 0)),
                                fmt::format("{}", is_negative ? -genome[i] : genome[i]), breeding.file,
                                k < gene.lines.size() ? gene.lines[k] : 0});
        }
    }
    return settings;
}

// The file of a scene with this kind alone: a genome changes nothing else, and the rest need not be read again.
TomlFile file_of_kind(const TomlFile& scene, const std::string& kind) {
    TomlFile file{scene.name, {TomlNode::Table{}, scene.root.place}};
    for (const TomlMember& member : *scene.root.as_table()) {
        TomlMember own = member;
        if (member.key == "kind" || member.key == "sealed")
            std::erase_if(std::get<TomlNode::Table>(own.value.content),
                          [&](const TomlMember& each) { return each.key != kind; });
        else if (member.key != "format")
            continue;
        std::get<TomlNode::Table>(file.root.content).push_back(std::move(own));
    }
    return file;
}

// The only vehicle of a side in the world; an error if there are none or several.
std::optional<Error> find_kind(const Snapshot& start, Side side, const std::string& scene_file, int& kind) {
    kind = -1;
    for (const VehicleView& vehicle : start.vehicles) {
        if (vehicle.role != role_of(side)) continue;
        if (kind >= 0) return error_of(message_of("no_duel"), scene_file);
        kind = vehicle.kind;
    }
    return kind >= 0 ? std::nullopt : std::optional(error_of(message_of("no_duel"), scene_file));
}

// Different for every use of random numbers: the numbers are the run, the generation and further indices.
template <class... Numbers>
std::uint64_t seed_for(std::string_view use, std::uint64_t run, Numbers... numbers) {
    std::string text = fmt::format("{} {}", use, run);
    ((text += fmt::format(" {}", static_cast<long long>(numbers))), ...);
    return maths::fnv(text);
}

// The panel is bred from a seed of its own.
std::uint64_t run_seed(const Breeding& breeding, bool is_panel) {
    return is_panel ? seed_for("panel", breeding.seed, 0) : breeding.seed;
}

Genome first_genome(const Breed& breed, std::uint64_t seed) {
    maths::Random random(seed, 1);
    Genome genome;
    for (const Gene& gene : breed.genes) genome.push_back(random.uniform(gene.low, gene.high));
    return genome;
}

// Back into the range, by reflection at its ends.
float reflected(float number, const Gene& gene) {
    const float width = gene.high - gene.low;
    const float turn = std::fmod(std::fabs(number - gene.low), 2 * width);
    return std::clamp(gene.low + (turn > width ? 2 * width - turn : turn), gene.low, gene.high);
}

Genome child_of(const Genome& parent, const Breed& breed, std::uint64_t seed) {
    maths::Random random(seed, 2);
    Genome genome = parent;
    for (std::size_t i = 0; i < genome.size(); ++i)
        genome[i] = reflected(genome[i] + breed.genes[i].mutation * random.normal(), breed.genes[i]);
    return genome;
}

// A side without a breed has one individual, which stays as in the scene.
std::vector<Individual> first_population(const BreedingBase& base, Side side, std::uint64_t run) {
    const Breed* breed = base.breed(side);
    if (!breed) return {Individual{}};
    const bool from_scene = base.breeding().from_scene;
    Genome start;
    for (const Gene& gene : breed->genes) start.push_back(std::clamp(gene.start, gene.low, gene.high));
    std::vector<Individual> population;
    for (int i = 0; i < base.breeding().population; ++i) {
        const std::uint64_t seed = seed_for("first", run, side, i);
        if (!from_scene)
            population.push_back({first_genome(*breed, seed)});
        else
            population.push_back({i == 0 ? start : child_of(start, *breed, seed)});
    }
    return population;
}

bool is_generalist(const Breeding& breeding) { return breeding.opponents == Opponents::generalist; }

int generation_of(const Lineage& lineage) { return static_cast<int>(lineage.generations.front().size()); }

// The opponents that each individual of the side meets, one a trial.
std::vector<Genome> opponents_of(const BreedingBase& base, const Lineage& lineage, Side side, std::uint64_t run) {
    const Breeding& breeding = base.breeding();
    const std::vector<Individual>& present = at(lineage.population, other(side));
    const std::vector<Generation>& earlier = at(lineage.generations, other(side));
    if (const Breed* breed = base.breed(other(side)); breed && !earlier.empty() && is_generalist(breeding)) {
        std::vector<Genome> known;
        for (int i = 0; i < breeding.parents; ++i) known.push_back(present[static_cast<std::size_t>(i)].genome);
        for (const Generation& each : earlier) known.push_back(each.champion);
        return most_different(known, *breed, static_cast<std::size_t>(breeding.trials));
    }
    std::vector<Genome> opponents;
    for (int trial = 0; trial < breeding.trials; ++trial) {
        maths::Random random(seed_for("opponent", run, generation_of(lineage), side, trial), 3);
        const auto any_of = [&](std::size_t count) { return random.next() % count; };
        const auto number = static_cast<std::size_t>(trial), count = earlier.size();
        if (earlier.empty() || breeding.opponents == Opponents::random) {
            opponents.push_back(present[any_of(present.size())].genome);
        } else if (breeding.opponents == Opponents::archive) {
            opponents.push_back(earlier[any_of(count)].champion);
        } else {
            const bool one = breeding.opponents == Opponents::last;
            const std::size_t kept = one ? 1 : std::min(count, static_cast<std::size_t>(breeding.remembered));
            opponents.push_back(earlier[count - 1 - number % kept].champion);
        }
    }
    return opponents;
}

std::vector<BredKind> kinds_of(const BreedingBase& base, Side side, const std::vector<Genome>& genomes) {
    std::vector<BredKind> kinds;
    for (const Genome& genome : genomes) kinds.emplace_back(base, side, genome);
    return kinds;
}

// Every individual of `own` with every opponent, `repeats` times; the opponent varies faster than the individual.
void add_trials(std::vector<Trial>& trials, const BreedingBase& base, Side side, const std::vector<Genome>& own,
                const std::vector<Genome>& opponents, int repeats, const auto& seed) {
    const auto own_kinds = kinds_of(base, side, own), other_kinds = kinds_of(base, other(side), opponents);
    for (std::size_t i = 0; i < own.size(); ++i)
        for (std::size_t k = 0; k < opponents.size(); ++k)
            for (int repeat = 0; repeat < repeats; ++repeat) {
                Trial trial{.kinds = {}, .seed = seed(i, k, repeat)};
                at(trial.kinds, side) = own_kinds[i], at(trial.kinds, other(side)) = other_kinds[k];
                trials.push_back(std::move(trial));
            }
}

std::vector<Genome> genomes_of(const std::vector<Individual>& population) {
    std::vector<Genome> genomes;
    for (const Individual& each : population) genomes.push_back(each.genome);
    return genomes;
}

std::vector<Trial> trials_of_generation(const BreedingBase& base, const Lineage& lineage, bool is_panel) {
    const std::uint64_t run = run_seed(base.breeding(), is_panel);
    std::vector<Trial> trials;
    for (const Side side : base.bred_sides()) {
        add_trials(trials, base, side, genomes_of(at(lineage.population, side)), opponents_of(base, lineage, side, run),
                   1, [&](std::size_t individual, std::size_t opponent, int) {
                       // Those that are compared against each opponent have the same start.
                       if (is_generalist(base.breeding())) individual = 0;
                       return seed_for("trial", run, generation_of(lineage), side, individual, opponent);
                   });
    }
    return trials;
}

// Champions of the panel's breeding at equal distances; the last one is among them.
std::vector<Genome> panel_of(const BreedingBase& base, const BreedingState& state, Side side) {
    const std::vector<Generation>& bred = at(state.panel.generations, side);
    if (!base.breed(side)) return {Genome{}};
    std::vector<Genome> panel;
    const auto size = static_cast<std::size_t>(base.breeding().panel);
    for (std::size_t i = 1; i <= size; ++i) panel.push_back(bred[(bred.size() * i - 1) / size].champion);
    return panel;
}

std::vector<Trial> trials_of_panel(const BreedingBase& base, const BreedingState& state) {
    const Breeding& breeding = base.breeding();
    std::vector<Trial> trials;
    for (const Side side : base.bred_sides()) {
        add_trials(trials, base, side, {at(state.main.generations, side).back().champion},
                   panel_of(base, state, other(side)), panel_trials,
                   [&](std::size_t, std::size_t opponent, int repeat) {
                       return seed_for("panel trial", breeding.seed, generation_of(state.main), side, opponent, repeat);
                   });
    }
    return trials;
}

float mean_of(const float* scores, std::size_t count) {
    return std::accumulate(scores, scores + count, 0.0F) / static_cast<float>(count);
}

float diversity_of(const std::vector<Individual>& population, const Breed& breed) {
    double sum = 0;
    const auto count = static_cast<double>(population.size());
    for (std::size_t gene = 0; gene < breed.genes.size(); ++gene) {
        double mean = 0, squares = 0;
        for (const Individual& each : population) mean += static_cast<double>(each.genome[gene]) / count;
        for (const Individual& each : population) {
            const double from_mean = static_cast<double>(each.genome[gene]) - mean;
            squares += from_mean * from_mean / count;
        }
        sum += std::sqrt(squares) / static_cast<double>(breed.genes[gene].high - breed.genes[gene].low);
    }
    return static_cast<float>(sum / static_cast<double>(breed.genes.size()));
}

// Records the generation of this number and replaces its individuals by the next one. `scores`: of the individuals in
// their order, of each against its opponents.
void breed_side(const BreedingBase& base, Lineage& lineage, Side side, std::uint64_t run, int generation,
                const std::vector<std::vector<float>>& scores) {
    const Breeding& breeding = base.breeding();
    const Breed& breed = *base.breed(side);
    std::vector<Individual>& population = at(lineage.population, side);
    std::vector<float> means;
    for (const std::vector<float>& own : scores) means.push_back(mean_of(own.data(), own.size()));
    const std::vector<std::size_t> ranks = ranks_of(means);
    const bool keeps_generalists = is_generalist(breeding) && generation > 0;
    const std::vector<std::size_t> parents =
        keeps_generalists ? generalists(scores, means, static_cast<std::size_t>(breeding.parents))
                          : std::vector(ranks.begin(), ranks.begin() + breeding.parents);

    Generation record{.champion = population[parents[0]].genome,
                      .index = static_cast<int>(parents[0]),
                      .best = means[parents[0]],
                      .median = means[ranks[ranks.size() / 2]],
                      .diversity = diversity_of(population, breed)};
    for (const Individual& each : population) record.parents.push_back(each.parent);

    const int unchanged = is_generalist(breeding) ? breeding.parents : breeding.elite;
    std::vector<Individual> next;
    for (int i = 0; i < breeding.population; ++i) {
        const std::size_t parent = parents[static_cast<std::size_t>(i % breeding.parents)];
        const Genome& genome = population[parent].genome;
        const std::uint64_t seed = seed_for("child", run, generation, side, i);
        next.push_back({i < unchanged ? genome : child_of(genome, breed, seed), static_cast<int>(parent)});
    }
    at(lineage.generations, side).push_back(std::move(record));
    population = std::move(next);
}

void advance_generation(const BreedingBase& base, Lineage& lineage, bool is_panel, std::span<const float> numbers) {
    const Breeding& breeding = base.breeding();
    const auto trials = static_cast<std::size_t>(breeding.trials);
    const int generation = generation_of(lineage);
    std::size_t next = 0;
    for (const Side side : both_sides) {
        if (!base.breed(side)) {
            at(lineage.generations, side).emplace_back();
            continue;
        }
        std::vector<std::vector<float>> scores(at(lineage.population, side).size(), std::vector<float>(trials));
        for (std::vector<float>& own : scores)
            for (float& score : own) score = score_of(breeding, side, numbers[next++]);
        breed_side(base, lineage, side, run_seed(breeding, is_panel), generation, scores);
    }
}

// Returns the number of trials.
std::size_t take_panel_scores(const BreedingBase& base, BreedingState& state, std::span<const float> numbers) {
    std::size_t next = 0;
    for (const Side side : base.bred_sides()) {
        const std::size_t count = panel_of(base, state, other(side)).size() * panel_trials;
        std::vector<float> scores(count);
        for (float& score : scores) score = score_of(base.breeding(), side, numbers[next++]);
        at(state.main.generations, side).back().panel = mean_of(scores.data(), count);
    }
    return next;
}

bool breeds_panel(const BreedingBase& base, const BreedingState& state) {
    const Breeding& breeding = base.breeding();
    return breeding.panel > 0 && generation_of(state.panel) <= breeding.panel_generations;
}

// The last generation has no score against the panel yet.
bool awaits_panel(const BreedingBase& base, const BreedingState& state) {
    if (base.breeding().panel == 0 || generation_of(state.main) == 0) return false;
    const std::vector<Side> sides = base.bred_sides();
    return std::any_of(sides.begin(), sides.end(),
                       [&](Side side) { return at(state.main.generations, side).back().panel < 0; });
}

}  // namespace

// Finds the side of the breed, and tries its genes at both ends of their ranges.
std::vector<Error> BreedingBase::read_breed(std::size_t index, const TomlFile& file) {
    const Breed& breed = breeding_.breeds[index];
    const auto is_kind = [&](Side each) { return kind(each).name == breed.kind; };
    const auto side = std::find_if(both_sides.begin(), both_sides.end(), is_kind);
    if (side == both_sides.end()) {
        const std::string_view known[]{kind(Side::predator).name, kind(Side::prey).name};
        return {error_of(message_of("breed_without_side", in_quotes(breed.kind)) + nearest_of(breed.kind, known),
                         breeding_.file, breed.line)};
    }
    if (at(breeds_, *side) >= 0)
        return {error_of(message_of("breed_twice", in_quotes(breed.kind)), breeding_.file, breed.line)};
    at(breeds_, *side) = static_cast<int>(index);
    at(files_, *side) = std::make_shared<const TomlFile>(file_of_kind(file, breed.kind));
    std::vector<Error> errors;
    for (float Gene::*end : {&Gene::low, &Gene::high}) {
        Genome genome;
        for (const Gene& gene : breed.genes) genome.push_back(gene.*end);
        for (Error& each : read_scene_fully(file, "", settings_of(breeding_, breed, genome)).errors)
            errors.push_back(std::move(each));
    }
    return errors;
}

std::vector<Error> BreedingBase::read(Breeding breeding, std::string_view scene_text, const std::string& scene_file) {
    breeding_ = std::move(breeding);
    auto file = parse_toml(scene_text, scene_file);
    if (!file) return {file.error()};
    ReadScene scene = read_scene_fully(*file, "", {});
    if (!scene.errors.empty()) return std::move(scene.errors);
    scene_ = std::move(scene.scene);
    const auto world = World::create(scene_, 1);
    if (!world) return {world.error()};
    const Snapshot start = snapshot_of(*world);
    for (const Side side : both_sides)
        if (auto error = find_kind(start, side, scene_file, at(kinds_, side))) return {*error};

    std::vector<Error> errors;
    for (std::size_t i = 0; i < breeding_.breeds.size(); ++i)
        for (Error& each : read_breed(i, *file)) errors.push_back(std::move(each));
    Breeding same = breeding_;
    same.generations = Breeding{}.generations, same.title.clear(), same.story.clear(), same.scene.clear();
    fingerprint_ = maths::fnv(write_scene(scene_), maths::fnv(write_breeding(same)));
    return errors;
}

Result<std::shared_ptr<const BreedingBase>> BreedingBase::create(Breeding breeding, std::string_view scene_text,
                                                                 const std::string& scene_file) {
    auto base = std::make_shared<BreedingBase>();
    if (auto errors = base->read(std::move(breeding), scene_text, scene_file); !errors.empty()) return errors.front();
    return std::shared_ptr<const BreedingBase>(std::move(base));
}

std::vector<Error> BreedingBase::errors(Breeding breeding, std::string_view scene_text, const std::string& scene_file) {
    const std::string file = breeding.file;
    return in_order(BreedingBase().read(std::move(breeding), scene_text, scene_file), file);
}

const Breed* BreedingBase::breed(Side side) const {
    const int index = at(breeds_, side);
    return index < 0 ? nullptr : &breeding_.breeds[static_cast<std::size_t>(index)];
}

std::vector<Side> BreedingBase::bred_sides() const {
    std::vector<Side> sides;
    for (const Side side : both_sides)
        if (breed(side)) sides.push_back(side);
    return sides;
}

Kind BreedingBase::kind_of(Side side, const Genome& genome) const {
    const Breed* own = breed(side);
    if (!own || genome.empty()) return kind(side);
    // create() has checked the paths; read_scene() would list all paths of the scene for that, twice as long.
    TomlFile file = *at(files_, side);
    for (const Setting& setting : settings_of(breeding_, *own, genome)) put(file.root, setting);
    return std::move(read_scene(std::move(file), "", {})->kinds.front());
}

struct BredKind::Made {
    const BreedingBase& base;
    Side side;
    Genome genome;
    std::once_flag once{};
    Kind kind{};
};

BredKind::BredKind(const BreedingBase& base, Side side, Genome genome)
    : made_(new Made{base, side, std::move(genome)}) {}

const Kind& BredKind::operator*() const {
    std::call_once(made_->once, [&] { made_->kind = made_->base.kind_of(made_->side, made_->genome); });
    return made_->kind;
}

const Genome& BredKind::genome() const { return made_->genome; }

BreedingState begin_breeding(const BreedingBase& base) {
    BreedingState state;
    for (const Side side : both_sides) {
        at(state.main.population, side) = first_population(base, side, run_seed(base.breeding(), false));
        if (base.breeding().panel > 0)
            at(state.panel.population, side) = first_population(base, side, run_seed(base.breeding(), true));
    }
    return state;
}

std::vector<Trial> next_trials(const BreedingBase& base, const BreedingState& state, int generations) {
    if (breeds_panel(base, state)) return trials_of_generation(base, state.panel, true);
    std::vector<Trial> trials;
    if (awaits_panel(base, state)) trials = trials_of_panel(base, state);
    if (generation_of(state.main) <= generations)
        for (Trial& each : trials_of_generation(base, state.main, false)) trials.push_back(std::move(each));
    return trials;
}

void advance(const BreedingBase& base, BreedingState& state, const std::vector<float>& numbers) {
    if (breeds_panel(base, state)) return advance_generation(base, state.panel, true, numbers);
    const std::size_t of_panel = awaits_panel(base, state) ? take_panel_scores(base, state, numbers) : 0;
    if (of_panel < numbers.size()) advance_generation(base, state.main, false, std::span(numbers).subspan(of_panel));
}

int complete_generations(const BreedingBase& base, const BreedingState& state) {
    return generation_of(state.main) - (awaits_panel(base, state) ? 1 : 0);
}

}  // namespace braitenlab::evolve
