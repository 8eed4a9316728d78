// braitenctl compare: two brains from the same start, as a table or JSON.
#include "core/insight/compare.h"

#include <cmath>
#include <iostream>
#include <utility>

#include <fmt/format.h>

#include "app/ctl/ctl.h"
#include "app/ctl/report.h"
#include "core/io/checked_json.h"

namespace braitenlab {

namespace {

using insight::ComparedRun;
using insight::Design;

struct BothRuns {
    Design a, b;
    ComparedRun run_of_a, run_of_b;
};

Result<Design> design_of_file(const std::string& file, const std::vector<Sensor>& own) {
    auto read = brain_of_file(file, {});
    if (!read) return read.error();
    return Design{std::move(read->brain), read->sensors.empty() ? own : read->sensors};
}

Result<BothRuns> run_both(const CompareOptions& options) {
    const auto scene = read_scene_with(options.file, {}, "compare", "a scene");
    if (!scene) return scene.error();
    const auto world = World::create(*scene, options.seed);
    if (!world) return world.error();
    const Snapshot start = snapshot_of(*world);
    const auto id = vehicle_at_start(start, options.vehicle, options.file);
    if (!id) return id.error();
    const VehicleView* vehicle = find_vehicle(start, *id);
    const std::vector<Sensor>& own = kind_of(start, *vehicle).sensors;
    auto a = design_of_file(options.a, own), b = design_of_file(options.b, own);
    if (!a) return a.error();
    if (!b) return b.error();
    const insight::CompareQuestion question{.start = world->checkpoint(),
                                            .vehicle = vehicle->id,
                                            .target = {vehicle->id, -1},
                                            .ticks = static_cast<std::size_t>(std::llround(options.seconds * 60))};
    BothRuns both{std::move(*a), std::move(*b), {}, {}};
    for (const Design* design : {&both.a, &both.b}) {
        World trial = World::restore(question.start);
        for (const Command& command : insight::commands_for(*design, start, *vehicle, question.target))
            if (const auto error = trial.apply(command)) return *error;
    }
    both.run_of_a = insight::run_design(question, both.a);
    both.run_of_b = insight::run_design(question, both.b);
    return both;
}

std::string compare_json(const CompareOptions& options, const BothRuns& both) {
    nlohmann::ordered_json json{{"scene", options.file}, {"seed", options.seed}, {"seconds", options.seconds}};
    for (const auto& row : insight::compare_measure_table) {
        const auto index = static_cast<std::size_t>(row.value);
        const auto differs = insight::difference(both.run_of_a.numbers, both.run_of_b.numbers, row.value);
        json["measures"][std::string(row.word)] = {{"unit", row.unit},
                                                   {"a", rounded_json(both.run_of_a.numbers[index])},
                                                   {"b", rounded_json(both.run_of_b.numbers[index])},
                                                   {"difference", rounded_json(differs.value_or(NAN))}};
    }
    return io::json_text(json) + "\n";
}

std::string compare_text(const BothRuns& both) {
    std::string text = fmt::format("{:<12}{:>10}{:>10}{:>10}\n", "", "A", "B", "B-A");
    const auto cell = [](float number) {
        return std::isnan(number) ? "-" : std::isinf(number) ? "never" : fmt::format("{:.2f}", number);
    };
    for (const auto& row : insight::compare_measure_table) {
        const auto index = static_cast<std::size_t>(row.value);
        const auto differs = insight::difference(both.run_of_a.numbers, both.run_of_b.numbers, row.value);
        text += fmt::format("{:<12}{:>10}{:>10}{:>10}\n", fmt::format("{} ({})", row.word, row.unit),
                            cell(both.run_of_a.numbers[index]), cell(both.run_of_b.numbers[index]),
                            differs ? fmt::format("{:+.2f}", *differs) : "-");
    }
    return text;
}

}  // namespace

int compare(const CompareOptions& options) {
    const auto both = run_both(options);
    if (!both) return complain(both.error());
    std::cout << (options.json ? compare_json(options, *both) : compare_text(*both));
    return exit_code::done;
}

}  // namespace braitenlab
