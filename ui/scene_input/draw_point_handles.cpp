#include <string>
#include <vector>

#include <imgui.h>

#include "ui/scene_input/draw.h"
#include "ui/scene_input/point_handles.h"
#include "ui/widgets/number.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

using maths::vec2;

namespace {

// From each waypoint to the next one; a piece that leaves the picture is left out.
void draw_path(const SceneInputFrame& frame, const Ui& ui, const std::vector<vec2>& waypoints) {
    for (std::size_t i = 0; i < waypoints.size(); ++i) {
        const auto from = project(frame.camera_view, waypoints[i]);
        const auto to = project(frame.camera_view, waypoints[(i + 1) % waypoints.size()]);
        if (from && to)
            draw_line(ui, {{from->x, from->y}, {to->x, to->y}}, ui.palette.accent.with_alpha(0.6f), 1.5f, false);
    }
}

void draw_points(const SceneInputState& state, const SceneInputFrame& frame, const Ui& ui, PointKind kind,
                 const std::vector<vec2>& points) {
    const PointHandle warm = state.points.drag.handle ? state.points.drag.handle : state.points.hovered;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::string number = std::to_string(i + 1);
        const bool is_waypoint = kind == PointKind::waypoint;
        draw_handle(frame, ui, points[i], warm == PointHandle{kind, i},
                    (is_waypoint ? "handle.waypoint." : "handle.corner.") + number, is_waypoint ? number : "");
    }
}

}  // namespace

void draw_point_handles(const SceneInputState& state, const SceneInputFrame& frame, const Ui& ui) {
    const PointHandlePlaces places = point_handle_places(state, frame.view);
    draw_path(frame, ui, places.waypoints);
    draw_points(state, frame, ui, PointKind::waypoint, places.waypoints);
    draw_points(state, frame, ui, PointKind::corner, places.corners);
    const PointDrag& drag = state.points.drag;
    const bool refused = !state.refusal.key.empty() && frame.view.wall_seconds < state.refusal.until;
    if (drag.handle && !refused)
        draw_note(frame, ui,
                  fill(ui.strings("scene_input.place"), {with_sign(ui, drag.put.x, 1), with_sign(ui, drag.put.y, 1)}),
                  ui.palette.line, frame.pointer.at);
}

}  // namespace braitenlab::ui
