#include "ui/scene_input/room.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/maths/geometry.h"
#include "core/scene/scene.h"
#include "render/view/pick.h"

namespace braitenlab {

using maths::vec2;

namespace {

constexpr float search_step = 0.1f;   // m between the places that are tried
constexpr float source_reach = 0.3f;  // m, the foot of a lamp

struct Disc {
    vec2 place;
    float reach = 0;
};

// Everything that stands in the scene.
struct Standing {
    std::vector<Disc> discs;
    std::vector<std::vector<vec2>> blocks;  // corners, counter-clockwise
};

Standing standing_in(const Snapshot& now) {
    Standing all;
    for (const VehicleView& v : now.vehicles) all.discs.push_back({{v.x, v.y}, reach_of(now, vehicle_object(v.id))});
    for (const SourceView& source : now.sources) all.discs.push_back({{source.x, source.y}, source_reach});
    for (int i = 0; i < static_cast<int>(now.scene->obstacles.size()); ++i) all.blocks.push_back(outline_of(now, i));
    return all;
}

bool touches(const std::vector<vec2>& block, vec2 place, float reach) {
    bool inside = block.size() >= 3;
    for (std::size_t i = 0; i < block.size(); ++i) {
        const vec2 a = block[i], b = block[(i + 1) % block.size()];
        if (maths::distance(maths::nearest_on_segment(place, a, b), place) < reach) return true;
        inside &= maths::cross(b - a, place - a) >= 0;
    }
    return inside;
}

bool is_free(const Standing& all, vec2 place, float reach) {
    return std::none_of(all.discs.begin(), all.discs.end(),
                        [&](const Disc& d) { return maths::distance(d.place, place) < d.reach + reach; }) &&
           std::none_of(all.blocks.begin(), all.blocks.end(),
                        [&](const auto& block) { return touches(block, place, reach); });
}

// How far the middle of something of this reach may be from the arena's: over a joined edge it may stand.
vec2 limits_for(const Arena& arena, float reach) {
    const float margin = arena.edge == Boundary::torus ? 0 : reach;
    return {std::max(0.0f, arena.width / 2 - margin), std::max(0.0f, arena.height / 2 - margin)};
}

float reach_of_body(const Body& body) { return std::hypot(body.length, body.width) / 2; }

float reach_of_kind(const Snapshot& now, int kind) {
    const auto& kinds = now.scene->kinds;
    return kind >= 0 && static_cast<std::size_t>(kind) < kinds.size()
               ? reach_of_body(kinds[static_cast<std::size_t>(kind)].body)
               : reach_of_body({});
}

// Of the circle within it: a long wall may well end at the rim.
float reach_of_shape(const Obstacle& obstacle) {
    const vec2 middle;
    const std::vector<vec2> corners = corners_of(obstacle);
    float reach = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < corners.size(); ++i)
        reach = std::min(reach, maths::distance(middle, maths::nearest_on_segment(middle, corners[i],
                                                                                  corners[(i + 1) % corners.size()])));
    return corners.empty() ? 0 : reach;
}

}  // namespace

vec2 free_place(const Snapshot& now, vec2 wanted, float reach) {
    if (!now.scene) return wanted;
    const Standing all = standing_in(now);
    const vec2 limit = limits_for(now.scene->arena, reach);
    const vec2 from{std::clamp(wanted.x, -limit.x, limit.x), std::clamp(wanted.y, -limit.y, limit.y)};
    // Rings round it, each from the side of the arena's middle on: there is most room.
    const float towards_middle = std::atan2(-from.y, -from.x), farthest = 2 * std::hypot(limit.x, limit.y);
    for (float ring = 0; ring <= farthest; ring += search_step) {
        const int places =
            ring == 0 ? 1 : static_cast<int>(std::ceil(2 * std::numbers::pi_v<float> * ring / search_step));
        for (int i = 0; i < places; ++i) {
            const float turn = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(places);
            const vec2 at = from + ring * vec2{std::cos(towards_middle + turn), std::sin(towards_middle + turn)};
            if (std::fabs(at.x) > limit.x || std::fabs(at.y) > limit.y) continue;
            if (is_free(all, at, reach)) return at;
        }
    }
    return from;
}

Command with_room(const Snapshot& now, Command command) {
    if (!now.scene) return command;
    if (auto* vehicle = std::get_if<AddVehicle>(&command); vehicle && vehicle->at) {
        const vec2 at = free_place(now, {vehicle->at->x, vehicle->at->y}, reach_of_kind(now, vehicle->kind));
        vehicle->at->x = at.x, vehicle->at->y = at.y;
    } else if (auto* source = std::get_if<AddSource>(&command)) {
        const vec2 at = free_place(now, {source->source.x, source->source.y}, source_reach);
        source->source.x = at.x, source->source.y = at.y;
    } else if (auto* obstacle = std::get_if<AddObstacle>(&command)) {
        const vec2 at =
            free_place(now, {obstacle->obstacle.x, obstacle->obstacle.y}, reach_of_shape(obstacle->obstacle));
        obstacle->obstacle.x = at.x, obstacle->obstacle.y = at.y;
    }
    return command;
}

}  // namespace braitenlab
