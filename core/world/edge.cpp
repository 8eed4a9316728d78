// The rim of the arena: a torus closes upon itself, and walls hold whatever happens.
#include <algorithm>
#include <cmath>

#include "core/world/state.h"

namespace braitenlab {

using maths::vec2;

namespace {

// Into the half-open stretch of this length about 0.
float wrapped(float x, float length) {
    const float inside = x - length * std::floor((x + length / 2) / length);
    return inside < length / 2 ? inside : -length / 2;  // rounding may end on the far rim
}

void close_the_torus(WorldState& s) {
    const Arena& arena = s.scene->arena;
    const auto home = [&](vec2 place) { return vec2{wrapped(place.x, arena.width), wrapped(place.y, arena.height)}; };
    for (std::size_t row = 0; row < s.vehicles.size(); ++row) {
        vec2& place = s.vehicles.motion[row].place;
        if (is_outside(arena, place)) s.physics.shift(row, place = home(place));
    }
    for (std::size_t i = 0; i < s.obstacles.size(); ++i) {
        const bool moves = s.scene->obstacles[i].mass > 0;
        vec2& place = s.obstacles[i].place;
        if (moves && is_outside(arena, place)) s.physics.shift_obstacle(i, place = home(place));
    }
}

// Who started or was put outside, or was pressed through a wall by a crowd, stands inside again.
void hold_behind_walls(WorldState& s) {
    const Arena& arena = s.scene->arena;
    const float x = std::max(arena.width / 2 - 0.5f, 0.0f), y = std::max(arena.height / 2 - 0.5f, 0.0f);
    for (std::size_t row = 0; row < s.vehicles.size(); ++row) {
        const Motion& m = s.vehicles.motion[row];
        if (!is_outside(arena, m.place)) continue;
        s.physics.place(row, {std::clamp(m.place.x, -x, x), std::clamp(m.place.y, -y, y), m.heading});
        read_motion(s, row);
    }
}

}  // namespace

bool is_outside(const Arena& arena, vec2 place) {
    return std::fabs(place.x) > arena.width / 2 || std::fabs(place.y) > arena.height / 2;
}

void keep_inside(WorldState& s) {
    if (s.scene->arena.edge == Edge::torus) close_the_torus(s);
    if (s.scene->arena.edge == Edge::wall) hold_behind_walls(s);
}

}  // namespace braitenlab
