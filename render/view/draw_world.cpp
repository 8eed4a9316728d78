// What stands and lies in the arena: zones of the floor, walls, obstacles, sources; and what vehicles remember of it.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/maths/angle.h"
#include "render/view/sheet.h"

namespace braitenlab {

using maths::vec2;
using maths::vec4;

namespace {

constexpr std::size_t most_corners = 8;

// A block of these corners, in its own frame and anticlockwise.
BlockInstance block(vec4 place, const std::vector<vec2>& corners, float height, float chamfer, vec4 colour,
                    bool wall = false) {
    BlockInstance made{place, {}, {height, chamfer, 0, wall ? 1.0f : 0.0f}, colour};
    const std::size_t count = std::min(corners.size(), most_corners);
    for (std::size_t i = 0; i < count; ++i) {
        vec4& two = made.corners[i / 2];
        (i % 2 == 0 ? two.x : two.z) = corners[i].x;
        (i % 2 == 0 ? two.y : two.w) = corners[i].y;
    }
    made.size.z = static_cast<float>(count);
    return made;
}

std::vector<vec2> rectangle(float half_length, float half_width) {
    return {
        {-half_length, -half_width}, {half_length, -half_width}, {half_length, half_width}, {-half_length, half_width}};
}

void add_walls(Sheet& sheet, const Arena& arena) {
    if (arena.edge != Edge::wall) return;
    const float half_w = arena.width / 2, half_h = arena.height / 2;
    constexpr float thick = wall_thickness / 2, high = wall_height, chamfer = 0.035f;  // m
    const vec4 colour = rgb_with(sheet.colours.wall, 0);
    for (const float side : {-1.0f, 1.0f}) {
        sheet.list.blocks.push_back(block({0, side * (half_h + thick), 1, 0}, rectangle(half_w + 2 * thick, thick),
                                          high, chamfer, colour, true));
        sheet.list.blocks.push_back(
            block({side * (half_w + thick), 0, 0, 1}, rectangle(half_h, thick), high, chamfer, colour, true));
    }
}

void add_obstacles(Sheet& sheet, const Scene& scene) {
    for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
        const Obstacle& obstacle = scene.obstacles[i];
        const Pose pose =
            i < sheet.now.obstacles.size() ? sheet.now.obstacles[i] : Pose{obstacle.x, obstacle.y, obstacle.heading};
        const vec2 ahead = maths::direction(pose.heading);
        const bool movable = obstacle.mass > 0;
        const Colour colour =
            movable ? mix(sheet.colours.obstacle, sheet.colours.crate, 0.75f) : sheet.colours.obstacle;
        sheet.list.blocks.push_back(block({pose.x, pose.y, ahead.x, ahead.y}, corners_of(obstacle),
                                          movable ? 0.34f : 0.42f, 0.045f, rgb_with(colour, movable ? 1.0f : 0.0f)));
    }
}

void add_zone(Sheet& sheet, const Zone& zone, Pattern pattern, vec4 colour, vec2 flow = {}, float amount = 0) {
    const vec2 ahead = maths::direction(zone.heading);
    sheet.list.zones.push_back(
        {{zone.x, zone.y, ahead.x, ahead.y},
         {zone.length / 2, zone.width / 2, zone.round ? 1.0f : 0.0f, static_cast<float>(pattern)},
         colour,
         {flow.x, flow.y, amount, 0}});
}

void add_surface(Sheet& sheet, const Zone& zone) {
    const Palette& p = sheet.colours;
    switch (zone.surface) {
        case Surface::none:
            return;
        case Surface::ice:
            return add_zone(sheet, zone, Pattern::ice, rgb_with(p.ice, 0.8f));
        case Surface::carpet:
            return add_zone(sheet, zone, Pattern::carpet, rgb_with(p.carpet, 0.9f));
        case Surface::sand:
            return add_zone(sheet, zone, Pattern::sand, rgb_with(p.sand, 0.85f));
        case Surface::tape:
            return add_zone(sheet, zone, Pattern::tape, rgb_with(p.tape, 1));
    }
}

// A zone may cover the floor and push what stands on it: a layer for each of its effects.
void add_zone(Sheet& sheet, const Zone& zone) {
    const vec2 ahead = maths::direction(zone.heading);
    const vec4 ink = rgb_with(sheet.colours.second_text, 0.55f);
    add_surface(sheet, zone);
    if (zone.slope != 0) {
        const float steep = std::min(1.0f, std::fabs(zone.slope) / 0.35f);
        add_zone(sheet, zone, Pattern::slope, ink, {zone.slope > 0 ? 1.0f : -1.0f, 0}, steep);
    }
    if (const vec2 wind{zone.wind_x, zone.wind_y}; maths::length(wind) > 0) {
        constexpr float strong = 10;  // N
        const vec2 own = maths::rotate(wind / maths::length(wind), {ahead.x, -ahead.y});
        add_zone(sheet, zone, Pattern::wind, ink, own, std::min(1.0f, maths::length(wind) / strong));
    }
    if (zone.pull != 0) {
        constexpr float strong = 20;  // N
        add_zone(sheet, zone, zone.pull > 0 ? Pattern::pull : Pattern::push, ink, {},
                 std::min(1.0f, std::fabs(zone.pull) / strong));
    }
    if (zone.recharge > 0) add_zone(sheet, zone, Pattern::recharge, rgb_with(sheet.colours.recharge, 0.75f));
}

void add_post(Sheet& sheet, vec2 place) {
    std::vector<vec2> corners;
    for (std::size_t i = 0; i < most_corners; ++i)
        corners.push_back(maths::direction(maths::pi / 8 + maths::pi / 4 * static_cast<float>(i)) *
                          solid_source_radius);
    sheet.list.blocks.push_back(
        block({place.x, place.y, 1, 0}, corners, 0.26f, 0.03f, rgb_with(sheet.colours.obstacle, 0)));
}

void add_sources(Sheet& sheet) {
    for (const SourceView& source : sheet.now.sources) {
        const auto i = static_cast<std::size_t>(source.source);
        const vec2 place{source.x, source.y};
        const bool solid = sheet.now.scene && i < sheet.now.scene->sources.size() && sheet.now.scene->sources[i].solid;
        if (solid) add_post(sheet, place);
        add_source(sheet, source.channel, place, 0, source.strength, 0.8f + 0.35f * source.strength);
    }
}

// The marks of the selected vehicle stand out; the others' are faint.
void add_marks(Sheet& sheet) {
    if (!sheet.picture.overlays.memory) return;
    const bool light = sheet.picture.theme == Theme::light;
    for (const MarkView& mark : sheet.now.marks) {
        const float opacity = (mark.owner == sheet.picture.selected ? 1.0f : 0.35f) * std::sqrt(mark.strength);
        sheet.list.rings.push_back({{mark.x, mark.y, 1, 0},
                                    {0.22f, 0.22f, 0.035f, static_cast<float>(MarkKind::memory)},
                                    rgb_with(sheet.colours.memory, opacity * (light ? 1.0f : 0.9f))});
    }
}

// Coloured lamps are alike but for their colour: a ring at the foot says it too.
void add_socket(Sheet& sheet, Channel channel, vec2 at, float size) {
    const MarkKind kind = channel == Channel::red     ? MarkKind::whole_socket
                          : channel == Channel::green ? MarkKind::dashed_socket
                                                      : MarkKind::dotted_socket;
    if (channel != Channel::red && channel != Channel::green && channel != Channel::blue) return;
    const float radius = 0.34f * size;
    sheet.list.rings.push_back({{at.x, at.y, 1, 0},
                                {radius, radius, 0.022f, static_cast<float>(kind)},
                                rgb_with(mix(colour_of(sheet.colours, channel), sheet.colours.text, 0.35f), 1)});
}

}  // namespace

