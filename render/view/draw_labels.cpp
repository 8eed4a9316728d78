// Labels of the scene.
#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/scene/arena.h"
#include "core/sensing/intensity.h"
#include "render/view/drawing.h"
#include "render/view/label_space.h"
#include "render/view/pick.h"

namespace braitenlab::render {

using maths::vec2;

namespace {

enum Rank { rank_chosen, rank_vehicle, rank_source, rank_zone, rank_level, rank_metres };

constexpr float clear_of_wall = 9;  // layout pixels

// The word of the language, else the name of the file with spaces.
std::string in_words(const Picture& picture, std::string name) {
    if (picture.names)
        if (const auto known = picture.names->find(name); known != picture.names->end()) return known->second;
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

std::string in_metres(int n, std::string_view unit) {
    return (n < 0 ? "−" : "") + std::to_string(std::abs(n)) + std::string(unit);
}

// False for low elevations, where labels along the boundary would overlap the walls.
bool looks_down(const CameraView& camera_view) { return camera_view.view[1][2] > 0.5f; }

void add_metres(Drawing& drawing, const Arena& arena) {
    if (!looks_down(drawing.picture.camera_view)) return;
    const CameraView& camera_view = drawing.picture.camera_view;
    const bool walled = has_walls(arena.edge);
    const WallSize wall = wall_of(arena);
    const Colour quiet = drawing.colours.second_text.with_alpha(0.75f);
    // The grid's bright lines: every 5 m, in a small arena every 50 cm.
    const bool small = drawing.scale < 1;
    const float between = 5 * grid_share(arena);
    const auto along = [&](float length, auto place_of) {
        const int most = static_cast<int>(length / 2 / between);
        if (most == 0) return;  // a lone 0 tells nothing
        for (int i = -most; i <= most; ++i) {
            const int n = i * (small ? 50 : 5);
            const auto [place, outwards] = place_of(static_cast<float>(i) * between);
            // Outside the wall, at its foot or its top, whichever is farther out in the picture.
            const vec2 edge = place + outwards * (walled ? wall.thickness : 0.0f);
            const auto foot = project(camera_view, edge),
                       beyond = project(camera_view, edge + outwards * (0.5f * drawing.scale));
            const auto top = project(camera_view, edge, wall.height);
            if (!foot || !beyond || !top) continue;
            const vec2 away = maths::normalise(*beyond - *foot);
            const bool leans_out = walled && maths::dot(*top - *foot, away) > 0;
            drawing.list.labels.push_back({.place = edge,
                                           .height = leans_out ? wall.height : 0,
                                           .offset = away * clear_of_wall,
                                           .text = in_metres(n, i != most ? ""
                                                                : small   ? " cm"
                                                                          : " m"),
                                           .colour = quiet,
                                           .rank = rank_metres,
                                           .away = away});
        }
    };
    along(arena.width, [&](float n) { return std::pair{vec2{n, -arena.height / 2}, vec2{0, -1}}; });
    along(arena.height, [&](float n) { return std::pair{vec2{-arena.width / 2, n}, vec2{-1, 0}}; });
}

// Above, beside and below a rectangle of the picture that is around a place at this height.
std::vector<LabelSpot> spots_around(const Drawing& drawing, const Rect& thing, float height) {
    constexpr float line = 6, letter = 5;  // layout pixels between a text and the rectangle
    const float half_w = thing.w / (2 * drawing.picture.pixel_scale),
                half_h = thing.h / (2 * drawing.picture.pixel_scale);
    return {{height, {0, -half_h - line}, {0, -1}},
            {height, {half_w + letter, 0}, {1, 0}},
            {height, {-half_w - letter, 0}, {-1, 0}},
            {height, {0, half_h + line}, {0, 1}}};
}

// Below the source; elsewhere while something else is below it.
void add_source_names(Drawing& drawing, const Scene& scene) {
    constexpr vec2 below{0, 16};                 // layout pixels
    if (drawing.now.sources.size() < 2) return;  // a single source has no label
    const CameraView& camera_view = drawing.picture.camera_view;
    for (const SourceView& source : drawing.now.sources) {
        const auto i = static_cast<std::size_t>(source.source);
        if (i >= scene.sources.size()) continue;
        const vec2 place{source.x, source.y};
        std::vector<LabelSpot> spots =
            spots_around(drawing, picture_of(drawing.now, camera_view, source), bulb_height * drawing.scale);
        std::rotate(spots.begin(), spots.end() - 1, spots.end());
        drawing.list.labels.push_back({.place = place,
                                       .offset = below,
                                       .text = in_words(drawing.picture, scene.sources[i].name),
                                       .colour = drawing.colours.text,
                                       .rank = rank_source,
                                       .elsewhere = std::move(spots)});
    }
}

// True for a zone that is tape and has no other effect. A line on the floor is made of many of them.
bool is_only_tape(const Zone& zone) {
    return zone.surface == Surface::tape && zone.recharge == 0 && zone.wind_x == 0 && zone.wind_y == 0 &&
           zone.slope == 0 && zone.pull == 0;
}

void add_zone_names(Drawing& drawing, const Scene& scene) {
    if (!drawing.picture.settings.overlays.surfaces) return;
    for (const Zone& zone : scene.zones) {
        if (is_only_tape(zone)) continue;
        drawing.list.labels.push_back({.place = {zone.x, zone.y},
                                       .text = in_words(drawing.picture, zone.name),
                                       .colour = drawing.colours.text.with_alpha(0.9f),
                                       .rank = rank_zone,
                                       .elsewhere = {{0, {0, 20}}, {0, {0, -20}}, {0, {0, 40}}, {0, {0, -40}}}});
    }
}

// Up to `few` vehicles all have their number; of more only the selected and the hovered one.
void add_numbers(Drawing& drawing) {
    constexpr std::size_t few = 12;
    if (drawing.now.vehicles.size() == 1) return;
    constexpr float least_pixels = 16;  // layout pixels; the number would hide a smaller vehicle
    for (const VehicleView& v : drawing.now.vehicles) {
        const bool chosen = v.id == drawing.picture.settings.selection.vehicle || v.id == drawing.picture.hovered;
        if (v.id == drawing.picture.driver || (!chosen && drawing.now.vehicles.size() > few)) continue;
        const float pixels = pixels_per_metre(drawing.picture.camera_view, {v.x, v.y}) / drawing.picture.pixel_scale;
        if (!chosen && pixels < least_pixels) continue;
        const Rect body = picture_of(drawing.now, drawing.picture.camera_view, v);
        std::vector<LabelSpot> spots = spots_around(drawing, body, vehicle_middle * drawing.scale);
        const LabelSpot first = spots.front();
        spots.erase(spots.begin());
        drawing.list.labels.push_back({.place = {v.x, v.y},
                                       .height = first.height,
                                       .offset = first.offset,
                                       .text = std::to_string(v.id + 1),
                                       .colour = chosen ? drawing.colours.text : drawing.colours.second_text,
                                       .rank = chosen ? rank_chosen : rank_vehicle,
                                       .away = first.away,
                                       .elsewhere = std::move(spots)});
    }
}

}  // namespace

void add_labels(Drawing& drawing) {
    if (!drawing.picture.settings.overlays.labels || !drawing.now.scene) return;
    drawing.list.label_space.keep_free(drawing.now, drawing.picture.camera_view);
    add_numbers(drawing);
    add_source_names(drawing, *drawing.now.scene);
    add_zone_names(drawing, *drawing.now.scene);
    add_metres(drawing, drawing.now.scene->arena);
}

void add_level_labels(DrawList& list, const sensing::Intensity& grid, const Arena& arena, Colour colour,
                      char decimal_mark) {
    if (grid.columns < 2) return;
    const auto peak = std::max_element(grid.values.begin(), grid.values.end()) - grid.values.begin();
    const int row = static_cast<int>(peak) / grid.columns, first = static_cast<int>(peak) % grid.columns;
    const auto value = [&](int column) { return grid.values[static_cast<std::size_t>(row * grid.columns + column)]; };
    // Along the row of the maximum, towards the farther side.
    const int way = first > grid.columns / 2 ? -1 : 1;
    for (int column = first; column + way >= 0 && column + way < grid.columns; column += way) {
        const float here = value(column), next = value(column + way);
        const float level = 0.2f * std::ceil(next / 0.2f);  // the highest of 0.2, 0.4 … between the two
        if (!(here >= level && level > next) || level < 0.19f) continue;
        const float t = static_cast<float>(column) + static_cast<float>(way) * (here - level) / (here - next);
        const vec2 place{(t / static_cast<float>(grid.columns - 1) - 0.5f) * arena.width,
                         (static_cast<float>(row) / static_cast<float>(grid.rows - 1) - 0.5f) * arena.height};
        if (!is_inside(arena, place)) break;
        const auto tenths = static_cast<int>(std::lround(level * 10));
        const std::string words = std::to_string(tenths / 10) + decimal_mark + std::to_string(tenths % 10);
        list.labels.push_back({place, 0, {}, words, colour, rank_level});
    }
}

}  // namespace braitenlab::render
