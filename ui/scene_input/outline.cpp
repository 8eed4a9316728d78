#include "ui/scene_input/outline.h"

#include <algorithm>
#include <cmath>

#include "core/scene/fields.h"

namespace braitenlab {

using maths::vec2;

namespace {

constexpr float nearest = 0.1f;        // m between corners
constexpr float narrowest = 0.1f;      // m across
constexpr float shortest_side = 0.2f;  // m, of a box
constexpr float straight = 1e-3f;      // m^2: a corner that hardly turns is no dent

float area_of(const std::vector<vec2>& corners) {  // positive counter-clockwise
    float twice = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
        twice += maths::cross(corners[i], corners[(i + 1) % corners.size()]);
    return twice / 2;
}

bool segments_cross(vec2 a, vec2 b, vec2 c, vec2 d) {
    const auto side = [](vec2 p, vec2 q, vec2 r) { return maths::cross(q - p, r - p); };
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

bool crosses(const std::vector<vec2>& corners) {
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = i + 2; k < n; ++k)
            if ((k + 1) % n != i && segments_cross(corners[i], corners[i + 1], corners[k], corners[(k + 1) % n]))
                return true;
    return false;
}

bool dents(const std::vector<vec2>& corners) {
    const std::size_t n = corners.size();
    bool left = false, right = false;
    for (std::size_t i = 0; i < n; ++i) {
        const vec2 a = corners[i], b = corners[(i + 1) % n], c = corners[(i + 2) % n];
        const float turn = maths::cross(b - a, c - b);
        left |= turn > straight, right |= turn < -straight;
    }
    return left && right;
}

// The least distance between two parallels that hold the outline between them: one of them lies on an edge.
float width_of(const std::vector<vec2>& corners) {
    float width = 1e9f;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const vec2 a = corners[i], along = maths::normalise(corners[(i + 1) % corners.size()] - a);
        float across = 0;
        for (const vec2 p : corners) across = std::max(across, std::fabs(maths::cross(along, p - a)));
        width = std::min(width, across);
    }
    return width;
}

}  // namespace

OutlineFault fault_of_next(const std::vector<vec2>& corners, vec2 next) {
    if (corners.size() >= limits::corners) return OutlineFault::too_many;
    for (const vec2 corner : corners)
        if (maths::distance(corner, next) < nearest) return OutlineFault::too_near;
    std::vector<vec2> all = corners;
    all.push_back(next);
    if (all.size() >= 4 && crosses(all)) return OutlineFault::crosses;
    if (all.size() >= 4 && dents(all)) return OutlineFault::dents;
    return OutlineFault::none;
}

OutlineFault fault_of(const std::vector<vec2>& corners) {
    if (corners.size() < 3) return OutlineFault::too_few;
    if (corners.size() > limits::corners) return OutlineFault::too_many;
    if (crosses(corners)) return OutlineFault::crosses;
    if (dents(corners)) return OutlineFault::dents;
    return width_of(corners) < narrowest ? OutlineFault::too_narrow : OutlineFault::none;
}

Obstacle obstacle_from(const std::vector<vec2>& given) {
    std::vector<vec2> corners = given;
    if (area_of(corners) < 0) std::reverse(corners.begin(), corners.end());
    vec2 middle{};  // centroid of the area, so that a movable one turns about its centre of mass
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const vec2 a = corners[i], b = corners[(i + 1) % corners.size()];
        middle += (a + b) * (maths::cross(a, b) / (6 * area_of(corners)));
    }
    Obstacle obstacle;
    obstacle.x = middle.x, obstacle.y = middle.y;
    vec2 low = corners[0], high = corners[0];
    for (const vec2 corner : corners) {
        obstacle.corners.push_back({corner.x - middle.x, corner.y - middle.y});
        low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
        high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
    }
    obstacle.length = high.x - low.x, obstacle.width = high.y - low.y;
    return obstacle;
}

Obstacle box_between(vec2 a, vec2 b) {
    Obstacle box;
    box.x = (a.x + b.x) / 2, box.y = (a.y + b.y) / 2;
    box.length = std::max(shortest_side, std::fabs(a.x - b.x));
    box.width = std::max(shortest_side, std::fabs(a.y - b.y));
    return box;
}

}  // namespace braitenlab
