// Edges of the arena: a torus wraps positions, walls keep vehicles inside.
#include <cmath>

#include "core/scene/arena.h"
#include "core/world/world_data.h"

namespace braitenlab::world {

using maths::vec2;

namespace {

// Wraps x into [-length / 2, length / 2).
float wrapped(float x, float length) {
    const float inside = x - length * std::floor((x + length / 2) / length);
    return inside < length / 2 ? inside : -length / 2;  // rounding can give length / 2
}

void close_the_torus(WorldData& s) {
    const Arena& arena = s.scene->arena;
    const auto home = [&](vec2 position) {
        return vec2{wrapped(position.x, arena.width), wrapped(position.y, arena.height)};
    };
    for (std::size_t row = 0; row < s.vehicles.size(); ++row) {
        vec2& position = s.vehicles.motion[row].position;
        if (is_outside(arena, position)) s.physics.set_position(row, position = home(position));
    }
    for (std::size_t i = 0; i < s.obstacles.size(); ++i) {
        const bool moves = s.scene->obstacles[i].mass > 0;
        vec2& position = s.obstacles[i].position;
        if (moves && is_outside(arena, position)) s.physics.set_obstacle_position(i, position = home(position));
    }
}

// Moves vehicles outside the walls to a position inside and stops them: vehicles that started or were moved there, and
// vehicles that others pushed through a wall.
void hold_behind_walls(WorldData& s) {
    const Arena& arena = s.scene->arena;
    for (std::size_t row = 0; row < s.vehicles.size(); ++row) {
        const mechanics::Motion& m = s.vehicles.motion[row];
        if (!is_outside(arena, m.position)) continue;
        const vec2 to = moved_inside(arena, m.position, 0.5f);
        s.physics.set_pose(row, {to.x, to.y, m.heading});
        read_motion(s, row);
    }
}

}  // namespace

bool is_outside(const Arena& arena, vec2 position) { return !is_inside(arena, position); }

void keep_inside(WorldData& s) {
    if (s.scene->arena.edge == Boundary::torus) close_the_torus(s);
    if (has_walls(s.scene->arena.edge)) hold_behind_walls(s);
}

}  // namespace braitenlab::world
