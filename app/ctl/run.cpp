// braitenctl run: runs a scene or a saved run for a number of seconds, or every run of a sweep.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iostream>
#include <memory>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "app/ctl/ctl.h"
#include "app/ctl/report.h"
#include "app/ctl/sweep.h"
#include "app/ctl/table_file.h"
#include "app/files/data.h"
#include "app/files/safe_file.h"
#include "app/jobs/jobs.h"
#include "app/platform/platform.h"
#include "core/io/run_file.h"
#include "core/io/vehicle_table.h"
#include "core/scene/scene_file.h"
#include "core/world/world.h"

namespace braitenlab {

namespace {

std::optional<Error> check_options(const RunOptions& options, const Sweep& sweep) {
    if (options.file.ends_with(io::run_ending) && !(options.seed.empty() && options.settings.empty()))
        return Error{"a saved run has its own seed and values; leave out --seed and --set, or run its scene",
                     options.file};
    if (options.csv.empty() && !options.columns.empty())
        return Error{"needs --csv FILE, which has these columns", "--columns"};
    if (options.csv == standard_output && (options.json || options.hash))
        return Error{"leaves no room for --json and --hash on standard output; leave them out, or give --csv a file",
                     "--csv -"};
    if (auto error = ending_fault("--save", options.save, io::run_ending)) return error;
    if (!sweep.is_sweep) return std::nullopt;
    const std::string given = "--set and --seed";
    if (options.csv.empty())
        return Error{fmt::format("these are {} runs; add --csv FILE for their table, and put text with a comma or a "
                                 "colon in quotes",
                                 sweep.runs()),
                     given};
    if (options.json || options.hash || !options.save.empty())
        return Error{"several runs have no single final state; leave out --json, --hash and --save", given};
    return std::nullopt;
}

Result<std::set<io::ColumnGroup>> column_groups(const std::vector<std::string>& words) {
    std::set<io::ColumnGroup> groups;
    for (const std::string& given : words) {
        const auto group = named_in(io::column_group_table, given, "there are no columns", "--columns");
        if (!group) return group.error();
        groups.insert(*group);
    }
    return groups;
}

// Runs the world for this time (s). Passes the snapshot at its start and at each whole 0.1 s of the run to `add_rows`,
// unless that is empty. Returns false, before the end, when the user has interrupted the program.
bool simulate(World& world, double seconds, const std::function<void(const Snapshot&)>& add_rows = {}) {
    constexpr std::uint64_t ticks_per_row = 6;  // 0.1 s
    const auto end = world.tick() + static_cast<std::uint64_t>(std::llround(seconds * 60));
    Snapshot now;
    if (add_rows) world.capture(now), add_rows(now);
    while (world.tick() < end) {
        if (is_told_to_end()) return false;
        world.step();
        if (!add_rows || world.tick() % ticks_per_row != 0) continue;
        world.capture(now);
        add_rows(now);
    }
    return true;
}

// A line per vehicle. Each begins with `first_cells`, which is empty or ends with a comma.
std::string table_rows(const std::vector<io::VehicleColumn>& columns, const Snapshot& now,
                       std::string_view first_cells = "") {
    std::string rows;
    for (const VehicleView& vehicle : now.vehicles) {
        rows += first_cells;
        io::add_csv_row(rows, columns, io::VehicleRow{now, vehicle});
    }
    return rows;
}

struct StartedRun {
    Scene opened;
    World world;
};

Result<StartedRun> continue_run(const RunOptions& options) {
    auto saved = io::load_run(options.file);
    if (!saved) return saved.error();
    World world = World::restore(saved->checkpoint);
    return StartedRun{std::move(saved->opened), std::move(world)};
}

Result<StartedRun> start(const RunOptions& options, const Sweep& single) {
    if (options.file.ends_with(io::run_ending)) return continue_run(options);
    const auto path = find_shipped(options.file);
    if (!path) return path.error();
    const auto text = read_scene_text(*path, "run", "a scene or a saved run");
    if (!text) return text.error();
    auto scene = parse_scene(*text, path->string(), combination(single, 0));
    if (!scene) return scene.error();
    auto world = World::create(*scene, single.first_seed);
    if (!world) return world.error();
    return StartedRun{std::move(*scene), std::move(*world)};
}

// Prints the final state, unless standard output has the table.
void print_state(const RunOptions& options, const Snapshot& now, std::uint64_t hash) {
    if (options.csv == standard_output) return;
    if (options.json) std::cout << report_json(now, hash);
    if (options.hash) std::cout << hash_text(hash) << "\n";
    if (!options.json && !options.hash) std::cout << report_text(now, hash);
}

int run_one(const RunOptions& options, const Sweep& single, const std::set<io::ColumnGroup>& groups,
            const io::CsvStyle& style) {
    auto started = start(options, single);
    if (!started) return complain(started.error());
    World& world = started->world;
    Snapshot now;
    world.capture(now);
    if (options.csv.empty()) {
        if (!simulate(world, options.seconds)) return interrupted();
    } else {
        const std::vector<io::VehicleColumn> columns = io::vehicle_columns(now, groups);
        TableFile table(options.csv, style);
        table.write(io::csv_header(columns));
        if (!simulate(world, options.seconds, [&](const Snapshot& at) { table.write(table_rows(columns, at)); }))
            return interrupted();
        if (const auto error = table.close()) return complain(*error);
    }
    if (!options.save.empty())
        if (const auto error = write_whole(options.save, io::write_run({started->opened, world.checkpoint()})))
            return complain(*error);
    world.capture(now);
    print_state(options, now, world.hash());
    return exit_code::done;
}

// What every run shares; constant while runs are computed on several threads.
struct SweepInput {
    Sweep sweep;
    std::string scene_text, scene_file;
    double seconds = 0;
    std::vector<io::VehicleColumn> columns;
};

Result<World> world_of(const SweepInput& input, std::size_t run) {
    const auto scene =
        parse_scene(input.scene_text, input.scene_file, combination(input.sweep, run / input.sweep.seeds));
    if (!scene) return scene.error();
    return World::create(*scene, input.sweep.first_seed + run % input.sweep.seeds);
}

// The cells before those of a vehicle: run, seed, values.
std::string first_cells(const Sweep& sweep, std::size_t run) {
    std::string cells = fmt::format("{},{},", run + 1, sweep.first_seed + run % sweep.seeds);
    for (const std::string& value : cells_of(sweep, run / sweep.seeds)) {
        io::add_csv_cell(cells, std::string_view(value));
        cells += ',';
    }
    return cells;
}

std::string header(const SweepInput& input) {
    std::string line = "run,seed,";
    for (const SweptValue& value : input.sweep.values) {
        io::add_csv_cell(line, std::string_view(value.name()));
        line += ',';
    }
    return line + io::csv_header(input.columns);
}

// The rows of one run; incomplete when the user has interrupted the program.
Result<std::string> rows_of_run(const SweepInput& input, std::size_t run) {
    auto world = world_of(input, run);
    if (!world) return world.error();
    const std::string first = first_cells(input.sweep, run);
    std::string rows;
    simulate(*world, input.seconds, [&](const Snapshot& now) { rows += table_rows(input.columns, now, first); });
    return rows;
}

Result<SweepInput> prepare(const RunOptions& options, const Sweep& sweep, const std::set<io::ColumnGroup>& groups) {
    const auto path = find_shipped(options.file);
    if (!path) return path.error();
    auto text = read_scene_text(*path, "run", "a scene or a saved run");
    if (!text) return text.error();
    SweepInput input{sweep, std::move(*text), path->string(), options.seconds, {}};
    for (std::size_t i = 1; i < sweep.combinations(); ++i)
        if (const auto scene = parse_scene(input.scene_text, input.scene_file, combination(sweep, i)); !scene)
            return scene.error();
    const auto world = world_of(input, 0);
    if (!world) return world.error();
    const Snapshot start = snapshot_of(*world);
    input.columns = io::vehicle_columns(start, groups);
    return input;
}

// Runs every combination of a sweep and writes one table with the columns run, seed, one per --set argument, and those
// of a vehicle table. Runs are numbered from 1; the seed varies fastest, then the last --set argument. The table does
// not depend on RunOptions::threads. Every combination of values is checked before the first run. Returns the exit
// code.
int run_sweep(const RunOptions& options, const Sweep& sweep, const std::set<io::ColumnGroup>& groups,
              const io::CsvStyle& style) {
    auto prepared = prepare(options, sweep, groups);
    if (!prepared) return complain(prepared.error());
    const auto input = std::make_shared<const SweepInput>(std::move(*prepared));
    TableFile table(options.csv, style);
    table.write(header(*input));
    Jobs jobs(threads_for(options.threads));
    // The rows of one batch are in memory at a time.
    const std::size_t batch = 4 * static_cast<std::size_t>(std::max(1, jobs.threads()));
    for (std::size_t first = 0; first < sweep.runs(); first += batch) {
        auto job = jobs.submit(std::min(batch, sweep.runs() - first),
                               [input, first](std::size_t part) { return rows_of_run(*input, first + part); });
        jobs.finish();
        if (is_told_to_end()) return interrupted();
        const auto results = job.take();
        if (!*results) return complain(results->error());
        for (const Result<std::string>& rows : **results) {
            if (!rows) return complain(rows.error());
            table.write(*rows);
        }
    }
    if (const auto error = table.close()) return complain(*error);
    return exit_code::done;
}

}  // namespace

int run(const RunOptions& options) {
    const auto sweep = parse_sweep(options.settings, options.seed);
    if (!sweep) return complain(sweep.error());
    if (const auto error = check_options(options, *sweep)) return complain(*error);
    const auto groups = column_groups(options.columns);
    if (!groups) return complain(groups.error());
    const auto style = style_of(options.table);
    if (!style) return complain(style.error());
    return sweep->is_sweep ? run_sweep(options, *sweep, *groups, *style) : run_one(options, *sweep, *groups, *style);
}
}  // namespace braitenlab
