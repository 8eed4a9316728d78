// The breeding on its sheet: while it runs, its generations are bred in the background and their champions meet in a
// matrix. Two of these matches can be watched, by themselves those of the last and of the first champions, opened as a
// scene, or taken into the open scene.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/jobs/asked.h"
#include "core/evolve/duel.h"
#include "core/evolve/verdict.h"
#include "ui/request.h"

namespace braitenlab {

struct Workspace;
struct BreedingView;

using BreedingBasePtr = std::shared_ptr<const evolve::BreedingBase>;
using BreedingStatePtr = std::shared_ptr<const evolve::BreedingState>;
using TrialsPtr = std::shared_ptr<const std::vector<evolve::Trial>>;

// What has been bred with one choice of scheme and numbers.
struct Bred {
    BreedingStatePtr state;                         // never null
    std::map<std::pair<int, int>, float> scores{};  // of the predator, by its generation and that of the prey
};

// The matches to watch.
struct DuelsQuestion {
    std::uint64_t fingerprint = 0;  // of the breeding
    std::vector<BreedingCell> cells;
    bool is_of_panel = false;  // their champions are those of the panel's breeding
    friend bool operator==(const DuelsQuestion&, const DuelsQuestion&) = default;
};

// All matches from the start that is nearest to their scores.
struct WatchedDuels {
    std::vector<evolve::Duel> duels;
    evolve::MatchStart start;
    std::uint64_t seed = 0;
};

struct BreedingRuns {
    BreedingBasePtr base{};                  // null: none is open
    std::optional<Error> error{};            // why the last one could not be opened
    std::map<std::uint64_t, Bred> bred{};    // since the start of the program, by fingerprint; has that of `base`
    std::filesystem::path kept_in{};         // folder of what is kept for the next start; empty: nothing is
    std::uintmax_t most_bytes = 64U << 20U;  // of all states there
    std::optional<Error> not_kept{};         // why what was bred last could not be written there
    int kept_for = 0;                        // generations of the file that is kept of `base`; 0: none yet
    std::string last{};                      // name or path of the breeding opened last; empty: none
    int shown = 0;                           // see BreedingView
    bool runs = false;
    double generation_began = 0;                // wall time, s, while it runs
    std::optional<float> generation_seconds{};  // measured, of the last ones; the newer, the more it counts
    bool fills = false;                         // computes the matrix of what was read, without breeding
    Job<TrialsPtr> trials{};                    // those of the next generation
    Job<BreedingStatePtr> generation{};         // its end
    Job<std::vector<float>> scores{};           // of `cells`
    std::vector<BreedingCell> cells{};
    evolve::Tournament matrix{};  // of the complete generations, see matrix_generations()
    evolve::BySide<evolve::Verdict> verdicts{};
    Asked<DuelsQuestion, WatchedDuels> duels{};
    bool has_choice = false;  // of a match to watch; without one the last champions are watched while it runs
    double duels_asked = 0;   // wall time, s
};

// The generations of the matrix while `complete` of them exist and `last` is the one to end with: at distances of 1, 2,
// 4 … at most 21, and `last`. So no score is computed in vain when the matrix grows.
std::vector<int> matrix_generations(int complete, int last);

// Sets the folder, and what an earlier start of the lab had as `last`. One that is gone is forgotten.
void begin_breedings(BreedingRuns&, std::filesystem::path kept_in, const std::string& last);

// Opens the breeding of a file, with what was bred beside it (braitenctl breed --out), and shows its sheet. What is
// bred on is kept for the next start; the folder of the file is not changed.
void show_breeding(BreedingRuns&, const std::filesystem::path&);

// Executes a request. Returns the request that opens the scene of a match.
std::optional<OpenRequest> handle_breeding(BreedingRuns&, Workspace&, const BreedingRequest&);

// Call once per turn, after Jobs::deliver. `now`: wall time, s.
void update_breeding(BreedingRuns&, Jobs&, double now);

bool is_computing(const BreedingRuns&);

// Points into the runs. `now`: as update_breeding().
BreedingView breeding_of(const BreedingRuns&, double now);

}  // namespace braitenlab
