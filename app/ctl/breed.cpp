// braitenctl breed: predators and prey that evolve against each other.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <iostream>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "app/ctl/ctl.h"
#include "app/ctl/parts.h"
#include "app/ctl/progress.h"
#include "app/ctl/table_file.h"
#include "app/files/breeding_files.h"
#include "app/files/data.h"
#include "app/files/safe_file.h"
#include "app/files/study_files.h"
#include "app/platform/platform.h"
#include "app/reports/breeding_drawing.h"
#include "app/reports/breeding_table.h"
#include "app/terminal.h"
#include "core/evolve/breeding.h"
#include "core/evolve/tournament.h"
#include "core/evolve/verdict.h"
#include "core/io/checked_json.h"
#include "core/scene/scene_file.h"
#include "core/text_parts.h"

namespace braitenlab {

namespace {

namespace fs = std::filesystem;
using evolve::BreedingBase;
using evolve::BreedingState;
using evolve::Generation;
using evolve::Side;
using evolve::Trial;
using Base = std::shared_ptr<const BreedingBase>;

constexpr int matrix_generations = 40;  // at most, of each side

Part part_of_trials(const Base& base, std::vector<Trial> trials) {
    return [base, list = std::make_shared<const std::vector<Trial>>(std::move(trials))](std::size_t part) {
        return Numbers{static_cast<double>(evolve::run_of(*base, (*list)[part]))};
    };
}

// Each genome stands once: a kind of many trials stays one kind.
std::string text_of_trials(const BreedingBase& base, const std::vector<Trial>& trials) {
    nlohmann::json list, genomes;
    evolve::BySide<std::vector<evolve::BredKind>> kinds;
    for (const Trial& trial : trials) {
        nlohmann::json& each = list.emplace_back();
        for (const Side side : evolve::both_sides) {
            auto& known = at(kinds, side);
            const auto kind = std::find(known.begin(), known.end(), at(trial.kinds, side));
            each.push_back(kind - known.begin());
            if (kind != known.end()) continue;
            known.push_back(at(trial.kinds, side));
            genomes[static_cast<std::size_t>(side)].push_back(known.back().genome());
        }
        each.push_back(trial.seed);
    }
    return "breed\n" + io::json_text(nlohmann::json{{"breeding", write_breeding(base.breeding())},
                                                    {"scene", write_scene(base.scene())},
                                                    {"genomes", genomes},
                                                    {"trials", list}});
}

std::vector<Trial> trials_of_json(const BreedingBase& base, const nlohmann::json& json) {
    evolve::BySide<std::vector<evolve::BredKind>> kinds;
    for (const Side side : evolve::both_sides)
        for (const auto& genome : json.at("genomes").at(static_cast<std::size_t>(side)))
            at(kinds, side).emplace_back(base, side, genome.get<evolve::Genome>());
    std::vector<Trial> trials;
    for (const auto& each : json.at("trials")) {
        Trial& trial = trials.emplace_back();
        for (const Side side : evolve::both_sides)
            at(trial.kinds, side) = at(kinds, side).at(each.at(static_cast<std::size_t>(side)).get<std::size_t>());
        trial.seed = each.at(evolve::both_sides.size()).get<std::uint64_t>();
    }
    return trials;
}

// The same base for the same texts as before: all lists of a command have one breeding.
Result<Base> base_of_texts(std::string breeding_text, std::string scene_text) {
    static std::string last_breeding, last_scene;
    static Base last;
    if (last && breeding_text == last_breeding && scene_text == last_scene) return last;
    auto breeding = evolve::parse_breeding(breeding_text, "breeding.toml");
    if (!breeding) return breeding.error();
    auto base = BreedingBase::create(std::move(*breeding), scene_text, "scene.toml");
    if (!base) return base.error();
    last_breeding = std::move(breeding_text), last_scene = std::move(scene_text), last = *base;
    return last;
}

// The numbers of the trials in their order; empty when there are none, or the user has interrupted the program.
// Calls meanwhile() while the trials run.
Result<std::vector<float>> run_trials(
    PartRunner& runner, const Base& base, const std::vector<Trial>& trials,
    const std::function<void()>& meanwhile = [] {}) {
    if (trials.empty()) return meanwhile(), std::vector<float>{};
    const auto results = runner.run(
        {trials.size(), part_of_trials(base, trials), [&] { return text_of_trials(*base, trials); }, meanwhile});
    if (!results) return results.error();
    std::vector<float> numbers;
    for (const Numbers& each : *results) numbers.push_back(static_cast<float>(each.at(0)));
    return numbers;
}

struct Bred {
    BreedingState state;
    std::size_t trials = 0;  // by this command
    bool is_complete = false;
};

// Breeds on, and writes the state after each generation, while the next one is computed.
Result<Bred> breed_on(const Base& base, BreedingState state, int generations, int threads, const fs::path& folder) {
    PartRunner runner(threads);
    const auto done = [&](const BreedingState& s) {
        return static_cast<std::size_t>(complete_generations(*base, s)) + s.panel.generations.front().size();
    };
    const int of_panel = base->breeding().panel > 0 ? base->breeding().panel_generations + 1 : 0;
    Progress progress = progress_of("generations, those of the panel included",
                                    static_cast<std::size_t>(generations + 1 + of_panel), done(state));
    Bred bred{.state = std::move(state)};
    bool is_written = true;
    std::optional<Error> error;
    const auto write = [&] {
        if (std::exchange(is_written, true)) return;
        error = write_breeding_state(*base, bred.state, folder);
        progress.at(done(bred.state));
    };
    for (;;) {
        const auto numbers = run_trials(runner, base, next_trials(*base, bred.state, generations), write);
        if (error) return *error;
        if (!numbers) return numbers.error();
        if (numbers->empty()) break;
        advance(*base, bred.state, *numbers);
        bred.trials += numbers->size();
        is_written = false;
    }
    bred.is_complete = !is_told_to_end();
    return bred;
}

std::vector<float> panel_scores(const BreedingState& state, Side side) {
    std::vector<float> scores;
    for (const Generation& each : at(state.main.generations, side)) scores.push_back(each.panel);
    return scores;
}

std::string trend_text(const std::vector<float>& scores) {
    const evolve::Trend trend = evolve::trend_of(scores);
    const auto interval = evolve::correlation_interval(scores);
    const std::string of = interval ? fmt::format("95 % interval {:+.2f} to {:+.2f}", interval->low, interval->high)
                                    : std::string("no interval");
    return fmt::format(
        "{:.3f} in the first quarter of the generations, {:.3f} in the last; correlation with the generation {:+.2f} "
        "({}, {} generations)",
        trend.first, trend.last, trend.correlation, of, scores.size());
}

std::string summary_text(const BreedingBase& base, const BreedingState& state) {
    std::string text = fmt::format("{:>10}", "generation");
    for (const Side side : base.bred_sides())
        for (const char* column : {"best", "median", "diversity", "panel"})
            text += fmt::format("  {:>18}", fmt::format("{} {}", word(side), column));
    text += '\n';
    const int count = complete_generations(base, state), rows = std::min(count, 11);
    for (int row = 0; row < rows; ++row) {
        const auto generation = static_cast<std::size_t>(rows == 1 ? 0 : row * (count - 1) / (rows - 1));
        text += fmt::format("{:>10}", generation);
        for (const Side side : base.bred_sides()) {
            const Generation& g = at(state.main.generations, side)[generation];
            for (const float number : {g.best, g.median, g.diversity, g.panel})
                text += fmt::format("  {:>18}", number < 0 ? "–" : fmt::format("{:.3f}", number));
        }
        text += '\n';
    }
    if (rows < count) text += fmt::format("{} of {} generations; --csv has all\n", rows, count);
    text +=
        "\nbest and median: scores against the opponents of the generation, which change, too; a rise there is no "
        "progress by itself.\n";
    if (base.breeding().panel == 0) return text;
    text += "panel: score of the best against opponents that were bred apart and never decided who had children.\n";
    for (const Side side : base.bred_sides())
        text += fmt::format("{} against the panel: {}\n", word(side), trend_text(panel_scores(state, side)));
    return text;
}

std::string summary_json(const BreedingBase& base, const Bred& bred, double seconds) {
    const int generation = complete_generations(base, bred.state) - 1;
    nlohmann::ordered_json json;
    json["generation"] = generation;
    for (const Side side : base.bred_sides()) {
        const Generation& last = at(bred.state.main.generations, side)[static_cast<std::size_t>(generation)];
        const std::string name(word(side));
        json["best"][name] = last.best;
        json["panel"][name] = last.panel < 0 ? nlohmann::ordered_json() : nlohmann::ordered_json(last.panel);
    }
    json["trials"] = bred.trials, json["seconds"] = seconds;
    return io::json_text(json) + "\n";
}

int breed_into(const BreedOptions& options, const Base& base, const fs::path& folder) {
    const bool has_state = holds_breeding(folder);
    if (has_state && !options.goes_on)
        return complain({"holds a breeding; add --continue to go on with it, or give another folder", folder.string()});
    if (!has_state) {
        if (const auto error = other_breeding_fault(*base, folder)) return complain(*error);
        if (const auto error = write_breeding_files(*base, folder)) return complain(*error);
    }
    const fs::path lock = folder / "state.json.lock";
    auto held = lock_file(lock);
    if (!held) return complain({"another breeding writes into this folder; wait for its end", folder.string()});
    const HeldLock lock_of_folder(lock, std::move(*held));
    auto state = has_state ? read_breeding_state(*base, folder) : begin_breeding(*base);
    if (!state) return complain(state.error());

    const auto began = std::chrono::steady_clock::now();
    const int generations = options.generations > 0 ? options.generations : base->breeding().generations;
    const auto bred = breed_on(base, std::move(*state), generations, options.threads, folder);
    if (!bred) return complain(bred.error());
    if (!bred->is_complete) {
        std::cerr << format_lines("braitenctl: interrupted after {} generations; --continue goes on with {}\n",
                                  complete_generations(*base, bred->state), folder.string());
        return exit_code::interrupted;
    }
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - began;
    std::cout << (options.json ? summary_json(*base, *bred, passed.count()) : summary_text(*base, bred->state));
    return exit_code::done;
}

std::string verdict_text(const evolve::Verdict& verdict) {
    std::string course(word(verdict.course));
    std::replace(course.begin(), course.end(), '_', ' ');
    if (verdict.course == evolve::Course::too_early) return course;
    return fmt::format("{}; against the opponents of generations {} to {} the champions of {} to {} gain {:+.2f}",
                       course, verdict.earlier.first, verdict.earlier.last, verdict.late.first, verdict.late.last,
                       verdict.gain);
}

std::string matrix_text(const evolve::Tournament& tournament) {
    std::string text;
    for (const Side side : evolve::both_sides) {
        std::vector<float> scores;
        for (std::size_t own = 0; own < tournament.size(); ++own) scores.push_back(tournament.master_score(side, own));
        text += fmt::format("{0} against all generations: {1}\n{0} in a word: {2}\n", word(side), trend_text(scores),
                            verdict_text(evolve::verdict_of(tournament, side)));
    }
    text +=
        "Report the word with its gain: it compares quarters of the matrix, so that it finds a lost ability. \"Against "
        "all\n"
        "generations\" is the mean over all opponents: it can rise although one kind of them wins again.\n"
        "\"Against the panel\" has other opponents, bred apart, and can say something else: report it as well. A rise "
        "there\n"
        "with an unclear word: better against strangers, not against the earlier opponents of this breeding.\n";
    return text;
}

Result<evolve::Tournament> run_tournament(const BreedOptions& options, const Base& base, const BreedingState& state) {
    PartRunner runner(options.threads);
    if (is_terminal(stderr)) std::cerr << "braitenctl: all champions meet; this takes some seconds\n";
    const auto numbers = run_trials(runner, base, trials_of_tournament(*base, state, matrix_generations));
    if (!numbers) return numbers.error();
    if (numbers->empty()) return evolve::Tournament{};
    return tournament_of(*base, state, matrix_generations, *numbers);
}

int print_matrix(const BreedOptions& options, const Base& base, const BreedingState& state, const Strings& strings,
                 const io::CsvStyle& style) {
    if (options.matrix != "ciao" && options.matrix != "master")
        return complain({"--matrix is ciao (against ancestors) or master (against all)"});
    const MatrixKind kind = options.matrix == "ciao" ? MatrixKind::ciao : MatrixKind::master;
    const auto tournament = run_tournament(options, base, state);
    if (!tournament) return complain(tournament.error());
    if (tournament->size() == 0) return interrupted();
    if (const auto error = write_table(options.csv, style, matrix_table(*tournament, kind))) return complain(*error);
    if (!options.svg.empty())
        if (const auto error =
                write_whole(options.svg, matrix_drawing(*base, *tournament, kind, options.labels, strings)))
            return complain(*error);
    if (options.csv != standard_output) std::cout << matrix_text(*tournament);
    return exit_code::done;
}

// All numbers and drawings of a breeding, in a folder.
int write_report(const BreedOptions& options, const Base& base, const BreedingState& state, const Strings& strings,
                 const io::CsvStyle& style) {
    const auto tournament = run_tournament(options, base, state);
    if (!tournament) return complain(tournament.error());
    if (tournament->size() == 0) return interrupted();
    const fs::path folder = options.report;
    const auto matrix = [&](MatrixKind kind) {
        return matrix_drawing(*base, *tournament, kind, options.labels, strings);
    };
    const std::string words = summary_text(*base, state) + matrix_text(*tournament);
    const std::array<std::string, breeding_report_files.size()> texts{
        breeding_json(*base, state, *tournament),
        curves_drawing(*base, state, options.labels, strings),
        matrix(MatrixKind::ciao),
        matrix(MatrixKind::master),
        std::string(style.has_byte_order_mark ? io::byte_order_mark : "") +
            io::in_style(breeding_table(*base, state, &*tournament), style),
        words};
    std::vector<NewFile> files;
    for (std::size_t i = 0; i < texts.size(); ++i) files.push_back({folder / breeding_report_files[i], texts[i]});
    if (const auto error = write_all(files)) return complain(*error);
    std::cout << words;
    return exit_code::done;
}

int print_scores(const BreedOptions& options, const Base& base, const BreedingState& state, const Strings& strings,
                 const io::CsvStyle& style) {
    if (const auto error = write_table(options.csv, style, breeding_table(*base, state, nullptr)))
        return complain(*error);
    if (!options.svg.empty())
        if (const auto error = write_whole(options.svg, curves_drawing(*base, state, options.labels, strings)))
            return complain(*error);
    return exit_code::done;
}

int analyse(const BreedOptions& options, const Base& base, const BreedingState& state) {
    std::vector<TranslatableText> texts;  // a folder's copy has another id than the shipped breeding
    for (const evolve::Breeding& shipped : shipped_breeding_list())
        for (TranslatableText& text : texts_of(shipped)) texts.push_back(std::move(text));
    const auto strings = strings_with(options.table.language, texts);
    if (!strings) return complain(strings.error());
    const auto style = style_of(options.table);
    if (!style) return complain(style.error());
    if (const auto error = ending_fault("--svg", options.svg, ".svg")) return complain(*error);
    const auto task = !options.report.empty() ? write_report : !options.matrix.empty() ? print_matrix : print_scores;
    return task(options, base, state, *strings, *style);
}

// The generation at the end of the text, of those that are complete.
Result<std::size_t> generation_of(const std::string& option, std::string_view text, int complete) {
    const auto generation = whole_number<int>(text);
    if (!generation || *generation < 0 || *generation >= complete)
        return Error{fmt::format("'{}' is no generation; give one of 0 to {}", text, complete - 1), option};
    return static_cast<std::size_t>(*generation);
}

int write_champion(const BreedOptions& options, const BreedingBase& base, const BreedingState& state) {
    const std::string option = "--champion";
    const std::size_t colon = options.champion.find(':');
    const std::string name = options.champion.substr(0, colon);
    const auto side =
        std::find_if(evolve::both_sides.begin(), evolve::both_sides.end(), [&](Side s) { return word(s) == name; });
    if (side == evolve::both_sides.end() || colon == std::string::npos)
        return complain({"write predator:GENERATION or prey:GENERATION", option});
    const auto generation =
        generation_of(option, std::string_view(options.champion).substr(colon + 1), complete_generations(base, state));
    if (!generation) return complain(generation.error());
    const Kind kind = base.kind_of(*side, at(state.main.generations, *side)[*generation].champion);
    if (const auto error = write_whole(options.out, write_brain(kind.brain))) return complain(*error);
    return exit_code::done;
}

// PREDATOR:PREY, two generations: the scene with both champions.
int write_match(const BreedOptions& options, const BreedingBase& base, const BreedingState& state) {
    const std::string option = "--match";
    const std::size_t colon = options.match.find(':');
    if (colon == std::string::npos) return complain({"write two generations, PREDATOR:PREY", option});
    Trial trial;
    for (const Side side : evolve::both_sides) {
        const std::string_view text = options.match;
        const auto generation =
            generation_of(option, side == Side::predator ? text.substr(0, colon) : text.substr(colon + 1),
                          complete_generations(base, state));
        if (!generation) return complain(generation.error());
        at(trial.kinds, side) = {base, side, at(state.main.generations, side)[*generation].champion};
    }
    if (const auto error = write_whole(options.out, write_scene(scene_of(base, trial)))) return complain(*error);
    return exit_code::done;
}

}  // namespace

Result<Part> part_of_breeding(std::string_view text) {
    const auto json = nlohmann::json::parse(text);
    const auto base = base_of_texts(json.at("breeding").get<std::string>(), json.at("scene").get<std::string>());
    if (!base) return base.error();
    return part_of_trials(*base, trials_of_json(**base, json));
}

int breed(const BreedOptions& options) {
    std::error_code none;
    const bool is_folder = fs::is_directory(options.file, none);
    const auto path = is_folder ? breeding_in(options.file) : find_shipped(options.file, Shipped::breeding);
    if (!path) return complain(path.error());
    const auto base = load_breeding(*path);
    if (!base) return complain_of_all(errors_of_breeding(*path));

    const bool analyses =
        !options.matrix.empty() || !options.svg.empty() || !options.csv.empty() || !options.report.empty();
    const bool asks = analyses || !options.champion.empty() || !options.match.empty();
    if (!asks) {
        const std::string folder = options.out.empty() && is_folder ? options.file : options.out;
        if (folder.empty()) return complain({"breed needs --out FOLDER for its results"});
        return breed_into(options, *base, folder);
    }
    if (!is_folder)
        return complain({"give the folder of a breeding, which breed FILE --out FOLDER has made", options.file});
    const auto state = read_breeding_state(**base, options.file);
    if (!state) return complain(state.error());
    if (complete_generations(**base, *state) == 0)
        return complain({"no generation is complete yet; breed on with --continue", options.file});
    if (analyses) return analyse(options, *base, *state);
    if (options.out.empty()) return complain({"give the file to write with --out FILE"});
    return options.match.empty() ? write_champion(options, **base, *state) : write_match(options, **base, *state);
}

}  // namespace braitenlab
