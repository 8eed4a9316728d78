// Converts mouse input to view state and requests. Does not use Dear ImGui.
//
// idle → pending (pressed, moved less than 4 px) → move | turn | orbit | pan → idle; idle → span → idle.
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
    LabelSpace* labels = nullptr;  // of this frame; null: a note avoids vehicles and bulbs only
};

// One frame: turns mouse input into view state and requests.
void interact(SceneInputState&, const SceneInputFrame&, Outbox&);

// Executes Esc: cancels the drag in progress; if there is none, ends a line of tape or discards what the tool has
// begun; else deselects the tool; else deselects the object. Returns false if there is nothing to cancel.
bool cancel(SceneInputState&, const LabView&, Outbox&);

// Opens the menu of an object at its position.
void open_menu_of(SceneInputState&, const LabView&, const SceneObject&);

// Opens the menu of the floor, at the crosshair or in the middle of the view.
void open_menu_of_floor(SceneInputState&, const LabView&);

}  // namespace braitenlab::ui
