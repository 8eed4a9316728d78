#include "ui/panels/scene_picture.h"

#include <algorithm>
#include <cmath>

#include "render/view/palette.h"
#include "ui/imgui_compat.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"

namespace braitenlab::ui {

namespace {

maths::vec2 turned(maths::vec2 at, float heading) {
    const float c = std::cos(heading), s = std::sin(heading);
    return {at.x * c - at.y * s, at.x * s + at.y * c};
}

// The corners of an object with a pose, on the floor.
template <class Object>
std::vector<maths::vec2> outline_of(const Object& object, const std::vector<maths::vec2>& corners) {
    std::vector<maths::vec2> outline;
    for (const maths::vec2 corner : corners) {
        const maths::vec2 at = turned(corner, object.heading);
        outline.push_back({object.x + at.x, object.y + at.y});
    }
    return outline;
}

std::vector<maths::vec2> ellipse_of(const Zone& zone) {
    constexpr int corners = 24;
    std::vector<maths::vec2> outline;
    for (int i = 0; i < corners; ++i) {
        const float angle = 6.2831853f * static_cast<float>(i) / corners;
        outline.push_back({zone.length / 2 * std::cos(angle), zone.width / 2 * std::sin(angle)});
    }
    return outline_of(zone, outline);
}

std::vector<maths::vec2> outline_of(const Zone& zone) {
    return zone.round && zone.corners.empty() ? ellipse_of(zone) : outline_of(zone, corners_of(zone));
}

void fill_outline(const FloorMap& map, const std::vector<maths::vec2>& outline, Colour colour) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    for (const maths::vec2 at : outline) draw.PathLineTo(map(at));
    draw.PathFillConvex(paint(colour));
}

Colour colour_of_zone(const Palette& p, const Zone& zone) {
    if (zone.surface != Surface::none) return colour_of(p, zone.surface);
    return (zone.recharge > 0 ? p.recharge : p.line).with_alpha(0.5f);
}

// A disc with a ring around it, so that a lamp is one in any colour.
void draw_source(const Ui& ui, const Source& source, const FloorMap& map) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 at = map({source.x, source.y});
    const Colour colour = colour_of(ui.palette, source.channel);
    const float share = 0.5f + 0.5f * std::clamp(source.strength, 0.0f, 1.0f);
    const float glow = std::min(ui.px(9), 0.15f * map.place.h), core = std::max(ui.px(2), 0.4f * glow) * share;
    draw.AddCircleFilled(at, glow * share, paint(colour.with_alpha(0.25f)), 24);
    draw.AddCircleFilled(at, core, paint(colour), 16);
    draw.AddCircle(at, core, paint(mix(colour, ui.palette.text, 0.45f)), 16, ui.px(1));
}

float heading_of(const Scene& scene, const Start& start) {
    const int source = find_source(scene, start.facing);
    if (source < 0) return start.heading;
    const Source& faced = scene.sources[static_cast<std::size_t>(source)];
    return start.heading + std::atan2(faced.y - start.y, faced.x - start.x);
}

// A body with a point at its front, at least a few pixels long.
void draw_start(const Ui& ui, const Scene& scene, const Start& start, const FloorMap& map) {
    const int kind = find_kind(scene, start.kind);
    if (kind < 0) return;
    const Kind& k = scene.kinds[static_cast<std::size_t>(kind)];
    const std::string& own = start.colour.empty() ? k.colour : start.colour;
    const Colour colour =
        braitenlab::colour_of(std::string_view(own))
            .value_or(kind == 0 && k.role == Role::none ? ui.palette.accent : colour_of(ui.palette, k.role));
    const float length = std::max(k.body.length, ui.px(11) / map.scale), width = 0.62f * length;
    const float heading = heading_of(scene, start);
    std::vector<maths::vec2> outline;
    for (const maths::vec2 corner :
         {maths::vec2{0.5f, 0}, {0.1f, 0.5f}, {-0.5f, 0.5f}, {-0.5f, -0.5f}, {0.1f, -0.5f}}) {
        const maths::vec2 at = turned({corner.x * length, corner.y * width}, heading);
        outline.push_back({start.x + at.x, start.y + at.y});
    }
    std::reverse(outline.begin(), outline.end());  // clockwise in window coordinates
    fill_outline(map, outline, colour);
}

}  // namespace

