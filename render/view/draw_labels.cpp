// Labels of the scene.
#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "core/scene/arena.h"
#include "core/sensing/intensity.h"
#include "render/view/drawing.h"
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
    const bool walled = arena.edge == Boundary::wall;
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

// True if the text, centred at this offset (layout pixels) from a place at this height (m), would be over a vehicle.
bool covers_vehicle(const Drawing& drawing, vec2 place, float height, vec2 offset, const std::string& text) {
    constexpr std::size_t many = 200;                      // in a crowd every place is covered
    constexpr float half_letter = 4.5f, half_line = 9.0f;  // layout pixels, approximately
    const auto at = project(drawing.picture.camera_view, place, height);
    if (!at || drawing.now.vehicles.size() > many) return false;
    const float scale = drawing.picture.pixel_scale;
    const vec2 middle = *at + offset * scale;
    const vec2 half{half_letter * static_cast<float>(text.size()) * scale, half_line * scale};
    return std::any_of(drawing.now.vehicles.begin(), drawing.now.vehicles.end(), [&](const VehicleView& vehicle) {
        const auto body = project(drawing.picture.camera_view, {vehicle.x, vehicle.y});
        const float reach = reach_of(drawing.now, vehicle_object(vehicle.id)) *
                            pixels_per_metre(drawing.picture.camera_view, {vehicle.x, vehicle.y});
        return body && std::fabs(body->x - middle.x) < half.x + reach && std::fabs(body->y - middle.y) < half.y + reach;
    });
}

// Below the source; above it while a vehicle is below it.
void add_source_names(Drawing& drawing, const Scene& scene) {
    constexpr vec2 below{0, 16}, above{0, -18};  // layout pixels
    if (drawing.now.sources.size() < 2) return;  // a single source has no label
    const float bulb = bulb_height * drawing.scale;
    for (const SourceView& source : drawing.now.sources) {
        const auto i = static_cast<std::size_t>(source.source);
        if (i >= scene.sources.size()) continue;
        const std::string name = in_words(drawing.picture, scene.sources[i].name);
        const vec2 place{source.x, source.y};
        const bool moves_up =
            covers_vehicle(drawing, place, 0, below, name) && !covers_vehicle(drawing, place, bulb, above, name);
        drawing.list.labels.push_back(
            {place, moves_up ? bulb : 0, moves_up ? above : below, name, drawing.colours.text, rank_source});
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
        drawing.list.labels.push_back({{zone.x, zone.y},
                                       0,
                                       {},
                                       in_words(drawing.picture, zone.name),
                                       drawing.colours.text.with_alpha(0.9f),
                                       rank_zone});
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
        drawing.list.labels.push_back({{v.x, v.y},
                                       0.45f * drawing.scale,
                                       {0, -std::min(0.45f * pixels, 24.0f) - 10},
                                       std::to_string(v.id + 1),
                                       chosen ? drawing.colours.text : drawing.colours.second_text,
                                       chosen ? rank_chosen : rank_vehicle});
    }
}

}  // namespace

void add_labels(Drawing& drawing) {
    if (!drawing.picture.settings.overlays.labels || !drawing.now.scene) return;
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
