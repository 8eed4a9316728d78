// A path drawn freehand on the floor: the prediction of an exercise that asks for one. Without Dear ImGui.
#pragma once

#include "ui/scene_input/state.h"

namespace braitenlab::ui {

// The vehicle whose path the exercise asks for. Null while no path can be drawn: without such an exercise, once the
// prediction is closed, later than the start of the run, and in the wiring editor.
const VehicleView* vehicle_to_draw_for(const LabView&);

// One frame of the mouse: a drag draws from the vehicle to the pointer and is requested as the prediction on release.
// A press on another vehicle is refused with a notice, a path shorter than 0.3 m is discarded. True while it uses the
// mouse: the other buttons still move the camera.
bool use_path_drawing(SceneInputState&, const SceneInputFrame&, Outbox&);

// Lengthens the path by one step of an arrow key; the first step begins it at the vehicle. False while none is drawn.
bool draw_path_step(SceneInputState&, const LabView&, maths::vec2 way);

// Removes the last step. False while no path is drawn.
bool take_back_path_step(SceneInputState&);

// Requests the path that was drawn by keys as the prediction, as a release of the button does. False while none is
// drawn.
bool finish_path_drawing(SceneInputState&, Outbox&);

// Ends the drawing; false if there is none.
bool cancel_path_drawing(SceneInputState&);

}  // namespace braitenlab::ui
