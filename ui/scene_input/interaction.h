// What the mouse does to the scene; knows nothing of Dear ImGui.
//
// Idle → Pending (pressed, moved less than 4 px) → Move | Turn | Orbit | Pan | Box → Idle.
#pragma once

#include "ui/scene_input/scene_input.h"

namespace braitenlab {

// The mouse of one frame, in window pixels.
struct SceneInputPointer {
    maths::vec2 at;
    bool over = true;                                                          // nothing covers the scene here
    bool left_pressed = false, right_pressed = false, middle_pressed = false;  // in this frame
    bool left_double = false;                                                  // the second press of two quick ones
    bool left_down = false, right_down = false, middle_down = false;
    bool shift = false;
};

struct SceneInputFrame {
    const LabView& view;
    const Sight& sight;
    float scale = 1;  // window pixels per layout pixel
    Rect area;        // what no card covers
    SceneInputPointer pointer;
};

// One frame: the mouse becomes view state and requests.
void interact(SceneInputState&, const SceneInputFrame&, Outbox&);

// Esc in the middle of something puts it back; the drag in progress, or else the outline, or else the tool. False when
// there was nothing to cancel.
bool cancel(SceneInputState&, const LabView&, Outbox&);

// The menu of a thing where it stands, as by a right click on it.
void open_menu_of(SceneInputState&, const LabView&, const SceneObject&);

}  // namespace braitenlab
