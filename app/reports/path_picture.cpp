#include "app/reports/path_picture.h"

#include <fmt/format.h>

#include "app/reports/floor_drawing.h"
#include "core/xml_text.h"

namespace braitenlab {

namespace {

constexpr const char* good_colour = "#0b6e4f";
constexpr const char* bad_colour = "#b3261e";

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
        xml_text(label), map.width, map.height, map.width, map.height, map.width - 1, map.height - 1);
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
