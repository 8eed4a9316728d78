#include "app/reports/map_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "app/reports/axes.h"
#include "app/reports/svg_file.h"
#include "core/insight/axis_value.h"
#include "core/scene/sensor_pairs.h"
#include "ui/map_look.h"
#include "ui/words/measure_text.h"
#include "ui/words/number_text.h"

namespace braitenlab {

namespace {

using insight::MapAxis;
using insight::MapCell;
using insight::MapCells;
using insight::MapMeasure;
using insight::MapQuestion;

constexpr float map_side = 560, map_left = 92, map_top = 56, map_bottom = 106,
                map_right = 220;               // px, the map and what is around it
constexpr float legend_row = 24, swatch = 16;  // of the legend

// The mark of a kind in a cell at (x, y), as squares of a path.
std::string mark_data(insight::Behaviour kind, float x, float y, float cell) {
    const float dot = cell / (ui::mark_size + 2);
    std::string data;
    for (int down = 0; down < ui::mark_size; ++down)
        for (int across = 0; across < ui::mark_size; ++across)
            if (ui::is_marked(kind, across, down))
                data +=
                    square_data(x + dot * static_cast<float>(across + 1), y + dot * static_cast<float>(down + 1), dot);
    return data;
}

std::string marks_path(const std::string& data) {
    return data.empty() ? "" : fmt::format("<path d=\"{}\" fill=\"#1a1a1a\"/>\n", data);
}

// One path for each colour, and one for all marks.
std::string cells_svg(const MapCells& cells, MapMeasure measure, const ui::MapScale& scale) {
    constexpr float least_mark = 7;  // px, of a cell
    const float cell = map_side / static_cast<float>(cells.size);
    std::map<std::string, std::string> of_colour;
    std::string marks;
    for (int y = 0; y < cells.size; ++y)
        for (int x = 0; x < cells.size; ++x) {
            const MapCell& here = *cells.at({x, y});
            const float left = cell * static_cast<float>(x), top = map_side - cell * static_cast<float>(y + 1);
            const ui::MapColour colour = ui::cell_colour(here.outcome, here.agree, measure, scale, {1, 1, 1});
            of_colour[colour_text(colour)] += square_data(left, top, cell);
            if (measure == MapMeasure::behaviour && cell >= least_mark)
                marks += mark_data(here.outcome.behaviour, left, top, cell);
        }
    std::string out = "<g shape-rendering=\"crispEdges\">\n";
    for (const auto& [colour, data] : of_colour) out += fmt::format("<path d=\"{}\" fill=\"{}\"/>\n", data, colour);
    return out + marks_path(marks) + "</g>\n";
}

// The path without what both axes share: "kind.lover.sensor.SL.angle" is "sensor.SL.angle".
std::string short_path(const std::string& path, const std::string& other) {
    const auto kind_of = [](const std::string& text) {
        const std::size_t end = text.starts_with("kind.") ? text.find('.', 5) : std::string::npos;
        return end == std::string::npos ? std::string() : text.substr(0, end + 1);
    };
    const std::string kind = kind_of(path), others = kind_of(other);
    if (kind.empty() || (!others.empty() && others != kind)) return path;
    std::string text = path;
    for (std::size_t at = 0; (at = text.find(kind, at)) != std::string::npos;) text.erase(at, kind.size());
    for (std::size_t at = 0; (at = text.find("=-", at)) != std::string::npos;) text.replace(at, 2, " = −");
    return text;
}

// The value of the axis in the list of values that a vehicle and its scene have, of the first vehicle of each kind; its
// name with its unit, and that of the kind where the scene has several. Empty for dials and for other values.
std::string value_label(const MapQuestion& question, const MapAxis& axis, const Strings& strings) {
    if (!axis.dials.empty()) return "";
    const auto world = World::create(question.scene, question.seed);
    if (!world) return "";
    const Snapshot now = snapshot_of(*world);
    std::set<int> kinds;
    for (const VehicleView& vehicle : now.vehicles) {
        if (!kinds.insert(vehicle.kind).second && vehicle.start < 0) continue;
        const Kind& kind = kind_of(now, vehicle);
        for (const insight::AxisValue& value :
             insight::axis_values({now, vehicle, {no_vehicle, vehicle.kind}, chosen_pair(kind, "")})) {
            if (value.paths != axis.values) continue;
            const bool is_of_kind =
                group_of(value.owner) == insight::ValueGroup::body && question.scene.kinds.size() > 1;
            const std::string name =
                (is_of_kind ? shown_name(strings, kind.name) + ": " : "") + ui::axis_name(strings, value);
            return value.unit.empty() ? name : fmt::format("{} ({})", name, value.unit);
        }
    }
    return "";
}

// "LL=RR": "weight LL = RR"; as the path where it is no wire of an eye.
std::string dials_label(const MapAxis& axis, const Strings& strings) {
    const bool are_weights = !axis.dials.empty() && std::all_of(axis.dials.begin(), axis.dials.end(), [](Dial dial) {
        return std::find(weight_dials.begin(), weight_dials.end(), dial) != weight_dials.end();
    });
    if (!are_weights) return "";
    std::string names;
    for (const Dial dial : axis.dials) names += (names.empty() ? "" : " = ") + std::string(name(dial));
    return fill(strings("report.map_weight"), {names});
}

// What the scene has on this axis; nullopt if the axis is of several values that differ, or of none of the list.
std::optional<float> own_value(const MapQuestion& question, const Snapshot& now, const MapAxis& axis) {
    const VehicleView* vehicle = find_vehicle(now, question.vehicle);
    if (!vehicle) return std::nullopt;
    for (const insight::AxisValue& value : insight::axis_values({now, *vehicle, question.target, question.pair}))
        if (axis.dials.empty() ? value.paths == axis.values : value.dials == axis.dials)
            return value.is_one ? std::optional(value.now) : std::nullopt;
    return std::nullopt;
}

// A ring at the values of the scene, with its words at (0, map_side + 92); empty where they are not on the map.
std::string own_mark(const MapQuestion& question, const PlotFrame& frame, const Strings& strings) {
    const auto world = World::create(question.scene, question.seed);
    if (!world) return "";
    const Snapshot now = snapshot_of(*world);
    const auto x = own_value(question, now, question.x), y = own_value(question, now, question.y);
    const auto is_on = [](const PlotFrame::Axis& axis, float value) {
        return static_cast<double>(value) >= axis.from && static_cast<double>(value) <= axis.to;
    };
    if (!x || !y || !is_on(frame.x, *x) || !is_on(frame.y, *y)) return "";
    const auto ring = [](float at_x, float at_y) {
        const std::string place = fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"7\" fill=\"none\" ", at_x, at_y);
        return place + "stroke=\"#fff\" stroke-width=\"5\"/>\n" + place + "stroke=\"#111\" stroke-width=\"2\"/>\n";
    };
    return ring(frame.x_of(static_cast<double>(*x)), frame.y_of(static_cast<double>(*y))) + ring(8, map_side + 88) +
           words_at(22, map_side + 92, strings("report.map_own"));
}

std::string axis_label(const MapQuestion& question, const MapAxis& axis, const MapAxis& other, const std::string& given,
                       const Strings& strings) {
    if (!given.empty()) return given;
    const std::string of_dials = dials_label(axis, strings);
    const std::string named = of_dials.empty() ? value_label(question, axis, strings) : of_dials;
    return named.empty() ? short_path(axis.path, other.path) : named;
}

// A cell stands for the value at its middle.
std::string axes_svg(const MapQuestion& question, int size, const FigureLabels& labels, const Strings& strings) {
    const auto ends = [](const MapAxis& axis) {
        return PlotFrame::Axis{static_cast<double>(axis.from), static_cast<double>(axis.to)};
    };
    const PlotFrame frame{map_side, map_side, ends(question.x), ends(question.y),
                          map_side / static_cast<float>(size) / 2};
    return frame_svg(frame, axis_label(question, question.x, question.y, labels.x, strings),
                     axis_label(question, question.y, question.x, labels.y, strings), strings) +
           own_mark(question, frame, strings);
}

std::string kinds_legend(const MapCells& cells, const Strings& strings) {
    std::array<int, insight::behaviour_count> count{};
    for (const auto& cell : cells.cells) ++count[static_cast<std::size_t>(cell->outcome.behaviour)];
    std::string out;
    float y = legend_row;
    for (const auto& look : ui::behaviour_looks) {
        const int cells_of_kind = count[static_cast<std::size_t>(look.value)];
        if (cells_of_kind == 0) continue;
        out += fmt::format("<path d=\"{}\" fill=\"{}\"/>\n", square_data(0, y, swatch), colour_text(look.colour)) +
               marks_path(mark_data(look.value, 0, y, swatch)) +
               words_at(
                   swatch + 10, y + 13,
                   fmt::format("{} ({})", strings("map.kind." + std::string(row_of(look.value).word)), cells_of_kind));
        y += legend_row;
    }
    return out;
}

std::string scale_legend(const MapCells& cells, MapMeasure measure, const ui::MapScale& scale, const Strings& strings) {
    std::string out = scale_svg(scale, strings);
    const bool has_none = std::any_of(cells.cells.begin(), cells.cells.end(), [&](const auto& cell) {
        return !std::isfinite(insight::number_of(cell->outcome, measure));
    });
    if (!has_none) return out;
    const float y = scale_bottom + legend_row;
    return out + fmt::format("<path d=\"{}\" fill=\"#ffffff\" stroke=\"{}\"/>\n", square_data(0, y, swatch), axis_ink) +
           words_at(swatch + 10, y + 13,
                    strings(measure == MapMeasure::time_to_touch ? "map.never" : "report.map_none"));
}

std::string runs_text(const MapQuestion& question, const Strings& strings) {
    const std::string seconds =
        ui::fixed(static_cast<float>(question.ticks) / 60, question.ticks % 60 == 0 ? 0 : 1, decimal_mark(strings));
    if (question.seeds == 1) return fill(strings("report.map_run"), {seconds, std::to_string(question.seed)});
    const std::uint64_t last = question.seed + static_cast<std::uint64_t>(question.seeds) - 1;
    return fill(strings("report.map_runs"),
                {std::to_string(question.seeds), seconds, std::to_string(question.seed), std::to_string(last)});
}

}  // namespace

