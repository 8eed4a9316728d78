// What the mouse does to the scene. Does not use Dear ImGui.
//
// idle → pending (pressed, moved less than 4 px) → move | turn | orbit | pan | box → idle.
#pragma once

#include "ui/scene_input/scene_input.h"

namespace braitenlab::ui {

// The mouse in one frame, in window pixels.
struct SceneInputPointer {
    maths::vec2 at;
    bool over = true;                                                          // no card covers the scene here
    bool left_pressed = false, right_pressed = false, middle_pressed = false;  // in this frame
    bool left_double = false;                                                  // the second press of a double click
    bool left_down = false, right_down = false, middle_down = false;
    bool shift = false;
};

struct SceneInputFrame {
    const LabView& view;
    const CameraView& camera_view;
    float scale = 1;  // window pixels per layout pixel
    Rect area;        // free of cards
    SceneInputPointer pointer;
};

// One frame: turns mouse input into view state and requests.
void interact(SceneInputState&, const SceneInputFrame&, Outbox&);

// Esc: undoes the drag in progress, or else drops the outline, or else the tool, or else the selected object. False
// when there was nothing to cancel.
bool cancel(SceneInputState&, const LabView&, Outbox&);

// Opens the menu of an object at its position.
void open_menu_of(SceneInputState&, const LabView&, const SceneObject&);

}  // namespace braitenlab::ui
