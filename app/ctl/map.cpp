// braitenctl map: a map of behaviour as text, JSON, a table or a picture.
#include "core/insight/map.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <string_view>

#include <fmt/format.h>

#include "app/ctl/ctl.h"
#include "app/ctl/parts.h"
#include "app/ctl/progress.h"
#include "app/ctl/report.h"
#include "app/ctl/table_file.h"
#include "app/files/png.h"
#include "app/files/safe_file.h"
#include "app/platform/platform.h"
#include "app/reports/map_file.h"
#include "app/terminal.h"
#include "core/io/checked_json.h"
#include "core/io/csv.h"
#include "core/lesson/exercise_file.h"
#include "core/scene/sensor_pairs.h"
#include "ui/map_look.h"

namespace braitenlab {

namespace {

using insight::Behaviour;
using insight::MapAxis;
using insight::MapBase;
using insight::MapCell;
using insight::MapCells;
using insight::MapMeasure;
using insight::MapPlace;

// The vehicle that is judged, and the kind whose brain the dials set.
std::optional<Error> choose_vehicle(const MapOptions& options, insight::MapQuestion& question) {
    const auto world = World::create(question.scene, question.seed);
    if (!world) return world.error();
    const Snapshot start = snapshot_of(*world);
    const auto vehicle = vehicle_at_start(start, options.vehicle, options.file);
    if (!vehicle) return vehicle.error();
    const VehicleView& judged = *find_vehicle(start, *vehicle);
    question.vehicle = judged.id;
    question.target = {no_vehicle, judged.kind};
    question.pair = chosen_pair(kind_of(start, judged), "");
    return std::nullopt;
}

Result<insight::MapQuestion> question_of(const MapOptions& options) {
    auto scene = read_scene_with(options.file, options.settings, "map", "a scene");
    if (!scene) return scene.error();
    const auto x = insight::parse_axis(options.x, "--x"), y = insight::parse_axis(options.y, "--y");
    if (!x) return x.error();
    if (!y) return y.error();
    insight::MapQuestion question{.scene = std::move(*scene),
                                  .seed = options.seed,
                                  .seeds = options.seeds,
                                  .x = *x,
                                  .y = *y,
                                  .size = options.size,
                                  .ticks = static_cast<std::size_t>(std::llround(options.seconds * 60))};
    if (const auto error = choose_vehicle(options, question)) return *error;
    return question;
}

Part part_of_level(const std::shared_ptr<const MapBase>& base, std::size_t level) {
    return [base, places = insight::map_levels(base->question().size)[level]](std::size_t part) {
        const MapCell cell = insight::run_cell(base, places[part]);
        const insight::Outcome& of = cell.outcome;
        Numbers numbers{static_cast<double>(of.behaviour)};
        for (const float number :
             {of.closest, of.final_distance, of.time_to_touch, of.captures, of.survival, cell.agree})
            numbers.push_back(static_cast<double>(number));
        return numbers;
    };
}

MapCell cell_of_numbers(const Numbers& numbers) {
    MapCell cell;
    insight::Outcome& of = cell.outcome;
    of.behaviour = static_cast<Behaviour>(static_cast<int>(numbers.at(0)));
    std::size_t next = 1;
    for (float* number : {&of.closest, &of.final_distance, &of.time_to_touch, &of.captures, &of.survival, &cell.agree})
        *number = static_cast<float>(numbers.at(next++));
    return cell;
}

// What decides the runs of a map.
std::string text_of_level(const MapOptions& options, std::size_t level) {
    return "map\n" + io::json_text(nlohmann::json{{"file", options.file},
                                                  {"x", options.x},
                                                  {"y", options.y},
                                                  {"vehicle", options.vehicle},
                                                  {"size", options.size},
                                                  {"seeds", options.seeds},
                                                  {"seed", options.seed},
                                                  {"seconds", options.seconds},
                                                  {"settings", options.settings},
                                                  {"level", level}});
}

// Incomplete when the user has interrupted the program.
Result<MapCells> compute(const MapOptions& options, const std::shared_ptr<const MapBase>& base) {
    const int size = base->question().size;
    MapCells cells(size);
    PartRunner runner(options.threads);
    const auto levels = insight::map_levels(size);
    Progress progress = progress_of("cells", static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    std::size_t done = 0;
    for (std::size_t level = 0; level < levels.size(); ++level) {
        const auto results = runner.run(
            {levels[level].size(), part_of_level(base, level), [&] { return text_of_level(options, level); }});
        if (!results) return results.error();
        for (std::size_t i = 0; i < results->size(); ++i) cells.at(levels[level][i]) = cell_of_numbers((*results)[i]);
        progress.at(done += results->size());
    }
    return cells;
}

std::string json_text(const insight::MapQuestion& question, const MapCells& cells, MapMeasure measure) {
    nlohmann::ordered_json json;
    const auto values = [&](const MapAxis& axis) {
        auto list = nlohmann::ordered_json::array();
        for (int i = 0; i < cells.size; ++i) list.push_back(rounded_json(insight::value_at(axis, i, cells.size)));
        return list;
    };
    json["scene"] = question.scene.name;
    json["x_path"] = question.x.path, json["y_path"] = question.y.path;
    json["x"] = values(question.x), json["y"] = values(question.y);
    json["measure"] = word(measure);
    auto rows = nlohmann::ordered_json::array(), agree = nlohmann::ordered_json::array();
    for (int y = 0; y < cells.size; ++y) {
        auto row = nlohmann::ordered_json::array(), shares = nlohmann::ordered_json::array();
        for (int x = 0; x < cells.size; ++x) {
            const MapCell& cell = *cells.at({x, y});
            shares.push_back(rounded_json(cell.agree));
            if (measure == MapMeasure::behaviour)
                row.push_back(word(cell.outcome.behaviour));
            else
                row.push_back(rounded_json(insight::number_of(cell.outcome, measure)));
        }
        rows.push_back(std::move(row)), agree.push_back(std::move(shares));
    }
    json["cells"] = std::move(rows);
    if (question.seeds > 1) json["agree"] = std::move(agree);
    return io::json_text(json) + "\n";
}

std::string table_text(const insight::MapQuestion& question, const MapCells& cells) {
    std::string text;
    io::add_csv_cell(text, std::string_view(question.x.path)), text += ',';
    io::add_csv_cell(text, std::string_view(question.y.path));
    text += ",kind,agree,closest_m,final_m,touch_s,captures,survival_s\n";
    const auto number = [](float value) { return std::isfinite(value) ? fmt::format("{:.5f}", value) : std::string(); };
    for (int y = 0; y < cells.size; ++y)
        for (int x = 0; x < cells.size; ++x) {
            const MapCell& cell = *cells.at({x, y});
            const insight::Outcome& of = cell.outcome;
            text += fmt::format(
                "{:.5f},{:.5f},{},{:.5f},{},{},{},{:.0f},{:.5f}\n", insight::value_at(question.x, x, cells.size),
                insight::value_at(question.y, y, cells.size), word(of.behaviour), cell.agree, number(of.closest),
                number(of.final_distance), number(of.time_to_touch), of.captures, of.survival);
        }
    return text;
}

// The largest y is at the top. Each cell has its mark where it has room for one.
std::string picture(const MapCells& cells, MapMeasure measure) {
    constexpr int wanted = 768;  // pixels along a side
    const int cell_side = std::max(2, wanted / cells.size), side = cell_side * cells.size;
    const int dot = cell_side / (ui::mark_size + 2);
    const ui::MapScale scale = ui::scale_of(cells.cells, measure);
    std::vector<unsigned char> rgb(static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * 3);
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const MapCell& cell = *cells.at({column / cell_side, cells.size - 1 - row / cell_side});
            ui::MapColour colour = ui::cell_colour(cell.outcome, cell.agree, measure, scale, {1, 1, 1});
            const int margin = (cell_side - dot * ui::mark_size) / 2;
            const int mark_x = column % cell_side - margin, mark_y = row % cell_side - margin;
            const bool has_mark = measure == MapMeasure::behaviour && dot > 0 && mark_x >= 0 && mark_y >= 0 &&
                                  mark_x < dot * ui::mark_size && mark_y < dot * ui::mark_size;
            if (has_mark && ui::is_marked(cell.outcome.behaviour, mark_x / dot, mark_y / dot))
                colour = {0.1f, 0.1f, 0.1f};
            unsigned char* pixel = &rgb[(static_cast<std::size_t>(row) * static_cast<std::size_t>(side) +
                                         static_cast<std::size_t>(column)) *
                                        3];
            for (const float part : {colour.r, colour.g, colour.b})
                *pixel++ = static_cast<unsigned char>(std::lround(part * 255));
        }
    return png(side, side, rgb);
}

// A letter or a digit a cell; the largest y is at the top.
std::string plain_text(const insight::MapQuestion& question, const MapCells& cells, MapMeasure measure) {
    constexpr std::string_view letters = "TNCPAFLS";
    static_assert(letters.size() == insight::behaviour_count);
    const bool is_kind = measure == MapMeasure::behaviour;
    const ui::MapScale scale = ui::scale_of(cells.cells, measure);
    std::string text;
    for (int y = cells.size; y-- > 0;) {
        text += fmt::format("{:8.2f}  ", insight::value_at(question.y, y, cells.size));
        for (int x = 0; x < cells.size; ++x) {
            const insight::Outcome& of = cells.at({x, y})->outcome;
            const float number = is_kind ? NAN : insight::number_of(of, measure);
            if (is_kind)
                text += letters[static_cast<std::size_t>(of.behaviour)];
            else
                text += std::isfinite(number) ? static_cast<char>('0' + std::lround(9 * scale.share(number))) : '.';
        }
        text += '\n';
    }
    text += format_lines("{:>8}  from left to right: {} from {:g} to {:g}\n", question.y.path, question.x.path,
                         question.x.from, question.x.to);
    if (!is_kind)
        return text + fmt::format("0 is {:g} {}, 9 is {:g} {}, . is never\n", scale.low, row_of(measure).unit,
                                  scale.high, row_of(measure).unit);
    for (const auto& row : insight::behaviour_table)
        text += fmt::format("{} {}  ", letters[static_cast<std::size_t>(row.value)], row.word);
    text.resize(text.size() - 2);
    return text + "\n";
}

std::optional<Error> check_outputs(const MapOptions& options) {
    if (auto error = json_beside_csv(options.csv, options.json)) return error;
    if (auto error = ending_fault("--png", options.png, ".png")) return error;
    return ending_fault("--svg", options.svg, ".svg");
}

// The files that were asked for.
std::optional<Error> write_map(const MapOptions& options, const insight::MapQuestion& asked, const MapCells& cells,
                               MapMeasure measure, const Strings& strings) {
    const auto style = style_of(options.table);
    if (!style) return style.error();
    if (auto error = write_table(options.csv, *style, table_text(asked, cells))) return error;
    if (!options.png.empty())
        if (auto error = write_whole(options.png, picture(cells, measure))) return error;
    if (options.svg.empty()) return std::nullopt;
    return write_whole(options.svg, map_file(asked, cells, measure, options.labels, strings));
}

}  // namespace

Result<Part> part_of_map(std::string_view text) {
    const auto json = nlohmann::json::parse(text);
    MapOptions options;
    json.at("file").get_to(options.file), json.at("x").get_to(options.x), json.at("y").get_to(options.y);
    json.at("vehicle").get_to(options.vehicle), json.at("size").get_to(options.size);
    json.at("seeds").get_to(options.seeds), json.at("seed").get_to(options.seed);
    json.at("seconds").get_to(options.seconds), json.at("settings").get_to(options.settings);
    auto question = question_of(options);
    if (!question) return question.error();
    const auto base = MapBase::create(std::move(*question));
    if (!base) return base.error();
    return part_of_level(*base, json.at("level").get<std::size_t>());
}

int map(const MapOptions& options) {
    if (const auto error = check_outputs(options)) return complain(*error);
    const auto measure = named_in(insight::map_measure_table, options.measure, "there is no measure", "--measure");
    if (!measure) return complain(measure.error());
    auto question = question_of(options);
    if (!question) return complain(question.error());
    const auto strings = strings_with(options.table.language, texts_of(question->scene));
    if (!strings) return complain(strings.error());
    const auto base = MapBase::create(std::move(*question));
    if (!base) return complain(base.error());
    const auto cells = compute(options, *base);
    if (is_told_to_end()) return interrupted();
    if (!cells) return complain(cells.error());
    const insight::MapQuestion& asked = (*base)->question();
    if (const auto error = write_map(options, asked, *cells, *measure, *strings)) return complain(*error);
    if (options.json) std::cout << json_text(asked, *cells, *measure);
    const bool writes = !(options.csv.empty() && options.png.empty() && options.svg.empty());
    if (!options.json && !writes) std::cout << plain_text(asked, *cells, *measure);
    return exit_code::done;
}

}  // namespace braitenlab
