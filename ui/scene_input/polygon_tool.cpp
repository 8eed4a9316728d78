#include "ui/scene_input/polygon_tool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/enum_table.h"
#include "core/maths/angle.h"
#include "core/scene/schema.h"
#include "ui/scene_input/under_pointer.h"

namespace braitenlab::ui {

using maths::vec2;

namespace {

constexpr float corner_grip = 11;  // layout pixels around the first corner: a click there closes the outline
constexpr float least_corner_distance = 0.1f;  // m
constexpr double outline_refusal_seconds = 3;

// In the order of OutlineFault.
constexpr std::array<std::string_view, 7> outline_refusals{"",
                                                           "scene_input.refused.too_near",
                                                           "scene_input.refused.crosses",
                                                           "scene_input.refused.dents",
                                                           "scene_input.refused.too_many",
                                                           "scene_input.refused.too_few",
                                                           "scene_input.refused.too_narrow"};
static_assert(has_enumerators<OutlineFault, outline_refusals.size()>());

void show_refusal(SceneInputState& state, double wall_seconds, std::string_view key) {
    state.refusal = {std::string(key), wall_seconds + outline_refusal_seconds};
}

void add_corner(SceneInputState& state, const LabView& view, vec2 at) {
    if (const OutlineFault fault = fault_of_next(state.corners, at); fault != OutlineFault::none)
        return show_refusal(state, view.wall_seconds, refusal_of(fault));
    state.corners.push_back(at);
}

constexpr float least_outline_width = 0.1f;  // m
constexpr float shortest_side = 0.2f;        // m, of a box
constexpr float least_turn = 1e-3f;          // m²: a smaller turn of a corner is not a dent

float signed_area(const std::vector<vec2>& corners) {  // positive counter-clockwise
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
        left |= turn > least_turn, right |= turn < -least_turn;
    }
    return left && right;
}

// The smallest distance between two parallel lines with the outline between them; one of them contains an edge.
float outline_width(const std::vector<vec2>& corners) {
    float width = 1e9f;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const vec2 a = corners[i], along = maths::normalise(corners[(i + 1) % corners.size()] - a);
        float across = 0;
        for (const vec2 p : corners) across = std::max(across, std::fabs(maths::cross(along, p - a)));
        width = std::min(width, across);
    }
    return width;
}

template <class Shape>
Shape with_corners_of(Shape shape, const Obstacle& outline) {
    shape.x = outline.x, shape.y = outline.y;
    shape.length = outline.length, shape.width = outline.width;
    shape.corners.clear();
    const vec2 ahead = maths::direction(shape.heading);  // kept: the slope of a zone falls along it
    for (const vec2 corner : corners_of(outline)) {
        const vec2 own = maths::rotate(corner, {ahead.x, -ahead.y});
        shape.corners.push_back({own.x, own.y});
    }
    return shape;
}

}  // namespace

std::string_view refusal_of(OutlineFault fault) { return outline_refusals[static_cast<std::size_t>(fault)]; }

void click_corner(SceneInputState& state, const SceneInputFrame& frame, vec2 at, Outbox& outbox) {
    const SceneInputPointer& pointer = frame.pointer;
    const bool on_first = state.corners.size() >= 3 &&
                          pixels_from(frame, state.corners[0]) <= corner_grip * frame.scale * finger_reach(frame.view);
    if (on_first || (pointer.left_double && state.corners.size() >= 3))
        return close_outline(state, frame.view, pointer.shift, outbox);
    if (pointer.left_double) return;  // the first click has set the corner
    add_corner(state, frame.view, at);
}

void set_polygon_corner(SceneInputState& state, const LabView& view, vec2 at, bool keep_tool, Outbox& outbox) {
    const auto is_at = [at](vec2 corner) { return maths::distance(corner, at) < least_corner_distance; };
    if (state.corners.size() >= 3 && (is_at(state.corners.front()) || is_at(state.corners.back())))
        return close_outline(state, view, keep_tool, outbox);
    add_corner(state, view, at);
}

void take_back_corner(SceneInputState& state) {
    state.refusal = {};
    if (state.corners.empty())
        choose_tool(state, SceneInputTool::hand);
    else
        state.corners.pop_back();
}

void close_outline(SceneInputState& state, const LabView& view, bool keep_tool, Outbox& outbox) {
    if (const OutlineFault fault = fault_of(state.corners); fault != OutlineFault::none)
        return show_refusal(state, view.wall_seconds, refusal_of(fault));
    const Obstacle drawn = obstacle_from(state.corners);
    const int redrawn = state.redrawn.empty() ? -1 : find_zone(*view.now->scene, state.redrawn);
    if (redrawn >= 0) {
        const Zone& zone = view.now->scene->zones[static_cast<std::size_t>(redrawn)];
        outbox.push_back(EditRequest{EditZone{redrawn, with_outline(zone, drawn)}});
        keep_tool = false;
    } else {
        outbox.push_back(EditRequest{AddObstacle{drawn}});
    }
    state.redrawn.clear();
    state.corners.clear();
    state.refusal = {};
    if (!keep_tool) choose_tool(state, SceneInputTool::hand);
}

OutlineFault fault_of_next(const std::vector<vec2>& corners, vec2 next) {
    if (corners.size() >= limits::corners) return OutlineFault::too_many;
    for (const vec2 corner : corners)
        if (maths::distance(corner, next) < least_corner_distance) return OutlineFault::too_near;
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
    return outline_width(corners) < least_outline_width ? OutlineFault::too_narrow : OutlineFault::none;
}

OutlineFault fault_of_moved(const std::vector<vec2>& corners, std::size_t moved) {
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (i != moved && maths::distance(corners[i], corners[moved]) < least_corner_distance)
            return OutlineFault::too_near;
    return fault_of(corners);
}

Obstacle obstacle_from(const std::vector<vec2>& given) {
    std::vector<vec2> corners = given;
    if (signed_area(corners) < 0) std::reverse(corners.begin(), corners.end());
    vec2 middle{};  // centroid of the area, so that a movable one turns about its centre of mass
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const vec2 a = corners[i], b = corners[(i + 1) % corners.size()];
        middle += (a + b) * (maths::cross(a, b) / (6 * signed_area(corners)));
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

Zone with_outline(Zone zone, const Obstacle& outline) {
    zone.round = false;
    return with_corners_of(std::move(zone), outline);
}

Obstacle with_outline(Obstacle obstacle, const Obstacle& outline) {
    return with_corners_of(std::move(obstacle), outline);
}

Zone zone_between(vec2 a, vec2 b) {
    constexpr vec2 half{1, 1};  // m
    const Obstacle box = a == b ? box_between(a - half, b + half) : box_between(a, b);
    Zone zone;
    zone.surface = Surface::ice;
    zone.x = box.x, zone.y = box.y, zone.length = box.length, zone.width = box.width;
    return zone;
}

Obstacle box_between(vec2 a, vec2 b) {
    Obstacle box;
    box.x = (a.x + b.x) / 2, box.y = (a.y + b.y) / 2;
    box.length = std::max(shortest_side, std::fabs(a.x - b.x));
    box.width = std::max(shortest_side, std::fabs(a.y - b.y));
    return box;
}

}  // namespace braitenlab::ui
