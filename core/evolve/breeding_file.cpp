#include "core/evolve/breeding_file.h"

#include <filesystem>

#include <fmt/format.h>

#include "core/messages.h"
#include "core/scene/format_table.h"
#include "core/scene/nearest.h"
#include "core/scene/toml_reader.h"
#include "core/scene/toml_writer.h"

namespace braitenlab {

using evolve::Breed;
using evolve::Breeding;
using evolve::Gene;

void describe(auto& v, Of<Gene>) {
    v.text("name", &Gene::name, limits::name_length, "of the gene; must be given");
    v.texts("paths", &Gene::paths, evolve::limits::paths, limits::text_length,
            "of the values of the kind that get the number, like `brain.LL`; a path that begins with `-` gets the "
            "negative number");
    v.number("low", &Gene::low, "", {-1000, 1000}, "smallest number");
    v.number("high", &Gene::high, "", {-1000, 1000}, "largest number; a mutation beyond a limit is reflected at it");
    v.number("mutation", &Gene::mutation, "", {0, 1000}, "standard deviation of the change of a child");
    v.number("start", &Gene::start, "", {-1000, 1000},
             "number of the first parent, with `from_scene`; brought into the range");
}

void describe(auto& v, Of<Breed>) {
    v.text("kind", &Breed::kind, limits::name_length, "a kind of the scene with the role predator or prey");
    v.list("gene", &Breed::genes, evolve::limits::genes, "a number that is inherited; at least one");
}

void describe(auto& v, Of<Breeding>) {
    using namespace evolve::limits;
    v.text("title", &Breeding::title, limits::title_length, "must be given");
    v.text("story", &Breeding::story, limits::text_length, "what the breeding asks, in a sentence or two");
    v.text("scene", &Breeding::scene, limits::text_length,
           "a path relative to this file, or the name of a shipped scene; must be given");
    v.number("seconds", &Breeding::seconds, "s", {1, 600}, "of a trial at most; it ends when the prey is eaten");
    v.number("generations", &Breeding::generations, "", {1, generations}, "after the first one");
    v.number("population", &Breeding::population, "", {2, population}, "individuals of each side");
    v.number("parents", &Breeding::parents, "", {1, population}, "the best individuals, which have children");
    v.number("elite", &Breeding::elite, "", {0, population},
             "parents that stay in the population unchanged; all of them make a (μ + λ) strategy; with `generalist` "
             "all stay");
    v.number("trials", &Breeding::trials, "", {1, trials}, "of each individual in each generation");
    v.text("fitness", &Breeding::fitness, limits::name_length,
           "the number of a trial: `time_to_capture` or a measure of studies, see below");
    v.word("predator_better", &Breeding::predator_better,
           "whether less or more of this number is better for the predator; the opposite is better for the prey");
    v.word("opponents", &Breeding::opponents, "whom an individual meets in its trials");
    v.number("remembered", &Breeding::remembered, "", {1, generations}, "generations, for `best_of_last`");
    v.flag(
        "from_scene", &Breeding::from_scene,
        "the first generation are children of one parent with the numbers `start`, and it itself, instead of random");
    v.number("seed", &Breeding::seed, "", {0, 1e15}, "of the whole breeding");
    v.number("panel", &Breeding::panel, "", {0, panel},
             "opponents of each side that are bred apart and never decide who has children; 0: none");
    v.number("panel_generations", &Breeding::panel_generations, "", {1, generations}, "of the breeding of the panel");
    v.list("breed", &Breeding::breeds, 2, "a kind that evolves; the other side, if any, stays as in the scene");
}

namespace evolve {

namespace {

// A misspelt key is an error already.
void fail_missing(TomlTable& table, std::string_view key, const std::vector<std::string_view>& own, Message what) {
    if (!table.fail_if_misspelt(key, own, {})) table.fail_missing(key, std::move(what));
}

void check_genes(TomlTable& table, Breed& breed) {
    const std::vector<std::string_view> own{"kind", "gene"};
    if (breed.kind.empty()) fail_missing(table, "kind", own, message_of("missing_in_breed", "kind"));
    if (const TomlNode* kind = table.content().get("kind")) breed.line = static_cast<int>(kind->place.line);
    if (breed.genes.empty()) return fail_missing(table, "gene", own, message_of("missing_in_breed", "gene"));
    const TomlNode::List& tables = *table.content().get("gene")->as_list();
    for (std::size_t i = 0; i < breed.genes.size(); ++i) {
        Gene& gene = breed.genes[i];
        TomlTable inner(table.file(), tables[i], fmt::format("{}.{}", table.path("gene"), i + 1));
        for (const char* needed : {"name", "paths"})
            if (!inner.has(needed))
                fail_missing(inner, needed, {"name", "paths", "low", "high", "mutation", "start"},
                             message_of("missing_in_gene", needed));
        const Message no_range = message_of("gene_without_range", in_quotes(gene.name));
        if (gene.low >= gene.high)
            inner.has("high") ? inner.fail("high", no_range) : inner.fail_missing("high", no_range);
        if (const TomlNode* paths = tables[i].get("paths"); paths && paths->as_list())
            for (const TomlNode& path : *paths->as_list()) gene.lines.push_back(static_cast<int>(path.place.line));
    }
}

void read_fitness(TomlTable& top, Breeding& breeding) {
    if (breeding.fitness == time_to_capture) return;
    breeding.measure = find_word(insight::study_measure_table, breeding.fitness);
    if (breeding.measure) return;
    std::vector<std::string_view> known = words_of(insight::study_measure_table);
    known.insert(known.begin(), time_to_capture);
    top.fail("fitness", message_of("no_measure", in_quotes(breeding.fitness)) + nearest_of(breeding.fitness, known));
}

void check_breeding(TomlTable& top, Breeding& breeding) {
    for (const char* needed : {"title", "scene", "breed"})
        if (!top.has(needed)) fail_missing(top, needed, {}, message_of("missing_in_breeding", needed));
    const auto is_read = [&](const char* key) { return !top.file().failed_at(key); };
    if (breeding.parents > breeding.population && is_read("population"))
        top.fail("parents", message_of("exceeds", "parents", breeding.parents, "population", breeding.population));
    if (breeding.elite > breeding.parents && is_read("parents"))
        top.fail("elite", message_of("exceeds", "elite", breeding.elite, "parents", breeding.parents));
    read_fitness(top, breeding);
    for (std::size_t i = 0; i < breeding.breeds.size(); ++i) {
        TomlTable table(top.file(), (*top.content().get("breed")->as_list())[i], fmt::format("breed.{}", i + 1));
        check_genes(table, breeding.breeds[i]);
    }
}

Breeding read_breeding_file(TomlFile& file) {
    Breeding breeding;
    breeding.id = std::filesystem::path(file.name).stem().string();
    breeding.file = file.name;
    TomlTable top = read_top(file, breeding);
    check_breeding(top, breeding);
    return breeding;
}

}  // namespace

Result<Breeding> parse_breeding(std::string_view toml, const std::string& file_name) {
    return read_whole(toml, file_name, read_breeding_file);
}

ReadFile<Breeding> read_breeding_fully(std::string_view toml, const std::string& file_name) {
    return read_fully(toml, file_name, read_breeding_file);
}

std::string write_breeding(const Breeding& breeding) { return write_top(breeding); }

std::vector<TranslatableText> texts_of(const Breeding& breeding) {
    const std::string begin = "breeding." + breeding.id + ".";
    std::vector<TranslatableText> texts{{begin + "title", breeding.title}};
    if (!breeding.story.empty()) texts.push_back({begin + "story", breeding.story});
    return texts;
}

std::string describe_breeding_format() {
    std::string text =
        describe_top<Breeding>() + "\n## Opponents\n\n| `opponents` | An individual meets |\n|---|---|\n";
    for (const OpponentsTraits& row : opponents_table) text += fmt::format("| `{}` | {} |\n", row.word, row.meaning);
    text += fmt::format(
        "\n## Fitness\n\n| `fitness` | Unit | Number of a trial |\n|---|---|---|\n| `{}` | s | until the prey is "
        "eaten, "
        "which ends the trial |\n",
        time_to_capture);
    for (const auto& row : insight::study_measure_table)
        text += fmt::format("| `{}` | {} | {} |\n", row.word, row.unit, row.meaning);
    return text;
}

}  // namespace evolve

}  // namespace braitenlab
