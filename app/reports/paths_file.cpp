#include "app/reports/paths_file.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "app/reports/axes.h"
#include "app/reports/floor_drawing.h"
#include "app/reports/svg_file.h"
#include "core/maths/angle.h"
#include "core/session/recorded_run.h"
#include "ui/words/number_text.h"

namespace braitenlab {

namespace {

constexpr float across = 800, margin = 24, above = 48, row = 22;  // px
constexpr std::uint64_t stride = 6;                               // ticks
constexpr std::size_t most_named = 8;                             // vehicles
constexpr std::size_t most_points = 2000;                         // of a path
static_assert(series_colours.size() == most_named);

struct LegendRow {
    std::string words;
    const char* colour;
};

std::string name_of(const Scene& scene, const VehicleView& vehicle) {
    if (vehicle.start >= 0) return scene.starts[static_cast<std::size_t>(vehicle.start)].name;
    return fmt::format("{} {}", scene.kinds[static_cast<std::size_t>(vehicle.kind)].name, vehicle.id + 1);
}

std::string edge_svg(const Arena& arena, const FloorMap& map) {
    const char* dashes = arena.edge == Boundary::torus ? " stroke-dasharray=\"8 5\"" : "";
    const char* width = has_walls(arena.edge) ? "3" : "1";
    if (arena.round)
        return fmt::format(
            "<ellipse cx=\"{0:.1f}\" cy=\"{1:.1f}\" rx=\"{0:.1f}\" ry=\"{1:.1f}\" fill=\"#fafaf8\" stroke=\"#7a5a40\" "
            "stroke-width=\"{2}\"/>\n",
            map.width / 2, map.height / 2, width);
    return fmt::format(
        "<rect width=\"{:.1f}\" height=\"{:.1f}\" fill=\"#fafaf8\" stroke=\"#7a5a40\" stroke-width=\"{}\"{}/>\n",
        map.width, map.height, width, dashes);
}

// Points of the paths in the picture, at most 6 px apart, which names keep clear of.
std::vector<maths::vec2> points_of(const std::map<VehicleId, RecordedPath>& paths, const FloorMap& map) {
    constexpr float apart = 6;
    std::vector<maths::vec2> points;
    for (const auto& [id, path] : paths)
        for (std::size_t i = 0; i < path.places.size(); ++i) {
            const maths::vec2 to{map.x(path.places[i].x), map.y(path.places[i].y)};
            const maths::vec2 from = i == 0 ? to : points.back();
            const float distance = std::hypot(to.x - from.x, to.y - from.y);
            const int steps = distance > across / 2 ? 1 : std::max(1, static_cast<int>(std::ceil(distance / apart)));
            for (int step = 1; step <= steps; ++step) {
                const float share = static_cast<float>(step) / static_cast<float>(steps);
                points.push_back({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
            }
        }
    return points;
}

// The place of a name near (x, y) that no other name and the fewest points of paths are in; the first of several.
struct NamePlace {
    float x = 0, y = 0;
    std::string_view anchor;
};
NamePlace name_place(float x, float y, std::string_view name, const FloorMap& map,
                     const std::vector<maths::vec2>& points, const std::vector<LabelBox>& taken) {
    const bool is_right = x > map.width / 2;
    NamePlace best{x + (is_right ? -13.0f : 13.0f), y + 17, is_right ? "end" : "start"};
    std::size_t fewest = points.size() + 1;
    for (const float below : {17.0f, -9.0f, 31.0f, -23.0f, 45.0f, -37.0f, 59.0f, -51.0f})
        for (const bool right : {is_right, !is_right}) {
            const NamePlace tried{x + (right ? -13.0f : 13.0f), y + below, right ? "end" : "start"};
            const LabelBox box = label_box(tried.x, tried.y, tried.anchor, name);
            if (box.left < 0 || box.right > map.width || !is_free(box, taken)) continue;
            const auto inside =
                static_cast<std::size_t>(std::count_if(points.begin(), points.end(), [&](maths::vec2 p) {
                    return p.x > box.left && p.x < box.right && p.y > box.top && p.y < box.bottom;
                }));
            if (inside < fewest) fewest = inside, best = tried;
        }
    return best;
}

std::string path_svg(const RecordedPath& path, const Arena& arena, const FloorMap& map, const char* colour,
                     std::string_view name, const std::vector<maths::vec2>& points, std::vector<LabelBox>& taken) {
    const maths::vec2 first = path.places.front();
    const float x = map.x(path.last.x), y = map.y(path.last.y);
    std::string out = fmt::format(
        "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\" stroke-linejoin=\"round\"/>\n"
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"#ffffff\" stroke=\"{}\" stroke-width=\"2\"/>\n"
        "<path d=\"M10 0L-6 -6L-6 6Z\" transform=\"translate({:.1f} {:.1f}) rotate({:.0f})\" fill=\"{}\"/>\n",
        path_data(path.places, arena, map, most_points), colour, map.x(first.x), map.y(first.y), colour, x, y,
        -maths::degrees(path.last.heading), colour);
    if (name.empty()) return out;
    const NamePlace place = name_place(x, y, name, map, points, taken);
    taken.push_back(label_box(place.x, place.y, place.anchor, name));
    return out + outlined_text(place.x, place.y, place.anchor, colour, name);
}

// A length of 1, 2 or 5 times a power of ten, m, of about a fifth of the picture.
float bar_length(const FloorMap& map) {
    const float wanted = across / 5 / map.scale, power = std::pow(10.0f, std::floor(std::log10(wanted)));
    const float share = wanted / power;
    return power * (share >= 5 ? 5.0f : share >= 2 ? 2.0f : 1.0f);
}

std::string scale_bar(const FloorMap& map, float y, const Strings& strings) {
    const float metres = bar_length(map), x = across - metres * map.scale;
    const int decimals = metres < 1 ? (metres < 0.1f ? 2 : 1) : 0;
    return fmt::format(
               "<path d=\"M{0:.1f} {1:.1f}v10M{0:.1f} {2:.1f}H{3:.1f}M{3:.1f} {1:.1f}v10\" fill=\"none\" "
               "stroke=\"#1c1c1a\" stroke-width=\"2\"/>\n",
               x, y - 5, y, across) +
           words_at((x + across) / 2, y + 20, ui::fixed(metres, decimals, decimal_mark(strings)) + " m",
                    " text-anchor=\"middle\"");
}

std::string legend_svg(const std::vector<LegendRow>& rows, float y) {
    std::string out;
    for (const LegendRow& each : rows) {
        out += fmt::format("<path d=\"M0 {0:.1f}H30\" stroke=\"{1}\" stroke-width=\"3\"/>\n", y, each.colour) +
               words_at(40, y + 5, each.words);
        y += row;
    }
    return out;
}

}  // namespace

std::string paths_file(const Recording& recording, std::uint64_t from, std::uint64_t to, std::string_view title,
                       const Strings& strings) {
    const RecordedRun end(recording, to);
    const Scene& scene = *end.snapshot().scene;
    const auto paths = recorded_paths(recording, from, to, stride);
    const FloorMap map(scene.arena, across);
    const bool is_named = paths.size() <= most_named;
    std::string drawn = edge_svg(scene.arena, map) + floor_svg(scene, map) + sources_svg(scene, map, true);
    std::vector<LegendRow> legend;
    std::vector<LabelBox> taken;  // by names
    const std::vector<maths::vec2> points = is_named ? points_of(paths, map) : std::vector<maths::vec2>{};
    std::map<int, std::size_t> of_kind;
    for (const auto& [id, path] : paths) {
        const auto kind = static_cast<std::size_t>(path.last.kind);
        const std::size_t number = is_named ? legend.size() : kind;
        const char* colour = series_colours[number % most_named];
        const std::string name = is_named ? name_of(scene, path.last) : std::string();
        drawn += path_svg(path, scene.arena, map, colour, name, points, taken);
        if (is_named)
            legend.push_back({name, colour});
        else
            ++of_kind[path.last.kind];
    }
    for (const auto& [kind, count] : of_kind)
        legend.push_back({fmt::format("{} ({})", scene.kinds[static_cast<std::size_t>(kind)].name, count),
                          series_colours[static_cast<std::size_t>(kind) % most_named]});
    const float below = map.height + 36;
    const auto seconds = [&](std::uint64_t tick) {
        return ui::fixed(static_cast<float>(tick) / 60, 1, decimal_mark(strings));
    };
    drawn += words_at(0, below, fill(strings("report.paths_time"), {seconds(from), seconds(to)})) +
             legend_svg(legend, below + row) + scale_bar(map, below - 8, strings);
    const float height = above + below + row * (static_cast<float>(legend.size()) + 1) + margin;
    return svg_file(title, across + 2 * margin, height,
                    fmt::format("<g transform=\"translate({} {})\">\n{}</g>", margin, above, drawn));
}

}  // namespace braitenlab
