#include "app/reports/path_picture.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/reports/html.h"
#include "core/maths/angle.h"

namespace braitenlab {

namespace {

constexpr const char* good_colour = "#0b6e4f";
constexpr const char* bad_colour = "#b3261e";

// Metres to pixels of the picture: y up becomes y down.
struct FloorMap {
    float scale, width, height;
    explicit FloorMap(const Arena& arena, float across)
        : scale(across / arena.width), width(across), height(arena.height * across / arena.width) {}
    float x(float metres) const { return width / 2 + metres * scale; }
    float y(float metres) const { return height / 2 - metres * scale; }
};

// A box, an ellipse or a polygon of the floor, along its heading.
template <class Shape>
std::string shape_svg(const Shape& shape, bool round, const FloorMap& map, const char* fill) {
    const float length = std::max(1.0f, shape.length * map.scale), width = std::max(1.0f, shape.width * map.scale);
    std::string out = fmt::format("<g transform=\"translate({:.1f} {:.1f}) rotate({:.1f})\" fill=\"{}\">",
                                  map.x(shape.x), map.y(shape.y), -maths::degrees(shape.heading), fill);
    if (!shape.corners.empty()) {
        out += "<polygon points=\"";
        for (const PolygonCorner& corner : shape.corners)
            out += fmt::format("{:.1f},{:.1f} ", corner.x * map.scale, -corner.y * map.scale);
        out += "\"/>";
    } else if (round) {
        out += fmt::format("<ellipse rx=\"{:.1f}\" ry=\"{:.1f}\"/>", length / 2, width / 2);
    } else {
        out += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>", -length / 2,
                           -width / 2, length, width);
    }
    return out + "</g>";
}

std::string floor_svg(const Scene& scene, const FloorMap& map) {
    std::string out;
    for (const Zone& zone : scene.zones)
        out += shape_svg(zone, zone.round, map, zone.surface == Surface::tape ? "#6b6b66" : "#e2e2dc");
    for (const Obstacle& obstacle : scene.obstacles) out += shape_svg(obstacle, false, map, "#a3a39c");
    return out;
}

std::string sources_svg(const Scene& scene, const FloorMap& map, bool names) {
    std::string out;
    const float radius = names ? 5 : 2.5f;
    for (const Source& source : scene.sources) {
        out += fmt::format(
            "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"#f2b705\" stroke=\"#5c4700\" stroke-width=\"1\"/>",
            map.x(source.x), map.y(source.y), radius);
        if (!names) continue;
        const bool is_right = source.x > 0;
        out +=
            fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"11\" text-anchor=\"{}\" fill=\"#333\">{}</text>",
                        map.x(source.x) + (is_right ? -9.0f : 9.0f), map.y(source.y) - 8, is_right ? "end" : "start",
                        html::escaped(source.name));
    }
    return out;
}

// The path as SVG path data, interrupted where the vehicle went over an edge of a torus.
std::string path_data(const std::vector<maths::vec2>& path, const Arena& arena, const FloorMap& map, std::size_t most) {
    const std::size_t step = std::max<std::size_t>(1, (path.size() + most - 1) / std::max<std::size_t>(most, 1));
    std::string data;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const bool is_last = i + 1 == path.size();
        const bool jumps = i > 0 && (std::fabs(path[i].x - path[i - 1].x) > arena.width / 2 ||
                                     std::fabs(path[i].y - path[i - 1].y) > arena.height / 2);
        if (i % step != 0 && !is_last && !jumps) continue;
        data += fmt::format("{}{:.1f} {:.1f}", i == 0 || jumps ? "M" : "L", map.x(path[i].x), map.y(path[i].y));
    }
    return data;
}

std::string sign_svg(bool passed, float width, const char* colour) {
    const float x = width - 8, y = 8;
    const std::string data = passed ? fmt::format("M{} {}L{} {}L{} {}", x - 4, y, x - 1, y + 3, x + 4, y - 4)
                                    : fmt::format("M{} {}L{} {}M{} {}L{} {}", x - 3.5f, y - 3.5f, x + 3.5f, y + 3.5f,
                                                  x - 3.5f, y + 3.5f, x + 3.5f, y - 3.5f);
    return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>", data, colour);
}

}  // namespace

std::string path_picture(const Exercise& exercise, const StartResult& start, const std::string& label,
                         const PathPicture& look) {
    const Scene& scene = exercise.scene;
    const FloorMap map(scene.arena, look.width);
    const char* colour = start.passed ? good_colour : bad_colour;
    const float stroke = look.names ? 2.5f : 1.5f;
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"{}\" viewBox=\"0 0 {:.0f} {:.0f}\" "
        "width=\"{:.0f}\" height=\"{:.0f}\"><rect x=\"0.5\" y=\"0.5\" width=\"{:.0f}\" height=\"{:.0f}\" rx=\"3\" "
        "fill=\"#fafaf8\" stroke=\"#b8b8b2\"/>",
        html::escaped(label), map.width, map.height, map.width, map.height, map.width - 1, map.height - 1);
    out += floor_svg(scene, map) + sources_svg(scene, map, look.names);
    if (!start.path.empty()) {
        out += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"{}/>",
                           path_data(start.path, scene.arena, map, look.points), colour, stroke,
                           start.passed ? "" : " stroke-dasharray=\"4 2\"");
        out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\"/>", map.x(start.path[0].x),
                           map.y(start.path[0].y), stroke * 1.4f, colour);
    }
    if (look.has_sign) out += sign_svg(start.passed, map.width, colour);
    return out + "</svg>";
}

}  // namespace braitenlab
