// Zones, walls, obstacles, sources and memory marks.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/maths/angle.h"
#include "core/scene/arena.h"
#include "core/sensing/seam.h"
#include "render/view/drawing.h"

namespace braitenlab::render {

using maths::vec2;
using maths::vec4;

namespace {

constexpr std::size_t most_corners = 8;
constexpr float rounding = 0.09f;  // m, of the vertical edges of obstacles, in an arena of full scale

// Up to most_corners corners, two in each element.
std::array<vec4, 4> packed(const std::vector<vec2>& corners) {
    std::array<vec4, 4> pairs{};
    for (std::size_t i = 0; i < std::min(corners.size(), most_corners); ++i) {
        vec4& two = pairs[i / 2];
        (i % 2 == 0 ? two.x : two.z) = corners[i].x;
        (i % 2 == 0 ? two.y : two.w) = corners[i].y;
    }
    return pairs;
}

// A prism with these corners, in its own frame, counter-clockwise.
BlockInstance block(vec4 place, const std::vector<vec2>& corners, float height, float radius, vec4 colour,
                    bool wall = false) {
    const auto count = static_cast<float>(std::min(corners.size(), most_corners));
    return {place, packed(corners), {height, radius, count, wall ? 1.0f : 0.0f}, colour};
}

std::vector<vec2> rectangle(float half_length, float half_width) {
    return {
        {-half_length, -half_width}, {half_length, -half_width}, {half_length, half_width}, {-half_length, half_width}};
}

void add_walls(Drawing& drawing, const Arena& arena) {
    if (!has_walls(arena.edge)) return;
    const float half_w = arena.width / 2, half_h = arena.height / 2;
    const WallSize wall = wall_of(arena);
    const float thick = wall.thickness / 2, high = wall.height * (arena.edge == Boundary::rim ? 0.3f : 1),
                radius = 0.9f * thick;  // m; the rim is a round bar
    const vec4 colour = rgb_with(drawing.colours.rim, 0);
    if (arena.round) {
        for (const WallBox& box : round_wall(arena, wall.thickness)) {
            const vec2 ahead = maths::direction(box.heading);
            drawing.list.blocks.push_back(block({box.middle.x, box.middle.y, ahead.x, ahead.y},
                                                rectangle(box.length / 2, thick), high, radius, colour, true));
        }
        return;
    }
    for (const float side : {-1.0f, 1.0f}) {
        drawing.list.blocks.push_back(block({0, side * (half_h + thick), 1, 0}, rectangle(half_w + 2 * thick, thick),
                                            high, radius, colour, true));
        drawing.list.blocks.push_back(
            block({side * (half_w + thick), 0, 0, 1}, rectangle(half_h + thick, thick), high, radius, colour, true));
    }
}

// Two corners in place of each; the shader shades the short face between them as a rounded edge.
std::vector<vec2> blunted(const std::vector<vec2>& corners, float scale) {
    if (2 * corners.size() > most_corners) return corners;
    std::vector<vec2> both;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const vec2 here = corners[i];
        for (const vec2 next : {corners[(i + corners.size() - 1) % corners.size()], corners[(i + 1) % corners.size()]})
            both.push_back(here +
                           maths::normalise(next - here) * std::min(scale * rounding, maths::distance(next, here) / 3));
    }
    return both;
}

void add_obstacle_casts(Drawing& drawing, vec2 place, vec2 ahead, const std::vector<vec2>& corners, float height) {
    vec2 low{1e9f, 1e9f}, high{-1e9f, -1e9f};
    for (const vec2 c : corners) {
        low = {std::min(low.x, c.x), std::min(low.y, c.y)};
        high = {std::max(high.x, c.x), std::max(high.y, c.y)};
    }
    // The shadow is that of a box: of other outlines, of a box that does not stand out of them.
    const float inside = corners.size() == 4 ? 1.0f : 0.7f;
    add_casts(drawing, place + maths::rotate((low + high) / 2, ahead), ahead, (high - low) * (inside / 2), height);
}

void add_obstacles(Drawing& drawing, const Scene& scene) {
    const bool plain = drawing.picture.quality == Quality::low;
    for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
        const Obstacle& obstacle = scene.obstacles[i];
        const Pose pose = i < drawing.now.obstacles.size() ? drawing.now.obstacles[i]
                                                           : Pose{obstacle.x, obstacle.y, obstacle.heading};
        const vec2 ahead = maths::direction(pose.heading);
        const bool movable = obstacle.mass > 0;
        const Colour colour =
            movable ? mix(drawing.colours.solid, drawing.colours.crate, 0.75f) : drawing.colours.solid;
        const std::vector<vec2> corners = corners_of(obstacle);
        const float height = obstacle_height(scene.arena) * (movable ? 0.8f : 1.0f);
        drawing.list.blocks.push_back(block({pose.x, pose.y, ahead.x, ahead.y}, blunted(corners, scale_of(scene.arena)),
                                            height, 0.26f * height, rgb_with(colour, movable ? 1.0f : 0.0f)));
        if (!plain) add_obstacle_casts(drawing, {pose.x, pose.y}, ahead, corners, height);
    }
}

