#include "app/reports/floor_drawing.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/maths/angle.h"
#include "core/xml_text.h"

namespace braitenlab {

namespace {

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

}  // namespace

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
                        xml_text(source.name));
    }
    return out;
}

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

}  // namespace braitenlab
