// Handles of a sensor's field in the scene: they change its direction, opening angle, range and position on the
// vehicle. Without Dear ImGui, except draw_sensor_handles().
#pragma once

#include <optional>

#include "ui/scene_input/state.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

// Positions on the floor, m. A handle of the arc is nearer than the range where the arc is out of sight.
struct SensorHandlePlaces {
    Sensor sensor;
    std::optional<Sensor> opposite;  // that changes with it
    maths::vec2 mount;
    std::optional<maths::vec2> axis, left, right;  // none: the sensor has no range, or no direction
};

// nullopt: no handles are shown.
std::optional<SensorHandlePlaces> sensor_handle_places(const SceneInputState&, const SceneInputFrame&);

// False where the vehicle is too small for the handle `mount`.
bool shows_mount(const SceneInputFrame&, maths::vec2 mount);

// One frame of the mouse. True while it uses the mouse: from the press on a handle to the release.
bool use_sensor_handles(SceneInputState&, const SceneInputFrame&, Outbox&);

// Ends a drag and restores the sensors; false without a drag.
bool cancel_sensor_drag(SceneInputState&, const Snapshot&, Outbox&);

// Outlines of the fields, handles, and a note at the pointer. Anchors: handle.axis, handle.left, handle.right,
// handle.mount. draw_sensor_handles.cpp
void draw_sensor_handles(const SceneInputState&, const SceneInputFrame&, const Ui&);

}  // namespace braitenlab::ui