void add_zone(Drawing& drawing, const Zone& zone, Pattern pattern, vec4 colour, vec2 flow = {}, float amount = 0) {
    const vec2 ahead = maths::direction(zone.heading);
    vec2 half{zone.length / 2, zone.width / 2};
    float form = zone.round ? 1.0f : 0.0f;
    std::array<vec4, 4> corners{};
    if (!zone.corners.empty()) {
        const std::vector<vec2> own = corners_of(zone);
        half = {};
        for (const vec2 corner : own)
            half = {std::max(half.x, std::fabs(corner.x)), std::max(half.y, std::fabs(corner.y))};
        form = static_cast<float>(own.size());
        corners = packed(own);
    }
    drawing.list.zones.push_back({{zone.x, zone.y, ahead.x, ahead.y},
                                  {half.x, half.y, form, static_cast<float>(pattern)},
                                  colour,
                                  {flow.x, flow.y, amount, 0},
                                  corners});
}

void add_surface(Drawing& drawing, const Zone& zone) {
    const Palette& p = drawing.colours;
    switch (zone.surface) {
        case Surface::none:
            return;
        case Surface::ice:
            return add_zone(drawing, zone, Pattern::ice, rgb_with(p.ice, 0.8f));
        case Surface::carpet:
            return add_zone(drawing, zone, Pattern::carpet, rgb_with(p.carpet, 0.9f));
        case Surface::sand:
            return add_zone(drawing, zone, Pattern::sand, rgb_with(p.sand, 0.85f));
        case Surface::tape:
            return add_zone(drawing, zone, Pattern::tape, rgb_with(p.tape, 1));
    }
}

// One layer for the surface and one for each effect.
void add_zone(Drawing& drawing, const Zone& zone) {
    const vec2 ahead = maths::direction(zone.heading);
    const vec4 ink = rgb_with(drawing.colours.second_text, 0.55f);
    add_surface(drawing, zone);
    if (zone.slope != 0) {
        const float steep = std::min(1.0f, std::fabs(zone.slope) / 0.35f);
        add_zone(drawing, zone, Pattern::slope, ink, {zone.slope > 0 ? 1.0f : -1.0f, 0}, steep);
    }
    if (const vec2 wind{zone.wind_x, zone.wind_y}; maths::length(wind) > 0) {
        constexpr float strong = 10;  // N
        const vec2 own = maths::rotate(wind / maths::length(wind), {ahead.x, -ahead.y});
        add_zone(drawing, zone, Pattern::wind, ink, own, std::min(1.0f, maths::length(wind) / strong));
    }
    if (zone.pull != 0) {
        constexpr float strong = 20;  // N
        add_zone(drawing, zone, zone.pull > 0 ? Pattern::pull : Pattern::push, ink, {},
                 std::min(1.0f, std::fabs(zone.pull) / strong));
    }
    if (zone.recharge > 0) add_zone(drawing, zone, Pattern::recharge, rgb_with(drawing.colours.recharge, 0.75f));
}

