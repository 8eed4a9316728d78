// braitenctl run: runs a scene or a saved run for a number of seconds.
#include <algorithm>
#include <iostream>
#include <set>

#include <fmt/format.h>

#include "app/ctl/ctl.h"
#include "app/ctl/report.h"
#include "app/ctl/run_sweep.h"
#include "app/ctl/simulate.h"
#include "app/ctl/table_file.h"
#include "app/files/data.h"
#include "app/files/safe_file.h"
#include "core/io/run_file.h"
#include "core/scene/nearest.h"
#include "core/scene/scene_file.h"
#include "core/world/world.h"

namespace braitenlab {

namespace {

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
    auto scene = load_scene(*path, combination(single, 0));
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

std::optional<Error> check_options(const RunOptions& options, const Sweep& sweep) {
    if (options.file.ends_with(io::run_ending) && !(options.seed.empty() && options.settings.empty()))
        return Error{"a saved run has its own seed and values; leave out --seed and --set, or run its scene",
                     options.file};
    if (options.csv.empty() && !options.columns.empty())
        return Error{"needs --csv FILE, which has these columns", "--columns"};
    if (options.csv == standard_output && (options.json || options.hash))
        return Error{"leaves no room for --json and --hash on standard output; leave them out, or give --csv a file",
                     "--csv -"};
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
    std::vector<std::string_view> known;
    for (const auto& row : io::column_group_table) known.push_back(row.word);
    std::set<io::ColumnGroup> groups;
    for (const std::string& given : words) {
        const auto found = std::find(known.begin(), known.end(), given);
        if (found == known.end())
            return Error{"there are no columns " + in_quotes(given) + name_nearest(given, known), "--columns"};
        groups.insert(static_cast<io::ColumnGroup>(found - known.begin()));
    }
    return groups;
}

int run_one(const RunOptions& options, const Sweep& single, const std::set<io::ColumnGroup>& groups) {
    auto started = start(options, single);
    if (!started) return complain(started.error());
    World& world = started->world;
    Snapshot now;
    world.capture(now);
    if (options.csv.empty()) {
        if (!simulate(world, options.seconds)) return interrupted();
    } else {
        const std::vector<io::VehicleColumn> columns = io::vehicle_columns(now, groups);
        TableFile table(options.csv);
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

}  // namespace

int run(const RunOptions& options) {
    const auto sweep = parse_sweep(options.settings, options.seed);
    if (!sweep) return complain(sweep.error());
    if (const auto error = check_options(options, *sweep)) return complain(*error);
    const auto groups = column_groups(options.columns);
    if (!groups) return complain(groups.error());
    return sweep->is_sweep ? run_sweep(options, *sweep, *groups) : run_one(options, *sweep, *groups);
}

}  // namespace braitenlab
