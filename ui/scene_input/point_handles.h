// Handles that move points of the scene: the corners of the selected polygon (an obstacle or a zone) and the waypoints
// of the selected vehicle's kind if it follows its path. Without Dear ImGui, except draw_point_handles().
#pragma once

#include <vector>

#include "ui/scene_input/state.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

// Positions on the floor, m; empty while none are shown.
struct PointHandlePlaces {
    SceneObject object;  // that has the corners
    int kind = -1;       // that has the waypoints
    std::vector<maths::vec2> corners, waypoints;
};
PointHandlePlaces point_handle_places(const SceneInputState&, const LabView&);

// One frame of the mouse. True while it uses the mouse: from the press on a handle to the release. A position that
// makes the outline invalid is refused; the corner stays at the last valid one.
bool use_point_handles(SceneInputState&, const SceneInputFrame&, Outbox&);

// Ends a drag and restores the point; false without a drag.
bool cancel_point_drag(SceneInputState&, Outbox&);

// The path as a line, handles, and the position of the dragged point. Anchors: handle.corner.1 …, handle.waypoint.1 …
// draw_point_handles.cpp
void draw_point_handles(const SceneInputState&, const SceneInputFrame&, const Ui&);

}  // namespace braitenlab::ui