void add_post(Drawing& drawing, vec2 place, float scale) {
    std::vector<vec2> corners;
    for (std::size_t i = 0; i < most_corners; ++i)
        corners.push_back(maths::direction(maths::pi / 8 + maths::pi / 4 * static_cast<float>(i)) *
                          (scale * solid_source_radius));
    // Nearly as dark as the foot of a lamp.
    const Colour colour = mix(drawing.colours.obstacle, drawing.colours.wheel, 0.75f);
    drawing.list.blocks.push_back(
        block({place.x, place.y, 1, 0}, corners, 0.26f * scale, 0.03f * scale, rgb_with(colour, 0)));
}

void add_sources(Drawing& drawing) {
    const float scale = drawing.scale;
    for (const SourceView& source : drawing.now.sources) {
        const auto i = static_cast<std::size_t>(source.source);
        const vec2 place{source.x, source.y};
        const bool solid =
            drawing.now.scene && i < drawing.now.scene->sources.size() && drawing.now.scene->sources[i].solid;
        if (solid) add_post(drawing, place, scale);
        add_source(drawing, source.channel, place, 0, source.strength, scale * (0.8f + 0.35f * source.strength));
    }
}

// Marks of the selected vehicle are opaque, others faint.
void add_marks(Drawing& drawing) {
    if (!drawing.picture.settings.overlays.memory) return;
    const bool light = is_light(drawing);
    for (const MarkView& mark : drawing.now.marks) {
        const float opacity =
            (mark.owner == drawing.picture.settings.selection.vehicle ? 1.0f : 0.35f) * std::sqrt(mark.strength);
        drawing.list.rings.push_back({{mark.x, mark.y, 1, 0},
                                      {0.22f * drawing.scale, 0.22f * drawing.scale, 0.035f * drawing.scale,
                                       static_cast<float>(MarkKind::memory)},
                                      rgb_with(drawing.colours.memory, opacity * (light ? 1.0f : 0.9f))});
    }
}

// A ring at the foot of a red, green or blue source; its dashes tell the colours apart.
void add_socket(Drawing& drawing, Channel channel, vec2 at, float size) {
    const MarkKind kind = channel == Channel::red     ? MarkKind::whole_socket
                          : channel == Channel::green ? MarkKind::dashed_socket
                                                      : MarkKind::dotted_socket;
    if (channel != Channel::red && channel != Channel::green && channel != Channel::blue) return;
    const float radius = 0.34f * size;
    drawing.list.rings.push_back({{at.x, at.y, 1, 0},
                                  {radius, radius, 0.022f * drawing.scale, static_cast<float>(kind)},
                                  rgb_with(mix(colour_of(drawing.colours, channel), drawing.colours.text, 0.35f), 1)});
}

constexpr std::size_t most_at_low = 3;  // lamps
constexpr float bulb_radius = 0.21f;    // m, of a source of size 1, as add_bulb() in fine_shapes.cpp has it

}  // namespace

