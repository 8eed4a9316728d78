#include "ui/scene_input/tools.h"

#include <algorithm>

#include "core/maths/angle.h"
#include "core/scene/schema.h"
#include "ui/scene_input/edits.h"
#include "ui/scene_input/polygon_tool.h"
#include "ui/scene_input/under_pointer.h"

namespace braitenlab::ui {

using maths::vec2;

namespace {

constexpr float snap_pixels = 14;         // of the ruler to the position of an object
constexpr float same_corner = 0.02f;      // m; a corner nearer to the last one is the same
constexpr float standard_tape = 0.1f;     // m
constexpr float standard_vehicle = 0.7f;  // m, width of the standard vehicle
constexpr float least_tape = 0.02f;       // m, of Zone::width

vec2 snapped(const LabView& view, vec2 at) {
    const float reach = snap_pixels / std::max(pixels_per_metre(*view.camera_view, at), 1e-3f);
    vec2 nearest = at;
    float least = reach;
    const auto compare = [&](vec2 place) {
        if (maths::distance(at, place) < least) least = maths::distance(at, place), nearest = place;
    };
    for (const VehicleView& v : view.now->vehicles) compare({v.x, v.y});
    for (const SceneObject& object : objects_beside_vehicles(*view.now->scene)) {
        const auto place = place_of(*view.now, object);
        if (place) compare({place->x, place->y});
    }
    return nearest;
}

void finish(SceneInputState& state, bool keep_tool) {
    state.corners.clear();
    if (!keep_tool) choose_tool(state, SceneInputTool::hand);
}

void add_point(SceneInputState& state, const LabView& view, vec2 at, bool keep_tool, Outbox& outbox) {
    if (!state.corners.empty() && maths::distance(state.corners.back(), at) < same_corner)
        return end_line(state, view, keep_tool, outbox);
    state.corners.push_back(at);
}

}  // namespace

std::optional<vec2> aim(const SceneInputState& state, const LabView& view, vec2 pointer) {
    const auto floor = state.crosshair ? state.crosshair : unproject(*view.camera_view, pointer);
    if (!floor) return std::nullopt;
    const vec2 at = in_arena(view, *floor);
    return state.tool == SceneInputTool::ruler ? snapped(view, at) : at;
}

void set_corner(SceneInputState& state, const LabView& view, vec2 at, bool keep_tool, Outbox& outbox) {
    state.refusal = {};
    if (state.tool == SceneInputTool::polygon) return set_polygon_corner(state, view, at, keep_tool, outbox);
    if (state.tool == SceneInputTool::tape) return add_point(state, view, at, keep_tool, outbox);
    if (spans(state.tool)) {
        if (state.corners.size() == 1) return complete_span(state, view, at, keep_tool, outbox);
        state.corners = {at};
    }
    if (state.tool != SceneInputTool::lamp) return;
    Source lamp;
    lamp.x = at.x, lamp.y = at.y;
    outbox.push_back(EditRequest{with_room(*view.now, AddSource{lamp})});
    finish(state, keep_tool);
}

void complete_span(SceneInputState& state, const LabView& view, vec2 to, bool keep_tool, Outbox& outbox) {
    const vec2 from = state.corners.at(0);
    const bool one_point = maths::distance(from, to) < same_corner;
    if (state.tool == SceneInputTool::ruler) {
        state.corners.push_back(to);  // shown until the next measurement
        return;
    }
    if (state.tool == SceneInputTool::zone)
        outbox.push_back(EditRequest{AddZone{zone_between(from, one_point ? from : to)}});
    else if (one_point)  // a box of one metre
        outbox.push_back(EditRequest{
            with_room(*view.now, AddObstacle{box_between(from - vec2{0.5f, 0.5f}, from + vec2{0.5f, 0.5f})})});
    else
        outbox.push_back(EditRequest{AddObstacle{box_between(from, to)}});
    finish(state, keep_tool);
}

void end_line(SceneInputState& state, const LabView& view, bool keep_tool, Outbox& outbox) {
    const std::uint64_t gesture = gestures::viewport + ++state.gesture;
    for (Zone& zone : tape_along(state.corners, tape_width(*view.now->scene)))
        outbox.push_back(EditRequest{AddZone{std::move(zone)}, gesture});
    finish(state, keep_tool);
}

float tape_width(const Scene& scene) {
    if (scene.kinds.empty()) return standard_tape;
    float narrowest = scene.kinds[0].body.width;
    for (const Kind& kind : scene.kinds) narrowest = std::min(narrowest, kind.body.width);
    return std::max(least_tape, standard_tape * narrowest / standard_vehicle);
}

std::vector<Zone> tape_along(const std::vector<vec2>& points, float width) {
    std::vector<Zone> line;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const maths::Polar of = maths::to_polar(points[i + 1] - points[i]);
        const vec2 way = maths::direction(of.angle);
        // At a bend a segment reaches half a width beyond the point.
        const float before = i > 0 ? width / 2 : 0, after = i + 2 < points.size() ? width / 2 : 0;
        const vec2 middle = (points[i] - before * way + points[i + 1] + after * way) / 2;
        Zone segment;
        segment.name = "tape";
        segment.x = middle.x, segment.y = middle.y, segment.heading = of.angle;
        segment.length = std::max(of.distance + before + after, least_tape), segment.width = width;
        segment.surface = Surface::tape;
        line.push_back(segment);
    }
    return line;
}

void move_crosshair(SceneInputState& state, const LabView& view, vec2 by) {
    if (!state.crosshair) {
        const auto middle = unproject(*view.camera_view, state.middle);
        state.crosshair = !state.corners.empty() ? state.corners.back() : in_arena(view, middle.value_or(vec2{}));
    }
    state.crosshair = in_arena(view, *state.crosshair + by);
}

}  // namespace braitenlab::ui
