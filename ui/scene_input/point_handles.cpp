#include "ui/scene_input/point_handles.h"

#include "ui/scene_input/handles.h"
#include "ui/scene_input/polygon_tool.h"

namespace braitenlab::ui {

using maths::vec2;

namespace {

constexpr double corner_refusal_seconds = 1;

bool is_polygon(const Snapshot& now, const SceneObject& object) {
    if (!place_of(now, object)) return false;
    const auto index = static_cast<std::size_t>(object.index);
    if (object.kind == SceneObjectKind::zone) return !now.scene->zones[index].corners.empty();
    return object.kind == SceneObjectKind::obstacle && !now.scene->obstacles[index].corners.empty();
}

// The kind whose path is shown; −1: none.
int kind_with_path(const LabView& view) {
    const VehicleView* vehicle = selected_vehicle(view);
    if (!vehicle || vehicle->kind < 0) return -1;
    const Kind& kind = view.now->scene->kinds[static_cast<std::size_t>(vehicle->kind)];
    return vehicle->driver == Driver::path || kind.driver == Driver::path ? vehicle->kind : -1;
}

// The command that gives the object this outline, m.
Command with_corners(const Snapshot& now, const SceneObject& object, const std::vector<vec2>& corners) {
    const auto index = static_cast<std::size_t>(object.index);
    const Obstacle outline = obstacle_from(corners);
    if (object.kind == SceneObjectKind::zone)
        return EditZone{object.index, with_outline(now.scene->zones[index], outline)};
    return EditObstacle{object.index, with_outline(now.scene->obstacles[index], outline)};
}

Command with_waypoints(const Snapshot& now, int kind, const std::vector<vec2>& points) {
    Kind to = now.scene->kinds[static_cast<std::size_t>(kind)];
    to.waypoints.clear();
    for (const vec2 point : points) to.waypoints.push_back({point.x, point.y});
    return EditKind{kind, std::move(to)};
}

Command with_points(const Snapshot& now, const PointDrag& drag, const std::vector<vec2>& points) {
    return drag.handle.kind == PointKind::corner ? with_corners(now, drag.object, points)
                                                 : with_waypoints(now, drag.kind, points);
}

void begin_point_drag(SceneInputState& state, const SceneInputFrame& frame, const PointHandlePlaces& places,
                      vec2 floor) {
    PointDrag& drag = state.points.drag;
    drag = {};
    drag.handle = state.points.hovered;
    drag.object = places.object, drag.kind = places.kind;
    drag.points = drag.handle.kind == PointKind::corner ? places.corners : places.waypoints;
    drag.put = drag.points[drag.handle.index];
    drag.offset = drag.put - floor;
    drag.restored = with_points(*frame.view.now, drag, drag.points);
    drag.gesture = gestures::viewport + ++state.gesture;
    state.drag = {};
    state.drag.phase = SceneInputPhase::handle;
}

PointHandle point_at(const PointHandlePlaces& places, const SceneInputFrame& frame) {
    NearestHandle<PointHandle> search{frame};
    for (std::size_t i = 0; i < places.corners.size(); ++i) search.offer({PointKind::corner, i}, places.corners[i]);
    for (std::size_t i = 0; i < places.waypoints.size(); ++i)
        search.offer({PointKind::waypoint, i}, places.waypoints[i]);
    // A vehicle may be over the point: take the nearer one.
    const SceneObject object = search.found ? object_at_pointer(frame) : SceneObject{};
    const auto vehicle = object.kind == SceneObjectKind::vehicle ? place_of(*frame.view.now, object) : std::nullopt;
    const bool is_nearer = vehicle && pixels_from(frame, {vehicle->x, vehicle->y}) < search.nearest;
    return is_nearer ? PointHandle{} : search.found;
}

// True while the points of the drag are still those of the scene.
bool has_points(const PointHandlePlaces& places, const PointDrag& drag) {
    const auto& points = drag.handle.kind == PointKind::corner ? places.corners : places.waypoints;
    return places.object == drag.object && places.kind == drag.kind && points.size() == drag.points.size();
}

}  // namespace

PointHandlePlaces point_handle_places(const SceneInputState& state, const LabView& view) {
    PointHandlePlaces places;
    if (!shows_handles(state, view)) return places;
    const Snapshot& now = *view.now;
    const Selection& selection = view.settings.selection;
    const bool is_seen = selection.object.kind != SceneObjectKind::zone || view.settings.overlays.surfaces;
    if (selection.more.empty() && is_seen && is_polygon(now, selection.object)) {
        places.object = selection.object;
        places.corners = outline_of(now, selection.object);
    }
    places.kind = kind_with_path(view);
    if (places.kind >= 0)
        for (const Waypoint& point : now.scene->kinds[static_cast<std::size_t>(places.kind)].waypoints)
            places.waypoints.push_back({point.x, point.y});
    return places;
}

bool use_point_handles(SceneInputState& state, const SceneInputFrame& frame, Outbox& outbox) {
    PointDrag& drag = state.points.drag;
    const PointHandlePlaces places = point_handle_places(state, frame.view);
    const auto floor = floor_at(frame);
    if (!drag.handle) {
        const bool is_free = frame.pointer.over && state.drag.phase == SceneInputPhase::idle;
        state.points.hovered = is_free ? point_at(places, frame) : PointHandle{};
        if (!state.points.hovered || !frame.pointer.left_pressed || frame.pointer.shift || !floor) return false;
        begin_point_drag(state, frame, places, *floor);
        return true;
    }
    if (!frame.pointer.left_down || !has_points(places, drag)) {
        drag = {}, state.drag = {};
        return true;
    }
    if (!floor) return true;
    std::vector<vec2> points = drag.points;
    const vec2 to = in_arena(frame.view, *floor + drag.offset);
    if (to == drag.put) return true;
    points[drag.handle.index] = to;
    const OutlineFault fault =
        drag.handle.kind == PointKind::corner ? fault_of_moved(points, drag.handle.index) : OutlineFault::none;
    if (fault != OutlineFault::none) {
        state.refusal = {std::string(refusal_of(fault)), frame.view.wall_seconds + corner_refusal_seconds};
        return true;
    }
    state.refusal = {};
    drag.put = to;
    outbox.push_back(EditRequest{with_points(*frame.view.now, drag, points), drag.gesture});
    return true;
}

bool cancel_point_drag(SceneInputState& state, Outbox& outbox) {
    PointDrag& drag = state.points.drag;
    if (!drag.handle) return false;
    outbox.push_back(EditRequest{drag.restored, drag.gesture});
    drag = {}, state.drag = {};
    return true;
}

}  // namespace braitenlab::ui