std::string map_file(const MapQuestion& question, const MapCells& cells, MapMeasure measure, const FigureLabels& labels,
                     const Strings& strings) {
    const std::string& own = question.scene.title.empty() ? question.scene.name : question.scene.title;
    const std::string title(labels.title.empty() ? strings.find(own, own) : labels.title);
    const bool is_of_kinds = measure == MapMeasure::behaviour;
    const ui::MapScale scale = ui::scale_of(cells.cells, measure);
    const std::string_view unit = row_of(measure).unit;
    const std::string heading = std::string(strings("map.measure." + std::string(row_of(measure).word))) +
                                (unit.empty() ? "" : fmt::format(" ({})", unit));
    const std::string legend =
        words_at(0, 12, heading, " font-weight=\"bold\"") +
        (is_of_kinds ? kinds_legend(cells, strings) : scale_legend(cells, measure, scale, strings));
    const std::string drawn = cells_svg(cells, measure, scale) + axes_svg(question, cells.size, labels, strings) +
                              fmt::format("<g transform=\"translate({} 0)\">\n{}</g>\n", map_side + 28, legend) +
                              words_at(0, map_side + 72, runs_text(question, strings));
    return svg_file(title, map_left + map_side + map_right, map_top + map_side + map_bottom,
                    fmt::format("<g transform=\"translate({} {})\">\n{}</g>", map_left, map_top, drawn));
}

}  // namespace braitenlab
