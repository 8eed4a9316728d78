#include "core/scene/arena.h"

#include <algorithm>
#include <cmath>

#include "core/maths/angle.h"

namespace braitenlab {

using maths::vec2;

namespace {

constexpr int fewest_sides = 64, most_sides = 256;
constexpr float most_gap = 0.01f;  // m, between the ellipse and the middle of a side

// The distance of a side's middle from its arc is about radius · (pi / sides)² / 2.
int side_count(const Arena& arena) {
    const float radius = std::max(arena.width, arena.height) / 2;
    const auto wanted = static_cast<int>(std::ceil(maths::pi * std::sqrt(radius / (2 * most_gap))));
    return std::clamp((wanted + 3) / 4 * 4, fewest_sides, most_sides);
}

// Smallest distance (m) of a position from the lines through the sides of the polygon; negative outside.
float distance_from_sides(const Arena& arena, vec2 position) {
    const std::vector<vec2> corners = round_corners(arena);
    float least = arena.width + arena.height;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const vec2 along = maths::normalise(corners[(i + 1) % corners.size()] - corners[i]);
        least = std::min(least, maths::cross(along, position - corners[i]));
    }
    return least;
}

bool is_inside_ellipse(const Arena& arena, vec2 position, float margin) {
    const vec2 part{2 * position.x / arena.width, 2 * position.y / arena.height};
    const float squared = maths::dot(part, part);
    if (margin <= 0) return squared <= 1;
    // The distance from the edge of a point on the ellipse scaled by s is at least (1 − s) times the shorter half axis.
    const float scale = 1 - 2 * margin / std::min(arena.width, arena.height);
    if (scale < 0 || squared > 1) return false;
    return squared <= scale * scale || distance_from_sides(arena, position) >= margin;
}

vec2 moved_into_ellipse(const Arena& arena, vec2 position, float margin) {
    if (is_inside_ellipse(arena, position, margin)) return position;
    float inside = 0, outside = 1;  // parts of the way from the middle to the position
    constexpr int halvings = 24;
    for (int i = 0; i < halvings; ++i) {
        const float half = (inside + outside) / 2;
        (is_inside_ellipse(arena, position * half, margin) ? inside : outside) = half;
    }
    return position * inside;
}

}  // namespace

bool is_inside(const Arena& arena, vec2 position, float margin) {
    if (arena.round) return is_inside_ellipse(arena, position, margin);
    const float x = arena.width / 2 - margin, y = arena.height / 2 - margin;
    return !(std::fabs(position.x) > x || std::fabs(position.y) > y);
}

vec2 moved_inside(const Arena& arena, vec2 position, float margin) {
    if (arena.round) return moved_into_ellipse(arena, position, margin);
    const float x = std::max(arena.width / 2 - margin, 0.0f), y = std::max(arena.height / 2 - margin, 0.0f);
    return {std::clamp(position.x, -x, x), std::clamp(position.y, -y, y)};
}

std::vector<vec2> round_corners(const Arena& arena) {
    const int count = side_count(arena);
    std::vector<vec2> corners;
    corners.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const vec2 on_circle = maths::direction(2 * maths::pi * static_cast<float>(i) / static_cast<float>(count));
        corners.push_back({on_circle.x * arena.width / 2, on_circle.y * arena.height / 2});
    }
    return corners;
}

std::vector<WallBox> round_wall(const Arena& arena, float thickness) {
    const std::vector<vec2> corners = round_corners(arena);
    std::vector<WallBox> boxes;
    boxes.reserve(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const vec2 from = corners[i], side = corners[(i + 1) % corners.size()] - from;
        const vec2 along = maths::normalise(side), outwards{along.y, -along.x};
        boxes.push_back({from + side / 2 + outwards * (thickness / 2), maths::arctangent2(along.y, along.x),
                         maths::length(side) + 2 * thickness});
    }
    return boxes;
}

}  // namespace braitenlab