void add_source(Drawing& drawing, Channel channel, vec2 at, float foot, float strength, float size) {
    const bool dark = drawing.picture.theme == Theme::dark;
    const bool on = strength > 0;
    const Colour unlit = mix(drawing.colours.obstacle, colour_of(drawing.colours, channel), 0.2f);
    const Colour colour = on ? colour_of(drawing.colours, channel) : unlit;
    const float bulb = foot + 0.41f * size;
    // A source on a vehicle lights a smaller area than one on the floor.
    const float reach = foot > 0 ? 0.5f * std::max(0.4f, drawing.crowd) : 1;
    if (!in_sight(drawing, at, 4)) return;
    drawing.list.sources[static_cast<std::size_t>(source_shape_of(channel))].push_back(
        {{at.x, at.y, size, strength}, rgb_with(colour, foot)});
    const vec4 place{at.x, at.y, 1, 0};
    // At low quality the floor has the light of few lamps, so that its colour is that of the other levels.
    const bool affordable = drawing.picture.quality != Quality::low || drawing.now.sources.size() <= most_at_low;
    const bool in_floor = on && affordable && foot == 0 && drawing.list.lamps.size() < most_lamps;
    if (on && !in_floor) {
        const float pool = (1.6f + 2.4f * strength) * reach * drawing.scale;
        drawing.list.marks.push_back({place,
                                      {pool, pool, 0, static_cast<float>(MarkKind::pool)},
                                      rgb_with(colour, (dark ? 0.42f : 0.26f) * (0.35f + 0.65f * strength))});
    }
    if (in_floor) ++drawing.list.floor_lamps;
    if (foot == 0)
        drawing.list.marks.push_back({place,
                                      {0.22f * size, 0.22f * size, 0.12f * size, static_cast<float>(MarkKind::shadow)},
                                      rgb_with(drawing.colours.shadow, drawing.colours.shadow.a * 0.7f)});
    if (foot == 0) add_socket(drawing, channel, at, size);
    if (!on) return;
    const float reach_of_glow = dark ? 1.25f : 0.85f;
    drawing.list.halos.push_back({{at.x, at.y, bulb, reach_of_glow * size},
                                  rgb_with(colour, (dark ? 0.45f : 0.42f) * (0.3f + 0.7f * strength)),
                                  {bulb_radius / reach_of_glow, source_shape_of(channel) == 0 ? 1.0f : 0.0f, 0, 0}});
    if (drawing.list.lamps.size() < most_lamps)
        drawing.list.lamps.push_back({{at.x, bulb, -at.y, strength * reach}, rgb_with(colour, 2.0f)});
}

void add_casts(Drawing& drawing, vec2 place, vec2 ahead, vec2 half, float height) {
    constexpr std::size_t most = 160;
    constexpr float faint = 0.02f;  // of a lamp's light at full strength
    if (drawing.picture.quality == Quality::low) return;
    const LightLaw& law = drawing.list.law;
    for (int i = 0; i < drawing.list.floor_lamps && drawing.list.casts.size() < most; ++i) {
        const Lamp& lamp = drawing.list.lamps[static_cast<std::size_t>(i)];
        const vec2 at{lamp.place.x, -lamp.place.z};
        const float d = maths::distance(at, place), rest = 1 - d * d / (law.range * law.range);
        const float near = d / law.half_distance;
        if (rest <= 0 || lamp.place.w * rest * rest / (1 + near * near) < faint) continue;
        drawing.list.casts.push_back({{place.x, place.y, ahead.x, ahead.y},
                                      {half.x, half.y, height, static_cast<float>(i)},
                                      {at.x, at.y, 1, lamp.place.w}});
    }
}

namespace {

// In a torus, what reaches over an edge is repeated at the opposite one.
void add_zones(Drawing& drawing, const Scene& scene) {
    const sensing::Seam seam(scene.arena);
    for (Zone zone : scene.zones) {
        float reach = std::hypot(zone.length, zone.width) / 2;
        for (const vec2 corner : corners_of(zone)) reach = std::max(reach, maths::length(corner));
        for (const vec2 middle : seam.images_of({zone.x, zone.y}, {reach, reach})) {
            zone.x = middle.x, zone.y = middle.y;
            add_zone(drawing, zone);
        }
    }
}

}  // namespace

void add_world(Drawing& drawing) {
    add_sources(drawing);
    add_marks(drawing);
    if (!drawing.now.scene) return;
    const Scene& scene = *drawing.now.scene;
    if (drawing.picture.settings.overlays.surfaces) add_zones(drawing, scene);
    add_walls(drawing, scene.arena);
    add_obstacles(drawing, scene);
    drawing.obstacle_casts = drawing.list.casts.size();
}

}  // namespace braitenlab::render