void add_source(Sheet& sheet, Channel channel, vec2 at, float foot, float strength, float size) {
    const bool dark = sheet.picture.theme == Theme::dark;
    const Colour colour = colour_of(sheet.colours, channel);
    const float bulb = foot + 0.52f * size;
    // A small lamp on a vehicle shines less far than one on the floor.
    const float reach = foot > 0 ? 0.5f * std::max(0.4f, sheet.crowd) : 1;
    if (!in_sight(sheet, at, 4)) return;
    sheet.list.sources[static_cast<std::size_t>(source_shape_of(channel))].push_back(
        {{at.x, at.y, size, strength}, rgb_with(colour, foot)});
    const vec4 place{at.x, at.y, 1, 0};
    const float pool = (1.6f + 2.4f * strength) * reach;
    sheet.list.marks.push_back({place,
                                {pool, pool, 0, static_cast<float>(MarkKind::pool)},
                                rgb_with(colour, (dark ? 0.42f : 0.26f) * (0.35f + 0.65f * strength))});
    if (foot == 0)
        sheet.list.marks.push_back({place,
                                    {0.22f * size, 0.22f * size, 0.12f, static_cast<float>(MarkKind::shadow)},
                                    rgb_with(sheet.colours.shadow, sheet.colours.shadow.a * 0.7f)});
    if (foot == 0) add_socket(sheet, channel, at, size);
    sheet.list.halos.push_back({{at.x, at.y, bulb, (dark ? 1.25f : 0.85f) * size},
                                rgb_with(colour, (dark ? 0.75f : 0.5f) * (0.3f + 0.7f * strength))});
    if (sheet.list.lamps.size() < most_lamps)
        sheet.list.lamps.push_back({{at.x, bulb, -at.y, strength * reach}, rgb_with(colour, 2.0f)});
}

void add_world(Sheet& sheet) {
    add_sources(sheet);
    add_marks(sheet);
    if (!sheet.now.scene) return;
    const Scene& scene = *sheet.now.scene;
    if (sheet.picture.overlays.surfaces)
        for (const Zone& zone : scene.zones) add_zone(sheet, zone);
    add_walls(sheet, scene.arena);
    add_obstacles(sheet, scene);
}

}  // namespace braitenlab