FloorArea occupied_area(const Scene& scene) {
    constexpr float margin = 1.2f, least = 6;  // m
    std::vector<maths::vec2> points;
    for (const Start& start : scene.starts) points.push_back({start.x, start.y});
    for (const Source& source : scene.sources) points.push_back({source.x, source.y});
    for (const Obstacle& obstacle : scene.obstacles)
        for (const maths::vec2 at : outline_of(obstacle, corners_of(obstacle))) points.push_back(at);
    for (const Zone& zone : scene.zones)
        for (const maths::vec2 at : outline_of(zone)) points.push_back(at);
    const maths::vec2 half{scene.arena.width / 2, scene.arena.height / 2};
    if (points.empty()) return {{-half.x, -half.y}, half};
    FloorArea area{points.front(), points.front()};
    include(area, points);
    const auto widen = [&](float& low, float& high, float edge) {
        const float more = std::max(margin, (least - (high - low)) / 2);
        low = std::max(low - more, -edge), high = std::min(high + more, edge);
    };
    widen(area.low.x, area.high.x, half.x), widen(area.low.y, area.high.y, half.y);
    return area;
}

void include(FloorArea& area, const std::vector<maths::vec2>& points) {
    for (const maths::vec2 at : points) {
        area.low = {std::min(area.low.x, at.x), std::min(area.low.y, at.y)};
        area.high = {std::max(area.high.x, at.x), std::max(area.high.y, at.y)};
    }
}

FloorMap::FloorMap(const FloorArea& area, Rect to)
    : place(to),
      middle{(area.low.x + area.high.x) / 2, (area.low.y + area.high.y) / 2},
      scale(
          std::min(to.w / std::max(0.1f, area.high.x - area.low.x), to.h / std::max(0.1f, area.high.y - area.low.y))) {}

void draw_floor(const Ui& ui, const Scene& scene, const FloorMap& map) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const Arena& arena = scene.arena;
    const ImVec2 low = map({-arena.width / 2, arena.height / 2}), high = map({arena.width / 2, -arena.height / 2});
    const ImU32 wall = paint(ui.palette.wall), floor = paint(ui.palette.floor);
    if (arena.round) {
        Zone whole;
        whole.length = arena.width, whole.width = arena.height;
        auto outline = ellipse_of(whole);
        std::reverse(outline.begin(), outline.end());
        fill_outline(map, outline, ui.palette.floor);
        for (const maths::vec2 at : outline) draw.PathLineTo(map(at));
        draw.PathStroke(wall, ImDrawFlags_Closed, ui.px(1));
    } else {
        draw.AddRectFilled(low, high, floor);
        compat::outline(draw, low, high, wall, 0, ui.px(1.5f));
    }
    for (const Zone& zone : scene.zones) {
        auto outline = outline_of(zone);
        std::reverse(outline.begin(), outline.end());
        fill_outline(map, outline, colour_of_zone(ui.palette, zone));
    }
    for (const Obstacle& obstacle : scene.obstacles) {
        const Colour colour = obstacle.mass > 0 ? ui.palette.crate : mix(ui.palette.obstacle, ui.palette.text, 0.35f);
        auto outline = outline_of(obstacle, corners_of(obstacle));
        std::reverse(outline.begin(), outline.end());
        fill_outline(map, outline, colour);
        const float least = ui.px(2);  // a post stays visible
        const ImVec2 at = map({obstacle.x, obstacle.y});
        draw.AddRectFilled({at.x - least, at.y - least}, {at.x + least, at.y + least}, paint(colour));
    }
    for (const Source& source : scene.sources) draw_source(ui, source, map);
}

void draw_vehicles(const Ui& ui, const Scene& scene, const FloorMap& map) {
    for (const Start& start : scene.starts) draw_start(ui, scene, start, map);
}

}  // namespace braitenlab::ui
