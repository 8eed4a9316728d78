// A breeding as its author writes it: a scene with a predator and a prey, what may change in their kinds, and the
// scheme of selection. The file format: docs/breeding.md.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/enum_table.h"
#include "core/insight/study_file.h"
#include "core/result.h"
#include "core/scene/translatable.h"

namespace braitenlab::evolve {

namespace limits {
inline constexpr int generations = 10'000, population = 1000, trials = 1000, panel = 64;
inline constexpr std::size_t genes = 64, paths = 16;
}  // namespace limits

// Whom the individuals of a generation meet in their trials.
enum class Opponents { last, best_of_last, random, archive, generalist };
struct OpponentsTraits {
    Opponents value;
    std::string_view word, meaning;
};
inline constexpr auto opponents_table = std::to_array<OpponentsTraits>({
    {Opponents::last, "last", "the champion of the last generation"},
    {Opponents::best_of_last, "best_of_last", "the champions of the last generations in turn, as many as `remembered`"},
    {Opponents::random, "random", "individuals of the other side's present generation, drawn at random"},
    {Opponents::archive, "archive", "champions of all earlier generations, drawn at random (a Hall of Fame)"},
    {Opponents::generalist, "generalist",
     "of the parents and all earlier champions of the other side those that differ most; a child takes the place of "
     "the worst parent only if it is not worse against any of them"},
});
static_assert(is_complete_table<opponents_table>());
constexpr const auto& table_of(Opponents) { return opponents_table; }

// Which number of a run is the better one.
enum class Better { less, more };
inline constexpr auto better_table = std::to_array<Word<Better>>({{Better::less, "less"}, {Better::more, "more"}});
static_assert(is_complete_table<better_table>());
constexpr const auto& table_of(Better) { return better_table; }

// The number of a trial: the time until the prey is eaten, which ends the trial, or a measure of studies after
// `seconds`. Measures of one vehicle are those of the prey.
inline constexpr std::string_view time_to_capture = "time_to_capture";

// A number that is inherited and mutated.
struct Gene {
    std::string name;
    std::vector<std::string> paths;  // in the kind: "brain.LL"; with '-' first: gets the negative number
    float low = -1, high = 1;        // of the number; a random first generation is uniform in it
    float mutation = 0.1F;           // standard deviation of the change of a child
    float start = 0;                 // of the first parent, with Breeding::from_scene
    std::vector<int> lines{};        // of the paths in the file
};

// A kind that evolves. Its role is its side.
struct Breed {
    std::string kind;
    std::vector<Gene> genes{};
    int line{};  // of the kind in the file
};

struct Breeding {
    std::string id;    // the file's name without folder and ending
    std::string file;  // as given, for messages
    std::string title, story;
    std::string scene;     // a path relative to the file, or the name of a shipped scene
    float seconds = 15;    // of a trial at most; it ends when the prey is eaten
    int generations = 40;  // after the first one, which is random
    int population = 20;   // of each side
    int parents = 5;       // the best, each with as many children as the others
    int elite = 1;         // of these, how many stay unchanged: 1 is a GA with elite, all is a (μ + λ) strategy; with
                           // Opponents::generalist all stay
    int trials = 10;       // of each individual in each generation
    std::string fitness{time_to_capture};          // or the word of a StudyMeasure
    std::optional<insight::StudyMeasure> measure;  // of this word
    Better predator_better = Better::less;         // of the number; for the prey the opposite
    Opponents opponents = Opponents::last;
    int remembered = 10;      // generations, for best_of_last
    bool from_scene = false;  // the first generation: the parent with the numbers Gene::start, and its children
    std::uint64_t seed = 1;
    int panel = 8;               // opponents of each side that are bred apart; 0: none
    int panel_generations = 20;  // of the breeding of the panel
    std::vector<Breed> breeds;   // one or two; a side without one stays as in the scene
};

// Errors carry file and line: syntax, unknown keys and measures, missing values, ranges, more parents than individuals.
Result<Breeding> parse_breeding(std::string_view toml, const std::string& file_name);

// As parse_breeding(), with every independent error by line.
ReadFile<Breeding> read_breeding_fully(std::string_view toml, const std::string& file_name);

// The file of a breeding, without values at their defaults.
std::string write_breeding(const Breeding&);

std::vector<TranslatableText> texts_of(const Breeding&);

// The tables of docs/breeding.md, in Markdown.
std::string describe_breeding_format();

}  // namespace braitenlab::evolve
