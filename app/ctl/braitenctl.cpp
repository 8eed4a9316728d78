// Braitenlab without a window. Exit codes: 0 done or passed, 1 failed, 2 bad input, 130 interrupted.
#include <algorithm>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <string_view>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/ctl/ctl.h"
#include "app/ctl/outputs.h"
#include "app/ctl/ranks.h"
#include "app/files/data.h"
#include "app/platform/memory.h"
#include "app/platform/platform.h"
#include "app/reports/gradebook.h"
#include "app/terminal.h"
#include "core/evolve/breeding_file.h"
#include "core/export/export.h"
#include "core/insight/behaviour.h"
#include "core/io/vehicle_table.h"
#include "core/plain_letters.h"
#include "core/scene/nearest.h"

namespace braitenlab {

int complain(const Error& error) {
    std::cerr << "braitenctl: " << one_line(error.text()) << "\n";
    return exit_code::bad_input;
}

int complain_of_all(const std::vector<Error>& errors) {
    for (const Error& each : errors) complain(each);
    return exit_code::bad_input;
}

int interrupted() {
    std::cerr << "braitenctl: interrupted; no file has changed\n";
    return exit_code::interrupted;
}

std::optional<Error> ending_fault(std::string_view option, const std::string& file, std::string_view ending) {
    if (file.empty() || lower_case(std::filesystem::path(file).extension().string()) == ending) return std::nullopt;
    return Error{fmt::format("{} writes a file {}; end its name with it", option, ending), file};
}

std::optional<Error> json_beside_csv(std::string_view csv, bool json) {
    if (csv != standard_output || !json) return std::nullopt;
    return Error{"leaves no room for --json on standard output; leave it out, or give --csv a file", "--csv -"};
}

Result<Strings> strings_of(const std::string& language) {
    const auto data = data_folder();
    if (!data) return data.error();
    return load_language(*data / "ui" / "strings", language);
}

Result<Strings> strings_with(const std::string& language, const std::vector<TranslatableText>& texts) {
    auto strings = strings_of(language);
    if (!strings) return strings;
    const auto translations = *data_folder() / "exercises" / "words" / (language + ".toml");
    std::error_code none;
    if (!std::filesystem::exists(translations, none)) return strings;
    const auto words = Strings::load(translations);
    if (!words) return words.error();
    add_translations(*strings, texts, *words);
    return strings;
}

int threads_for(int wanted) {
    return wanted > 0 ? wanted : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

namespace {

std::string listed_words(const auto& table) { return fmt::format("{}", fmt::join(words_of(table), ", ")); }

std::string target_robots() {
    std::string words;
    for (const auto& row : robots::target_table)
        words += fmt::format("{}{} for {}", words.empty() ? "" : ", ", row.robot, row.word);
    return words;
}

// An option with a value, which the help calls `type`.
CLI::Option* add_value(CLI::App& command, const std::string& name, auto& value, const char* type,
                       const std::string& about) {
    return command.add_option(name, value, about)->type_name(type);
}

void add_choice(CLI::App& command, BrainChoice& choice) {
    auto* kind = command.add_option("--kind", choice.kind,
                                    "the kind whose brain is taken from a scene or a saved run; "
                                    "without it, the first vehicle's");
    command
        .add_option("--vehicle", choice.vehicle,
                    "the vehicle whose brain is taken, by its name in the scene; in a saved run also by its id")
        ->excludes(kind);
}

constexpr const char* brain_file_help =
    "a brain, a scene, a saved run, a hand-in, or the name of a shipped scene or preset";

// `also`: what else is in the language.
void add_table(CLI::App& command, TableOptions& table, const std::string& also = "") {
    command.add_flag("--excel", table.for_excel,
                     "write the table as the Excel of --lang opens it: with a byte order mark, and with semicolons and "
                     "decimal commas for de and es");
    add_value(command, "--lang", table.language, "CODE", "language of --excel" + also + "; default: en");
}

// `drawing`: the option that writes what the labels are for; null if there are several.
void add_labels(CLI::App& command, FigureLabels& labels, CLI::Option* drawing) {
    for (auto* label :
         {add_value(command, "--title", labels.title, "TEXT", "title of the drawing"),
          add_value(command, "--x-label", labels.x, "TEXT", "words at the horizontal axis, with the unit"),
          add_value(command, "--y-label", labels.y, "TEXT", "words at the vertical axis, with the unit")})
        if (drawing) label->needs(drawing);
}

void add_settings(CLI::App& command, std::vector<std::string>& settings, const std::string& what) {
    add_value(command, "--set", settings, "PATH=VALUE", "one value of the scene, " + what)
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_threads(CLI::App& command, int& threads, const std::string& what = "threads") {
    command.add_option("--threads", threads, what + "; without it, one per processor")->check(CLI::Range(1, 256));
}

void add_seconds(CLI::App& command, auto& seconds, const std::string& about, double least, double most) {
    command.add_option("--seconds", seconds, about)->check(CLI::Range(least, most));
}

void add_run(CLI::App& command, RunOptions& options) {
    command.add_option("SCENE", options.file, "a path, the bare name of a shipped scene, or a saved run (….run)")
        ->required();
    add_seconds(command, options.seconds, "simulated time; for a saved run: additional time", 0, 1e6);
    add_value(command, "--seed", options.seed, "SEED",
              "seed of the random numbers, 1 without it; the same seed gives the same run; A:B: a run per seed");
    add_settings(command, options.settings, "e.g. kind.prey.brain.LL=0.5; A:B:STEP or V1,V2,…: a run per value");
    command.add_flag("--json", options.json, "print the final state as one JSON object");
    add_value(command, "--csv", options.csv, "FILE", "write a row per vehicle per 0.1 s; -: to standard output");
    add_value(command, "--columns", options.columns, "WORD,…",
              "further columns of the CSV file: " + listed_words(io::column_group_table))
        ->delimiter(',')
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    add_table(command, options.table);
    add_threads(command, options.threads, "threads for several runs");
    command.add_flag("--hash", options.hash, "print the hash of the final state");
    add_value(command, "--save", options.save, "FILE.run", "write the run at its end, to continue it later");
}

void add_check(CLI::App& command, CheckOptions& options) {
    auto* name =
        command.add_option("EXERCISE", options.exercise, "a path, or the bare name of a shipped exercise or lecture");
    add_value(command, "--brain", options.brain, "FILE",
              "a brain, a scene or a saved run; without it, the brain as shipped and the exercise's own solution");
    add_choice(command, options.choice);
    command.add_option("--seed", options.seed, "seed of the first start; default: 1");
    command.add_flag("--json", options.json, "print each start with its steps as JSON");
    name->excludes(
        command.add_flag("--all", options.all, "every shipped exercise: fails as shipped, passes with its solution"));
}

void add_grade(CLI::App& command, ClassOptions& options) {
    command.add_option("EXERCISE", options.exercise, "a path, or the bare name of a shipped exercise")->required();
    command
        .add_option("FILE", options.files,
                    "a folder or a ZIP archive of hand-in files; or hand-ins, brains, scenes or saved runs")
        ->required();
    add_choice(command, options.choice);
    add_value(command, "--csv", options.csv, "FILE", "write the rows there instead of printing them");
    add_value(command, "--html", options.html, "FILE", "write a page with summary, paths and feedback");
    add_table(command, options.table, ", the feedback and the page");
    add_value(command, "--gradebook", options.platform, "PLATFORM",
              "write the marks as this platform imports them: " + listed_words(platform_table));
    add_value(command, "--marks", options.marks, "FILE", "the file of the marks; -: to standard output");
    add_value(command, "--list", options.list, "FILE", "the list of students that the platform has exported, as CSV");
    add_value(command, "--column", options.column, "NAME",
              "heading of the column of the marks; default: the platform's, in canvas the exercise's title");
    command
        .add_option("--points", options.points,
                    "the mark where all starts pass; default: that of the list, or the starts")
        ->check(CLI::Range(0.01, 10000.0));
    command.add_option("--seed", options.first_seed, "seed of the first start; default: 1");
}

// What the words of a map mean; docs/command-line.md has the rules with their numbers.
constexpr const char* words_of_map =
    R"(Measures: the object is the nearest source that the vehicle senses, else any source, else another vehicle.
  kind       the kind of behaviour, see below
  closest    closest approach: least distance of the run from the middle of the vehicle to the object, m
  final      distance from it at the end, m
  touch      time until the vehicle touches it, s; empty: never
  captures   bites by which predators have taken energy from prey
  survival   time until the vehicle dies or falls over an edge, s
Kinds, the first that holds:
  leaves     dies, falls over an open edge, or the object is out of reach of its sensors at the end
  touches    has come within 0.2 m of the object
  stands     has never been 0.3 m from its start, or rests there
  circles    has gone once round the object
  rests_near stands still in the end, nearer than at the start
  flees      farther at the end, and never nearer than half the distance at the start
  approaches nearer at the end, and within 0.5 m of its closest approach
  passes     any other path: it comes nearer and drives on)";

void add_map(CLI::App& command, MapOptions& options) {
    command.footer(words_of_map);
    command.add_option("SCENE", options.file, "a path, or the bare name of a shipped scene")->required();
    add_value(command, "--x", options.x, "PATH=A:B", "values from left to right, e.g. LL=RR=-1:1; default: LL=RR=-2:2");
    add_value(command, "--y", options.y, "PATH=A:B", "values from the bottom to the top; default: LR=RL=-2:2");
    add_value(command, "--measure", options.measure, "NAME",
              "what a cell shows: " + listed_words(insight::map_measure_table) + "; default: kind");
    command.add_option("--size", options.size, "cells along an axis, 2 to 128; default: 32");
    command.add_option("--seeds", options.seeds, "runs of each cell, 1 to 64; default: 1");
    command.add_option("--seed", options.seed, "seed of the first; default: 1");
    add_seconds(command, options.seconds, "simulated time of each run; default: 20", 1, 600);
    command.add_option("--vehicle", options.vehicle, "the vehicle that is judged, by its name; default: the first");
    add_settings(command, options.settings, "for every run");
    add_threads(command, options.threads);
    command.add_flag("--json", options.json, "print the map as one JSON object");
    add_value(command, "--csv", options.csv, "FILE", "write a row per cell; -: to standard output");
    auto* svg = add_value(command, "--svg", options.svg, "FILE", "write a drawing with axes, legend and title");
    add_value(command, "--png", options.png, "FILE", "write the cells alone as a picture");
    add_labels(command, options.labels, svg);
    add_table(command, options.table, " and of the words in the drawing");
}

void add_robustness(CLI::App& command, RobustnessOptions& options) {
    command.add_option("FILE", options.file, "a scene or an exercise, by path or bare name")->required();
    command.add_option("--robots", options.robots, "number of robots, 1 to 1000; default: 40");
    command.add_option(
        "--reality", options.reality,
        "factor on mismatch, gain spread, noise, latency, dead band and friction spread, 0 to 2; default: 1");
    command.add_option("--seed", options.seed,
                       "seed of the start and of the first robot; default: 1, or that of the exercise");
    add_seconds(command, options.seconds, "simulated time of each run; default: 20, or that of the exercise", 1, 600);
    command.add_option("--vehicle", options.vehicle, "the robot, by its name; default: the first vehicle");
    add_value(command, "--brain", options.brain, "FILE", "of an exercise: this brain; default: its solution");
    add_settings(command, options.settings, "for every run");
    add_threads(command, options.threads);
    add_table(command, options.table);
    command.add_flag("--json", options.json, "print the robots as one JSON object");
    add_value(command, "--csv", options.csv, "FILE", "write a row per robot; -: to standard output");
}

void add_picture(CLI::App& command, PictureOptions& options) {
    command.add_option("SCENE", options.file, brain_file_help)->required();
    add_value(command, "--wiring", options.wiring, "FILE", "write the wiring diagram of a brain");
    add_value(command, "--paths", options.paths, "FILE", "run the scene and write the paths of its vehicles");
    add_choice(command, options.choice);
    add_seconds(command, options.seconds, "simulated time of the paths; default: 20", 0.1, 600);
    command.add_option("--seed", options.seed, "seed of the run; default: 1");
    add_settings(command, options.settings, "for the paths");
    add_value(command, "--lang", options.language, "CODE", "language of the words; default: en");
}

void add_show(CLI::App& command, std::string& file) {
    command.add_option("FILE", file, "a scene, an exercise, a brain or a saved run")->required();
}

void add_hashes(CLI::App& command, HashOptions& options) {
    add_seconds(command, options.seconds, "simulated time of each run; default: 60", 0, 1e6);
    add_value(command, "--compare", options.compared, "FILE", "print what differs from this file instead");
}

void add_export(CLI::App& command, ExportOptions& options) {
    command.add_option("BRAIN", options.file, brain_file_help)->required();
    add_choice(command, options.choice);
    add_value(command, "--to", options.target, "TARGET", "what is written: " + listed_words(robots::target_table));
    add_value(command, "--robot", options.robot, "NAME", "the robot; without it, the target's own: " + target_robots());
    add_value(command, "--out", options.folder, "FOLDER", "the folder of the files; created when missing")->required();
    command.add_flag("--force", options.force,
                     "write into a folder of other files, and replace files that were edited");
}

void add_think(CLI::App& command, ThinkOptions& options) {
    command.add_option("BRAIN", options.file, brain_file_help)->required();
    add_choice(command, options.choice);
    add_value(command, "--rate", options.rate_hz, "HZ", "calls of the brain per second; default: 60")
        ->check(CLI::Range(0.1, 10000.0));
    command.add_option("--ticks", options.ticks, "number of rows; default: 1000")->check(CLI::Range(1, 1000000));
    command.add_option("--seed", options.seed, "seed of the readings; default: 1");
    add_value(command, "--vectors", options.vectors, "FILE", "the table as CSV; -: to standard output")->required();
}

void add_compare(CLI::App& command, CompareOptions& options) {
    command.add_option("SCENE", options.file, "a path, or the bare name of a shipped scene")->required();
    const std::string holds = "a brain, or a scene or saved run with one; its sensors are used, too";
    add_value(command, "--a", options.a, "FILE", holds)->required();
    add_value(command, "--b", options.b, "FILE", holds)->required();
    command.add_option("--vehicle", options.vehicle,
                       "the vehicle that gets the brains, by its name; default: the first");
    command.add_option("--seed", options.seed, "default: 1");
    add_seconds(command, options.seconds, "simulated time of each run; default: 30", 1, 600);
    command.add_flag("--json", options.json, "print one JSON object");
}

void add_mystery(CLI::App& command, MysteryOptions& options) {
    command.add_option("SCENE", options.file, "a path, or the bare name of a shipped scene")->required();
    add_value(command, "--brain", options.brain, "FILE", "a brain, or a scene or saved run with one")->required();
    command.add_option("--seed", options.seed, "of the starts and the random brains; default: 1");
    command.add_option("--starts", options.starts, "default: 10")->check(CLI::Range(1, 1000));
    add_threads(command, options.threads);
    command.add_flag("--json", options.json, "print one JSON object");
}

void add_link(CLI::App& command, LinkOptions& options) {
    command
        .add_option("SCENE", options.what, "a scene, the bare name of a shipped scene or exercise, or a link in quotes")
        ->required();
    add_value(command, "--base", options.base, "ADDRESS", "the address of the lab on the web, put before the link");
    add_value(command, "--out", options.out, "FILE", "the file of the scene of a link; without it, standard output");
}

void add_study(CLI::App& command, StudyOptions& options) {
    command.add_option("STUDY", options.file, "a path, or the bare name of a shipped study")->required();
    add_value(command, "--csv", options.csv, "FILE",
              "write a row per run; -: to standard output; after an interruption the same command continues");
    auto* svg = add_value(command, "--svg", options.svg, "FILE",
                          "write a drawing: medians and quartiles over the value with most levels");
    add_labels(command, options.labels, svg);
    add_table(command, options.table, " and of the words in the drawing");
    command.add_flag("--json", options.json, "print medians, quartiles and paired differences as JSON");
    add_threads(command, options.threads);
}

void add_breed(CLI::App& command, BreedOptions& options) {
    command
        .add_option("BREEDING", options.file,
                    "a path, the bare name of a shipped breeding, or the folder of its results")
        ->required();
    add_value(command, "--out", options.out, "PATH",
              "folder of the results; with --champion or --match, the file to write");
    command.add_option("--generations", options.generations, "after the first one; default: those of the file")
        ->check(CLI::Range(1, evolve::limits::generations));
    add_threads(command, options.threads);
    command.add_flag("--continue", options.goes_on, "go on with the results in the folder");
    command.add_flag("--json", options.json, "print the last generation as one JSON object");
    // What a folder is asked for: a champion, a match, a report, or the matrix or the scores, each alone.
    auto* matrix =
        command.add_option("--matrix", options.matrix,
                           "of a folder: champions of all generations against each other (master), or each against its "
                           "ancestors' opponents (ciao)");
    auto* csv =
        add_value(command, "--csv", options.csv, "FILE",
                  "of a folder: write a row per pair of the matrix, or without --matrix per number of each generation; "
                  "-: to standard output");
    auto* svg =
        add_value(command, "--svg", options.svg, "FILE",
                  "of a folder: write a drawing of the matrix, or without --matrix of the scores by generation");
    auto* report = add_value(command, "--report", options.report, "FOLDER",
                             "of a folder: write all tables and drawings into another folder, as JSON, CSV and SVG");
    add_labels(command, options.labels, nullptr);
    add_table(command, options.table, " and of the words in the drawing");
    auto* champion = command.add_option("--champion", options.champion,
                                        "of a folder: write the brain of a champion, like predator:30");
    auto* match = command.add_option("--match", options.match,
                                     "of a folder: write the scene of two champions, PREDATOR:PREY, like 30:12");
    for (CLI::Option* alone : {report, champion, match})
        for (CLI::Option* other : {matrix, csv, svg, report, champion, match})
            if (other != alone) alone->excludes(other);
}

struct Subcommand {
    const CLI::App* app;
    std::function<int()> run;
};

// Adds a subcommand with its options, with which `run` is called.
template <class Options>
Subcommand subcommand(CLI::App& app, const char* name, const char* about, void (*add)(CLI::App&, Options&),
                      int (*run)(const Options&)) {
    const auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(name, about);
    add(*command, *options);
    return {command, [=] { return run(*options); }};
}

std::vector<Subcommand> subcommands(CLI::App& app) {
    return {
        subcommand(app, "run", "run a scene, or continue a saved run, and print a report", add_run, run),
        subcommand(app, "check", "is an exercise or a lecture sound, or does a brain pass the exercise?", add_check,
                   check),
        subcommand(app, "grade", "grade a class's hand-ins or brains, one row each", add_grade, grade),
        subcommand(app, "map", "run a scene with many values of two numbers, and print a map", add_map, map),
        subcommand(app, "robustness", "run robots whose parts differ, and print how many do what the ideal robot does",
                   add_robustness, robustness),
        subcommand(app, "picture", "draw the wiring of a brain, and the paths of a run, as SVG files", add_picture,
                   picture),
        subcommand(app, "show", "print what a file contains and how the recogniser names its brains", add_show, show),
        subcommand(app, "hashes", "print the hash of every shipped scene and exercise after a run, as JSON", add_hashes,
                   print_hashes),
        subcommand(app, "export", "write a brain as a program for a robot", add_export, export_to_robot),
        subcommand(app, "think", "write sensor readings and the wheel commands that a brain computes from them",
                   add_think, think_vectors),
        subcommand(app, "compare", "run two brains from the same start, and print what differs in numbers", add_compare,
                   compare),
        subcommand(app, "mystery", "print how nearly a brain drives as the hidden one of a scene", add_mystery,
                   mystery),
        subcommand(app, "link", "print a scene as a link, or write the scene of a link", add_link, link),
        subcommand(app, "study", "run a scene for values and seeds, and print medians and quartiles", add_study, study),
        subcommand(app, "breed", "let predators and prey evolve against each other", add_breed, breed)};
}

int command_line(int argc, char** argv) {
    CLI::App app{"Braitenlab without a window."};
    app.allow_windows_style_options(false);  // "/" begins a path, on every system
    app.failure_message([](const CLI::App*, const CLI::Error& error) { return usage_fault(error.what()); });
    app.require_subcommand(1);
    app.set_version_flag("--version", fmt::format("braitenctl {}", version_text()));
    const std::vector<Subcommand> commands = subcommands(app);
    std::vector<std::string_view> names;
    for (const Subcommand& command : commands) names.push_back(command.app->get_name());
    if (argc > 1 && argv[1][0] != '-' && std::find(names.begin(), names.end(), argv[1]) == names.end())
        return complain({in_quotes(argv[1]) + " is not a command" + name_nearest(argv[1], names)});
    try {
        app.parse(argc, argv);
    } catch (const CLI::ExtrasError& error) {
        const auto given =
            std::find_if(commands.begin(), commands.end(), [](const auto& each) { return each.app->parsed(); });
        std::cerr << usage_fault(error.what() +
                                 nearest_option_of(given == commands.end() ? app : *given->app, argc, argv));
        return exit_code::bad_input;
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? exit_code::done : exit_code::bad_input;
    }
    const auto given =
        std::find_if(commands.begin(), commands.end(), [](const auto& each) { return each.app->parsed(); });
    if (const auto error = output_fault(*given->app)) return complain(*error);
    return given->run();
}

}  // namespace

}  // namespace braitenlab

int main(int argc, char** argv) {
    braitenlab::keep_freed_memory();
    braitenlab::use_utf8(argc, argv);
    braitenlab::end_at_closed_pipe();
    const braitenlab::InertOutput inert;
    return braitenlab::run_in_ranks([&] { return braitenlab::end_with(braitenlab::command_line(argc, argv)); });
}
