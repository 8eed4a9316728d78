// Braitenlab without a window: run a scene, judge an exercise. Exit codes: 0 done or passed, 1 failed, 2 bad input.
#include <cmath>
#include <fstream>
#include <iostream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/data.h"
#include "app/report.h"
#include "core/lesson/exercise.h"
#include "core/lesson/referee.h"
#include "core/scene/scene_file.h"
#include "core/world/world.h"

namespace braitenlab {

namespace {

constexpr int done = 0, failed = 1, bad_input = 2;

int complain(const Error& error) {
    std::cerr << "braitenctl: " << error.text() << "\n";
    return bad_input;
}

struct RunOptions {
    std::string scene;
    double seconds = 10;
    std::uint64_t seed = 1;
    std::vector<std::string> settings;
    std::string csv;
    bool json = false, hash = false;
};

Result<Scene> load_for_run(const RunOptions& options) {
    std::vector<Setting> settings;
    for (const std::string& text : options.settings) {
        auto setting = parse_setting(text);
        if (!setting) return setting.error();
        settings.push_back(*setting);
    }
    const auto path = find_shipped(options.scene);
    if (!path) return path.error();
    return load_scene(*path, settings);
}

// Rows of a moment go to a file that is checked once, at the end: a full disk shows there at the latest.
struct CsvFile {
    explicit CsvFile(const std::string& path) : name(path) {
        if (name.empty()) return;
        file.open(name);
        write_csv_header(file);
    }
    void add(const Snapshot& now) {
        if (!name.empty()) write_csv_rows(file, now);
    }
    std::optional<Error> close() {
        if (name.empty()) return std::nullopt;
        file.close();
        if (file) return std::nullopt;
        return Error{"could not be written; check that the folder exists, may be written to and has room", name};
    }
    std::string name;
    std::ofstream file;
};

int run(const RunOptions& options) {
    constexpr std::uint64_t ticks_a_row = 6;  // one row per vehicle per 0.1 s
    const auto scene = load_for_run(options);
    if (!scene) return complain(scene.error());
    auto world = World::create(*scene, options.seed);
    if (!world) return complain(world.error());

    CsvFile csv(options.csv);
    Snapshot now;
    world->capture(now);
    csv.add(now);
    const auto ticks = static_cast<std::uint64_t>(std::llround(options.seconds * 60));
    while (world->tick() < ticks) {
        world->step();
        if (options.csv.empty() || world->tick() % ticks_a_row != 0) continue;
        world->capture(now);
        csv.add(now);
    }
    if (const auto error = csv.close()) return complain(*error);

    world->capture(now);
    if (options.json) std::cout << report_json(now, world->hash());
    if (options.hash) std::cout << hash_text(world->hash()) << "\n";
    if (!options.json && !options.hash) std::cout << report_text(now, world->hash());
    return done;
}

void print_grade(const Exercise& exercise, const Grade& grade) {
    std::cout << fmt::format("{}: {} of {} starts pass, {} needed: {}\n", exercise.id, grade.count, grade.passed.size(),
                             exercise.needed, grade.good ? "passed" : "not passed");
    for (std::size_t i = 0; i < grade.passed.size(); ++i)
        if (!grade.passed[i]) std::cout << fmt::format("  start {} fails\n", i + 1);
}

const BrainGraph& pupil_brain(const Exercise& exercise) {
    return exercise.scene.kinds[static_cast<std::size_t>(pupil_kind(exercise.scene))].brain;
}

int check_one(const std::string& name, const std::string& brain_file) {
    const auto path = find_shipped(name);
    if (!path) return complain(path.error());
    const auto exercise = load_exercise(*path);
    if (!exercise) return complain(exercise.error());
    BrainGraph brain = pupil_brain(*exercise);
    if (!brain_file.empty()) {
        auto own = load_brain(brain_file);
        if (!own) return complain(own.error());
        brain = *own;
    }
    const Grade result = grade(*exercise, brain);
    print_grade(*exercise, result);
    return result.good ? done : failed;
}

// Every shipped exercise must fail as shipped and pass with its solution, from every start.
int check_all() {
    int wrong = 0;
    for (const auto& path : shipped_exercises()) {
        const auto exercise = load_exercise(path);
        if (!exercise) return complain(exercise.error());
        const Grade shipped = grade(*exercise, pupil_brain(*exercise));
        const Grade solved = grade(*exercise, make_graph(exercise->solution));
        const bool good = shipped.count == 0 && solved.count == exercise->starts;
        std::cout << fmt::format(
            "{}: as shipped {} of {} starts pass (none should), with its solution {} (all should): {}\n", exercise->id,
            shipped.count, exercise->starts, solved.count, good ? "good" : "wrong");
        wrong += !good;
    }
    return wrong == 0 ? done : failed;
}

int command_line(int argc, char** argv) {
    CLI::App app{"Braitenlab without a window."};
    app.require_subcommand(1);
    app.set_version_flag("--version", fmt::format("braitenctl {}", version_text()));

    RunOptions options;
    CLI::App* run_command = app.add_subcommand("run", "run a scene and report");
    run_command->add_option("SCENE", options.scene, "a path, or the bare name of a shipped scene")->required();
    run_command->add_option("--seconds", options.seconds, "simulated")->check(CLI::Range(0.0, 1e6));
    run_command->add_option("--seed", options.seed, "where chance begins; the same seed gives the same run")
        ->check(CLI::NonNegativeNumber);
    run_command->add_option("--set", options.settings, "one value of the scene, e.g. kind.prey.brain.LL=0.5")
        ->type_name("PATH=VALUE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    run_command->add_flag("--json", options.json, "print the end as one JSON object");
    run_command->add_option("--csv", options.csv, "write a row per vehicle per 0.1 s")->type_name("FILE");
    run_command->add_flag("--hash", options.hash, "print the digest of the end's state");

    std::string exercise, brain;
    bool all = false;
    CLI::App* check_command = app.add_subcommand("check", "does a brain pass an exercise?");
    auto* name = check_command->add_option("EXERCISE", exercise, "a path, or the bare name of a shipped exercise");
    check_command->add_option("--brain", brain, "a brain file; without it, the brain as shipped")->type_name("FILE");
    auto* all_flag =
        check_command->add_flag("--all", all, "every shipped exercise: fails as shipped, passes with its solution");
    name->excludes(all_flag);

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? done : bad_input;
    }
    if (*run_command) return run(options);
    if (all) return check_all();
    if (exercise.empty()) return complain({"check needs an EXERCISE or --all"});
    return check_one(exercise, brain);
}

}  // namespace

}  // namespace braitenlab

int main(int argc, char** argv) { return braitenlab::command_line(argc, argv); }
