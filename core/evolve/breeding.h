// Breeding: two populations of brains, a predator's and a prey's, that are selected by their trials against each other.
//
//     while (const auto trials = next_trials(base, state); !trials.empty())
//         advance(base, state, results_of(trials));
//
// A state is a plain value. next_trials() depends on it alone and trials do not depend on each other, so any thread,
// process or machine may run them in any order; the same file gives the same states bit for bit.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "core/evolve/breeding_file.h"
#include "core/result.h"
#include "core/world/world.h"

namespace braitenlab {
struct TomlFile;  // core/scene/toml_tree.h
}

namespace braitenlab::evolve {

enum class Side { predator, prey };
inline constexpr auto side_table = std::to_array<Word<Side>>({{Side::predator, "predator"}, {Side::prey, "prey"}});
static_assert(is_complete_table<side_table>());
constexpr const auto& table_of(Side) { return side_table; }
inline constexpr auto both_sides = std::to_array({Side::predator, Side::prey});
constexpr Role role_of(Side side) { return side == Side::predator ? Role::predator : Role::prey; }
constexpr Side other(Side side) { return side == Side::predator ? Side::prey : Side::predator; }

template <class T>
using BySide = std::array<T, side_table.size()>;
template <class T>
constexpr auto& at(T& both, Side side) {
    return both[static_cast<std::size_t>(side)];
}

using Genome = std::vector<float>;  // a number for each gene; empty: the kind as in the scene

struct Individual {
    Genome genome;
    int parent = -1;  // index in the generation before; -1 in the first one
    friend bool operator==(const Individual&, const Individual&) = default;
};

// A complete generation of one side.
struct Generation {
    Genome champion;           // the best individual
    int index = 0;             // of the champion
    float best = 0;            // mean score of the champion in its trials, 0..1: see score_of()
    float median = 0;          // of the scores of all individuals
    float diversity = 0;       // mean of the standard deviations of the genes, as a share of their ranges
    float panel = -1;          // mean score of the champion against the panel; -1: not known
    std::vector<int> parents;  // of the individuals
    friend bool operator==(const Generation&, const Generation&) = default;
};

// Generations of both sides that are bred together.
struct Lineage {
    BySide<std::vector<Individual>> population;   // of the present generation, which has no scores yet
    BySide<std::vector<Generation>> generations;  // the complete ones
    friend bool operator==(const Lineage&, const Lineage&) = default;
};

struct BreedingState {
    Lineage panel;  // bred first; its champions are the panel
    Lineage main;
    friend bool operator==(const BreedingState&, const BreedingState&) = default;
};

// What all trials share. Constant, so that threads share it.
class BreedingBase {
public:
    // Fails when the scene has not one vehicle of each role, a breed names no such kind or two have the same role, or a
    // gene has a path that the kind does not have. Errors carry file and line.
    static Result<std::shared_ptr<const BreedingBase>> create(Breeding, std::string_view scene_text,
                                                              const std::string& scene_file);
    // Every independent error for which create() fails.
    static std::vector<Error> errors(Breeding, std::string_view scene_text, const std::string& scene_file);

    const Breeding& breeding() const { return breeding_; }
    const Scene& scene() const { return scene_; }
    // The breed of a side; null for a side that stays as in the scene.
    const Breed* breed(Side) const;
    std::vector<Side> bred_sides() const;  // those with a breed
    // The kind of a side in the scene.
    const Kind& kind(Side side) const { return scene_.kinds[static_cast<std::size_t>(at(kinds_, side))]; }
    // The same with the numbers of a genome.
    Kind kind_of(Side, const Genome&) const;

    // Equal for breedings with equal trials. The number of generations does not matter: more may be bred later.
    std::uint64_t fingerprint() const { return fingerprint_; }

private:
    std::vector<Error> read(Breeding, std::string_view scene_text, const std::string& scene_file);
    std::vector<Error> read_breed(std::size_t index, const TomlFile& scene);

    Breeding breeding_;
    Scene scene_;
    BySide<std::shared_ptr<const TomlFile>> files_;  // of the kinds that have a breed, see kind_of()
    BySide<int> kinds_{};                            // indices in the scene
    BySide<int> breeds_{-1, -1};                     // indices in the breeding
    std::uint64_t fingerprint_ = 0;
};

// The kind of a side with the numbers of a genome. Copies share it. It is made on first use, by any thread: a process
// that computes some trials of a list makes the kinds of these only.
class BredKind {
public:
    BredKind() = default;                              // of no side; has only operator==
    BredKind(const BreedingBase& base, Side, Genome);  // the base outlives it
    const Kind& operator*() const;
    const Kind* operator->() const { return &**this; }
    const Genome& genome() const;
    // True for copies of one kind.
    friend bool operator==(const BredKind&, const BredKind&) = default;

private:
    struct Made;
    std::shared_ptr<Made> made_;
};

// One run of a predator and a prey.
struct Trial {
    BySide<BredKind> kinds;
    std::uint64_t seed = 0;
};
// The scene of a trial. Opened with the trial's seed it is the trial: the same run, bit for bit.
Scene scene_of(const BreedingBase&, const Trial&);

// The number of the trial, see Breeding::fitness: seconds until the prey is eaten, Breeding::seconds if it is not; or
// the measure, INFINITY: never, NAN: there is none.
float run_of(const BreedingBase&, const Trial&);

// 0..1, of both sides together 1. A number x has the share x / Breeding::seconds of its range if it is a time, else
// x / (1 + x); INFINITY is 1, NAN one half. The share is the score of the prey, or with Better::more of the predator.
float score_of(const Breeding&, Side, float number);

BreedingState begin_breeding(const BreedingBase&);

// The trials that the next advance() needs; none once `generations` are complete. Those of the last champions against
// the panel come with those of the next generation, which do not depend on them: one wait for both.
std::vector<Trial> next_trials(const BreedingBase&, const BreedingState&, int generations);
// Takes run_of() each trial in their order.
void advance(const BreedingBase&, BreedingState&, const std::vector<float>& numbers);

// Complete generations with the score against the panel, if there is one.
int complete_generations(const BreedingBase&, const BreedingState&);

}  // namespace braitenlab::evolve
