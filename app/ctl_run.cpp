// braitenctl run: a scene or a saved run, for some seconds.
#include <cmath>
#include <fstream>
#include <iostream>

#include "app/ctl.h"
#include "app/data.h"
#include "app/report.h"
#include "app/safe_file.h"
#include "core/io/run_file.h"
#include "core/scene/scene_file.h"
#include "core/world/world.h"

namespace braitenlab {

namespace {

struct Begun {
    Scene opened;
    World world;
};

Result<Begun> go_on(const RunOptions& options) {
    if (options.seed || !options.settings.empty())
        return Error{"a saved run goes on as it is; leave out --seed and --set, or run its scene anew", options.file};
    auto saved = io::load_run(options.file);
    if (!saved) return saved.error();
    World world = World::restore(saved->checkpoint);
    return Begun{std::move(saved->opened), std::move(world)};
}

Result<Begun> begin(const RunOptions& options) {
    if (options.file.ends_with(io::run_ending)) return go_on(options);
    std::vector<Setting> settings;
    for (const std::string& text : options.settings) {
        auto setting = parse_setting(text);
        if (!setting) return setting.error();
        settings.push_back(*setting);
    }
    const auto path = find_shipped(options.file);
    if (!path) return path.error();
    auto scene = load_scene(*path, settings);
    if (!scene) return scene.error();
    auto world = World::create(*scene, options.seed.value_or(1));
    if (!world) return world.error();
    return Begun{std::move(*scene), std::move(*world)};
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

}  // namespace

int run(const RunOptions& options) {
    constexpr std::uint64_t ticks_a_row = 6;  // one row per vehicle per 0.1 s
    auto begun = begin(options);
    if (!begun) return complain(begun.error());
    World& world = begun->world;

    CsvFile csv(options.csv);
    Snapshot now;
    world.capture(now);
    csv.add(now);
    const auto end = world.tick() + static_cast<std::uint64_t>(std::llround(options.seconds * 60));
    while (world.tick() < end) {
        world.step();
        if (options.csv.empty() || world.tick() % ticks_a_row != 0) continue;
        world.capture(now);
        csv.add(now);
    }
    if (const auto error = csv.close()) return complain(*error);
    if (!options.save.empty())
        if (const auto error = write_whole(options.save, io::write_run({begun->opened, world.checkpoint()})))
            return complain(*error);

    world.capture(now);
    if (options.json) std::cout << report_json(now, world.hash());
    if (options.hash) std::cout << hash_text(world.hash()) << "\n";
    if (!options.json && !options.hash) std::cout << report_text(now, world.hash());
    return exit_code::done;
}

}  // namespace braitenlab
