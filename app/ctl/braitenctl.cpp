// Braitenlab without a window. Exit codes: 0 done or passed, 1 failed, 2 bad input, 130 interrupted.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iostream>
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
#include "core/evolve/breeding_file.h"
#include "core/export/export.h"
#include "core/insight/behaviour.h"
#include "core/io/vehicle_table.h"
#include "core/scene/nearest.h"

namespace braitenlab {

int complain(const Error& error) {
    std::cerr << "braitenctl: " << error.text() << "\n";
    return exit_code::bad_input;
}

int interrupted() {
    std::cerr << "braitenctl: interrupted; no file has changed\n";
    return exit_code::interrupted;
}

std::optional<Error> ending_fault(std::string_view option, const std::string& file, std::string_view ending) {
    if (file.empty()) return std::nullopt;
    std::string own = std::filesystem::path(file).extension().string();
    std::transform(own.begin(), own.end(), own.begin(), [](unsigned char c) { return std::tolower(c); });
    if (own == ending) return std::nullopt;
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
    command.add_option("--lang", table.language, "language of --excel" + also + "; default: en")->type_name("CODE");
}

void add_labels(CLI::App& command, FigureLabels& labels) {
    command.add_option("--title", labels.title, "title of the drawing")->type_name("TEXT");
    command.add_option("--x-label", labels.x, "words at the horizontal axis, with the unit")->type_name("TEXT");
    command.add_option("--y-label", labels.y, "words at the vertical axis, with the unit")->type_name("TEXT");
}

void add_settings(CLI::App& command, std::vector<std::string>& settings, const std::string& what) {
    command.add_option("--set", settings, "one value of the scene, " + what)
        ->type_name("PATH=VALUE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_threads(CLI::App& command, int& threads) {
    command.add_option("--threads", threads, "threads; without it, one per processor")->check(CLI::Range(1, 256));
}

CLI::App* add_robustness(CLI::App& app, RobustnessOptions& tried) {
    CLI::App* command = app.add_subcommand(
        "robustness", "run robots whose parts differ, and print how many do what the ideal robot does");
    command->add_option("FILE", tried.file, "a scene or an exercise, by path or bare name")->required();
    command->add_option("--robots", tried.robots, "number of robots, 1 to 1000; default: 40");
    command->add_option(
        "--reality", tried.reality,
        "factor on mismatch, gain spread, noise, latency, dead band and friction spread, 0 to 2; default: 1");
    command->add_option("--seed", tried.seed,
                        "seed of the start and of the first robot; default: 1, or "
                        "that of the exercise");
    command
        ->add_option("--seconds", tried.seconds,
                     "simulated time of each run; default: 20, or that of "
                     "the exercise")
        ->check(CLI::Range(1.0, 600.0));
    command->add_option("--vehicle", tried.vehicle, "the robot, by its name; default: the first vehicle");
    command->add_option("--brain", tried.brain, "of an exercise: this brain; default: its solution")->type_name("FILE");
    add_settings(*command, tried.settings, "for every run");
    add_threads(*command, tried.threads);
    add_table(*command, tried.table);
    command->add_flag("--json", tried.json, "print the robots as one JSON object");
    command->add_option("--csv", tried.csv, "write a row per robot; -: to standard output")->type_name("FILE");
    return command;
}

CLI::App* add_picture(CLI::App& app, PictureOptions& options) {
    CLI::App* command =
        app.add_subcommand("picture", "draw the wiring of a brain, and the paths of a run, as SVG files");
    command->add_option("SCENE", options.file, brain_file_help)->required();
    command->add_option("--wiring", options.wiring, "write the wiring diagram of a brain")->type_name("FILE");
    command->add_option("--paths", options.paths, "run the scene and write the paths of its vehicles")
        ->type_name("FILE");
    add_choice(*command, options.choice);
    command->add_option("--seconds", options.seconds, "simulated time of the paths; default: 20")
        ->check(CLI::Range(0.1, 600.0));
    command->add_option("--seed", options.seed, "seed of the run; default: 1");
    add_settings(*command, options.settings, "for the paths");
    command->add_option("--lang", options.language, "language of the words; default: en")->type_name("CODE");
    return command;
}

CLI::App* add_export(CLI::App& app, ExportOptions& options) {
    CLI::App* command = app.add_subcommand("export", "write a brain as a program for a robot");
    command->add_option("BRAIN", options.file, brain_file_help)->required();
    add_choice(*command, options.choice);
    command->add_option("--to", options.target, "what is written: " + listed_words(robots::target_table))
        ->type_name("TARGET");
    command->add_option("--robot", options.robot, "the robot; without it, the target's own: " + target_robots())
        ->type_name("NAME");
    command->add_option("--out", options.folder, "the folder of the files; created when missing")
        ->type_name("FOLDER")
        ->required();
    command->add_flag("--force", options.force, "write into a folder that holds other files, and replace them");
    return command;
}

CLI::App* add_think(CLI::App& app, ThinkOptions& options) {
    CLI::App* command =
        app.add_subcommand("think", "write sensor readings and the wheel commands that a brain computes from them");
    command->add_option("BRAIN", options.file, brain_file_help)->required();
    add_choice(*command, options.choice);
    command->add_option("--rate", options.rate_hz, "calls of the brain per second; default: 60")
        ->type_name("HZ")
        ->check(CLI::Range(0.1, 10000.0));
    command->add_option("--ticks", options.ticks, "number of rows; default: 1000")->check(CLI::Range(1, 1000000));
    command->add_option("--seed", options.seed, "seed of the readings; default: 1");
    command->add_option("--vectors", options.vectors, "the table as CSV; -: to standard output")
        ->type_name("FILE")
        ->required();
    return command;
}

CLI::App* add_study(CLI::App& app, StudyOptions& options) {
    CLI::App* command =
        app.add_subcommand("study", "run a scene for values and seeds, and print medians and quartiles");
    command->add_option("STUDY", options.file, "a path, or the bare name of a shipped study")->required();
    command
        ->add_option("--csv", options.csv,
                     "write a row per run; -: to standard output; after an interruption the same command continues")
        ->type_name("FILE");
    command->add_option("--svg", options.svg, "write a drawing: medians and quartiles over the value with most levels")
        ->type_name("FILE");
    add_labels(*command, options.labels);
    add_table(*command, options.table, " and of the words in the drawing");
    command->add_flag("--json", options.json, "print medians, quartiles and paired differences as JSON");
    add_threads(*command, options.threads);
    return command;
}

CLI::App* add_breed(CLI::App& app, BreedOptions& options) {
    CLI::App* command = app.add_subcommand("breed", "let predators and prey evolve against each other");
    command
        ->add_option("BREEDING", options.file,
                     "a path, the bare name of a shipped breeding, or the folder of its results")
        ->required();
    command->add_option("--out", options.out, "folder of the results; with --champion or --match, the file to write")
        ->type_name("PATH");
    command->add_option("--generations", options.generations, "after the first one; default: those of the file")
        ->check(CLI::Range(1, evolve::limits::generations));
    add_threads(*command, options.threads);
    command->add_flag("--continue", options.goes_on, "go on with the results in the folder");
    command->add_flag("--json", options.json, "print the last generation as one JSON object");
    command->add_option("--matrix", options.matrix,
                        "of a folder: champions of all generations against each other (master), or each against its "
                        "ancestors' opponents (ciao)");
    command
        ->add_option(
            "--csv", options.csv,
            "of a folder: write a row per pair of the matrix, or without --matrix per number of each generation; "
            "-: to standard output")
        ->type_name("FILE");
    command
        ->add_option("--svg", options.svg,
                     "of a folder: write a drawing of the matrix, or without --matrix of the scores by generation")
        ->type_name("FILE");
    command
        ->add_option("--report", options.report,
                     "of a folder: write all tables and drawings into another folder, as JSON, CSV and SVG")
        ->type_name("FOLDER");
    add_labels(*command, options.labels);
    add_table(*command, options.table, " and of the words in the drawing");
    command->add_option("--champion", options.champion, "of a folder: write the brain of a champion, like predator:30");
    command->add_option("--match", options.match,
                        "of a folder: write the scene of two champions, PREDATOR:PREY, like 30:12");
    return command;
}

CLI::App* add_compare(CLI::App& app, CompareOptions& options) {
    CLI::App* command =
        app.add_subcommand("compare", "run two brains from the same start, and print what differs in numbers");
    command->add_option("SCENE", options.file, "a path, or the bare name of a shipped scene")->required();
    const std::string holds = "a brain, or a scene or saved run with one; its sensors are used, too";
    command->add_option("--a", options.a, holds)->type_name("FILE")->required();
    command->add_option("--b", options.b, holds)->type_name("FILE")->required();
    command->add_option("--vehicle", options.vehicle,
                        "the vehicle that gets the brains, by its name; default: the first");
    command->add_option("--seed", options.seed, "default: 1");
    command->add_option("--seconds", options.seconds, "simulated time of each run; default: 30")
        ->check(CLI::Range(1.0, 600.0));
    command->add_flag("--json", options.json, "print one JSON object");
    return command;
}

CLI::App* add_mystery(CLI::App& app, MysteryOptions& options) {
    CLI::App* command = app.add_subcommand("mystery", "print how nearly a brain drives as the hidden one of a scene");
    command->add_option("SCENE", options.file, "a path, or the bare name of a shipped scene")->required();
    command->add_option("--brain", options.brain, "a brain, or a scene or saved run with one")
        ->type_name("FILE")
        ->required();
    command->add_option("--seed", options.seed, "of the starts and the random brains; default: 1");
    command->add_option("--starts", options.starts, "default: 10")->check(CLI::Range(1, 1000));
    add_threads(*command, options.threads);
    command->add_flag("--json", options.json, "print one JSON object");
    return command;
}

CLI::App* add_link(CLI::App& app, LinkOptions& options) {
    CLI::App* command = app.add_subcommand("link", "print a scene as a link, or write the scene of a link");
    command
        ->add_option("SCENE", options.what,
                     "a scene, the bare name of a shipped scene or exercise, or a link in quotes")
        ->required();
    command->add_option("--base", options.base, "the address of the lab on the web, put before the link")
        ->type_name("ADDRESS");
    command->add_option("--out", options.out, "the file of the scene of a link; without it, standard output")
        ->type_name("FILE");
    return command;
}

void add_marks(CLI::App& command, ClassOptions& options) {
    command
        .add_option("--gradebook", options.platform,
                    "write the marks as this platform imports them: " + listed_words(platform_table))
        ->type_name("PLATFORM");
    command.add_option("--marks", options.marks, "the file of the marks; -: to standard output")->type_name("FILE");
    command.add_option("--list", options.list, "the list of students that the platform has exported, as CSV")
        ->type_name("FILE");
    command
        .add_option("--column", options.column,
                    "heading of the column of the marks; default: the platform's, in canvas the exercise's title")
        ->type_name("NAME");
    command
        .add_option("--points", options.points,
                    "the mark where all starts pass; default: that of the list, or the starts")
        ->check(CLI::Range(0.01, 10000.0));
}

int command_line(int argc, char** argv) {
    CLI::App app{"Braitenlab without a window."};
    app.allow_windows_style_options(false);  // "/" begins a path, on every system
    app.require_subcommand(1);
    app.set_version_flag("--version", fmt::format("braitenctl {}", version_text()));

    RunOptions options;
    CLI::App* run_command = app.add_subcommand("run", "run a scene, or continue a saved run, and print a report");
    run_command->add_option("SCENE", options.file, "a path, the bare name of a shipped scene, or a saved run (….run)")
        ->required();
    run_command->add_option("--seconds", options.seconds, "simulated time; for a saved run: additional time")
        ->check(CLI::Range(0.0, 1e6));
    run_command
        ->add_option("--seed", options.seed,
                     "seed of the random numbers, 1 without it; the same seed gives the same run; A:B: a run per seed")
        ->type_name("SEED");
    add_settings(*run_command, options.settings, "e.g. kind.prey.brain.LL=0.5; A:B:STEP or V1,V2,…: a run per value");
    run_command->add_flag("--json", options.json, "print the final state as one JSON object");
    run_command->add_option("--csv", options.csv, "write a row per vehicle per 0.1 s; -: to standard output")
        ->type_name("FILE");
    run_command
        ->add_option("--columns", options.columns,
                     "further columns of the CSV file: " + listed_words(io::column_group_table))
        ->type_name("WORD,…")
        ->delimiter(',')
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    add_table(*run_command, options.table);
    run_command->add_option("--threads", options.threads, "threads for several runs; without it, one per processor")
        ->check(CLI::Range(1, 256));
    run_command->add_flag("--hash", options.hash, "print the hash of the final state");
    run_command->add_option("--save", options.save, "write the run at its end, to continue it later")
        ->type_name("FILE.run");

    CheckOptions checked;
    bool all = false;
    CLI::App* check_command =
        app.add_subcommand("check", "is an exercise or a lecture sound, or does a brain pass the exercise?");
    auto* name = check_command->add_option("EXERCISE", checked.exercise,
                                           "a path, or the bare name of a shipped exercise or lecture");
    check_command
        ->add_option(
            "--brain", checked.brain,
            "a brain, a scene or a saved run; without it, the brain as shipped and the exercise's own solution")
        ->type_name("FILE");
    add_choice(*check_command, checked.choice);
    check_command->add_option("--seed", checked.seed, "seed of the first start; default: 1");
    check_command->add_flag("--json", checked.json, "print each start with its steps as JSON");
    auto* all_flag =
        check_command->add_flag("--all", all, "every shipped exercise: fails as shipped, passes with its solution");
    name->excludes(all_flag);

    ClassOptions graded;
    CLI::App* grade_command = app.add_subcommand("grade", "grade a class's hand-ins or brains, one row each");
    grade_command->add_option("EXERCISE", graded.exercise, "a path, or the bare name of a shipped exercise")
        ->required();
    grade_command
        ->add_option("FILE", graded.files,
                     "a folder or a ZIP archive of hand-in files; or hand-ins, brains, scenes or saved runs")
        ->required();
    add_choice(*grade_command, graded.choice);
    grade_command->add_option("--csv", graded.csv, "write the rows there instead of printing them")->type_name("FILE");
    grade_command->add_option("--html", graded.html, "write a page with summary, paths and feedback")
        ->type_name("FILE");
    add_table(*grade_command, graded.table, ", the feedback and the page");
    add_marks(*grade_command, graded);
    grade_command->add_option("--seed", graded.first_seed, "seed of the first start; default: 1");

    MapOptions mapped;
    CLI::App* map_command = app.add_subcommand("map", "run a scene with many values of two numbers, and print a map");
    map_command->add_option("SCENE", mapped.file, "a path, or the bare name of a shipped scene")->required();
    map_command->add_option("--x", mapped.x, "values from left to right, e.g. LL=RR=-1:1; default: LL=RR=-2:2")
        ->type_name("PATH=A:B");
    map_command->add_option("--y", mapped.y, "values from the bottom to the top; default: LR=RL=-2:2")
        ->type_name("PATH=A:B");
    map_command
        ->add_option("--measure", mapped.measure,
                     "what a cell shows: " + listed_words(insight::map_measure_table) + "; default: kind")
        ->type_name("NAME");
    map_command->add_option("--size", mapped.size, "cells along an axis, 2 to 128; default: 32");
    map_command->add_option("--seeds", mapped.seeds, "runs of each cell, 1 to 64; default: 1");
    map_command->add_option("--seed", mapped.seed, "seed of the first; default: 1");
    map_command->add_option("--seconds", mapped.seconds, "simulated time of each run; default: 20")
        ->check(CLI::Range(1.0, 600.0));
    map_command->add_option("--vehicle", mapped.vehicle, "the vehicle that is judged, by its name; default: the first");
    add_settings(*map_command, mapped.settings, "for every run");
    add_threads(*map_command, mapped.threads);
    map_command->add_flag("--json", mapped.json, "print the map as one JSON object");
    map_command->add_option("--csv", mapped.csv, "write a row per cell; -: to standard output")->type_name("FILE");
    map_command->add_option("--svg", mapped.svg, "write a drawing with axes, legend and title")->type_name("FILE");
    map_command->add_option("--png", mapped.png, "write the cells alone as a picture")->type_name("FILE");
    add_labels(*map_command, mapped.labels);
    add_table(*map_command, mapped.table, " and of the words in the drawing");

    RobustnessOptions tried;
    CLI::App* robustness_command = add_robustness(app, tried);
    PictureOptions drawn;
    CLI::App* picture_command = add_picture(app, drawn);

    std::string shown;
    CLI::App* show_command =
        app.add_subcommand("show", "print what a file contains and how the recogniser names its brains");
    show_command->add_option("FILE", shown, "a scene, an exercise, a brain or a saved run")->required();

    HashOptions hashed;
    CLI::App* hashes_command =
        app.add_subcommand("hashes", "print the hash of every shipped scene and exercise after a run, as JSON");
    hashes_command->add_option("--seconds", hashed.seconds, "simulated time of each run; default: 60")
        ->check(CLI::Range(0.0, 1e6));
    hashes_command->add_option("--compare", hashed.compared, "print what differs from this file instead")
        ->type_name("FILE");

    ExportOptions exported;
    CLI::App* export_command = add_export(app, exported);
    ThinkOptions thought;
    CLI::App* think_command = add_think(app, thought);

    CompareOptions compared;
    CLI::App* compare_command = add_compare(app, compared);

    MysteryOptions rebuilt;
    CLI::App* mystery_command = add_mystery(app, rebuilt);

    LinkOptions linked;
    CLI::App* link_command = add_link(app, linked);

    StudyOptions studied;
    CLI::App* study_command = add_study(app, studied);

    BreedOptions bred;
    CLI::App* breed_command = add_breed(app, bred);

    std::vector<std::string_view> commands;
    for (const CLI::App* command : {run_command, map_command, robustness_command, picture_command, check_command,
                                    grade_command, show_command, hashes_command, export_command, think_command,
                                    study_command, link_command, compare_command, mystery_command, breed_command})
        commands.push_back(command->get_name());
    if (argc > 1 && argv[1][0] != '-' && std::find(commands.begin(), commands.end(), argv[1]) == commands.end())
        return complain({in_quotes(argv[1]) + " is not a command" + name_nearest(argv[1], commands)});
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? exit_code::done : exit_code::bad_input;
    }
    for (const CLI::App* command : app.get_subcommands())
        if (const auto error = output_over_input(*command)) return complain(*error);
    if (*run_command) return run(options);
    if (*map_command) return map(mapped);
    if (*robustness_command) return robustness(tried);
    if (*picture_command) return picture(drawn);
    if (*grade_command && (!graded.html.empty() || !graded.platform.empty() || is_class(graded.files)))
        return grade_class(graded);
    if (*grade_command) return grade_all(graded);
    if (*show_command) return show(shown);
    if (*hashes_command) return print_hashes(hashed);
    if (*export_command) return export_to_robot(exported);
    if (*study_command) return study(studied);
    if (*breed_command) return breed(bred);
    if (*think_command) return think_vectors(thought);
    if (*link_command) return link(linked);
    if (*compare_command) return compare(compared);
    if (*mystery_command) return mystery(rebuilt);
    if (all) return check_all(checked.seed, checked.json);
    if (checked.exercise.empty()) return complain({"check needs an EXERCISE or --all"});
    return check(checked);
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
