#include "app/ctl/run_sweep.h"

#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "app/ctl/simulate.h"
#include "app/ctl/table_file.h"
#include "app/files/data.h"
#include "app/jobs/jobs.h"
#include "app/platform/platform.h"
#include "core/scene/file_kind.h"
#include "core/world/world.h"

namespace braitenlab {

namespace {

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
    for (const Setting& setting : combination(sweep, run / sweep.seeds)) {
        io::add_csv_cell(cells, std::string_view(setting.value));
        cells += ',';
    }
    return cells;
}

std::string header(const SweepInput& input) {
    std::string line = "run,seed,";
    for (const SweptValue& value : input.sweep.values) {
        io::add_csv_cell(line, std::string_view(value.path));
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
    auto text = read_text(*path);
    if (!text) return text.error();
    SweepInput input{sweep, std::move(*text), path->string(), options.seconds, {}};
    for (std::size_t i = 1; i < sweep.combinations(); ++i)
        if (const auto scene = parse_scene(input.scene_text, input.scene_file, combination(sweep, i)); !scene)
            return scene.error();
    const auto world = world_of(input, 0);
    if (!world) return world.error();
    Snapshot start;
    world->capture(start);
    input.columns = io::vehicle_columns(start, groups);
    return input;
}

}  // namespace

int run_sweep(const RunOptions& options, const Sweep& sweep, const std::set<io::ColumnGroup>& groups) {
    auto prepared = prepare(options, sweep, groups);
    if (!prepared) return complain(prepared.error());
    const auto input = std::make_shared<const SweepInput>(std::move(*prepared));
    TableFile table(options.csv);
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

}  // namespace braitenlab
