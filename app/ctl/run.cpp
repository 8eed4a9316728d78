// braitenctl run: runs a scene or a saved run for a number of seconds.
#include <cmath>
#include <fstream>
#include <iostream>

#include "app/ctl/ctl.h"
#include "app/ctl/report.h"
#include "app/files/data.h"
#include "app/files/safe_file.h"
#include "core/io/run_file.h"
#include "core/scene/scene_file.h"
#include "core/world/world.h"

namespace braitenlab {

namespace {

struct StartedRun {
    Scene opened;
    World world;
};

Result<StartedRun> continue_run(const RunOptions& options) {
    if (options.seed || !options.settings.empty())
        return Error{"a saved run has its own seed and values; leave out --seed and --set, or run its scene",
                     options.file};
    auto saved = io::load_run(options.file);
    if (!saved) return saved.error();
    World world = World::restore(saved->checkpoint);
    return StartedRun{std::move(saved->opened), std::move(world)};
}

Result<StartedRun> start(const RunOptions& options) {
    if (options.file.ends_with(io::run_ending)) return continue_run(options);
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
    return StartedRun{std::move(*scene), std::move(*world)};
}

// The rows of --csv. A regular file is replaced as a whole at the end; a pipe or a device is written directly.
class CsvFile {
public:
    explicit CsvFile(const std::string& path) {
        std::error_code none;
        if (path.empty()) return;
        if (std::filesystem::exists(path, none) && !std::filesystem::is_regular_file(path, none))
            stream_.emplace(path);
        else
            file_.emplace(path);
        name_ = path;
        write(csv_header());
    }
    void add(const Snapshot& now) {
        if (!name_.empty()) write(csv_rows(now));
    }
    std::optional<Error> close() {
        if (file_) return file_->commit();
        if (!stream_) return std::nullopt;
        stream_->close();
        if (*stream_) return std::nullopt;
        return Error{"could not be written; check that the folder exists, may be written to and has room", name_};
    }

private:
    void write(const std::string& rows) { file_ ? file_->write(rows) : void(*stream_ << rows); }

    std::string name_;  // empty: no file
    std::optional<FileWriter> file_;
    std::optional<std::ofstream> stream_;
};

}  // namespace

int run(const RunOptions& options) {
    constexpr std::uint64_t ticks_a_row = 6;  // one row per vehicle per 0.1 s
    auto started = start(options);
    if (!started) return complain(started.error());
    World& world = started->world;

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
        if (const auto error = write_whole(options.save, io::write_run({started->opened, world.checkpoint()})))
            return complain(*error);

    world.capture(now);
    if (options.json) std::cout << report_json(now, world.hash());
    if (options.hash) std::cout << hash_text(world.hash()) << "\n";
    if (!options.json && !options.hash) std::cout << report_text(now, world.hash());
    return exit_code::done;
}

}  // namespace braitenlab
