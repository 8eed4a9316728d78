// Converts mouse input to view state and requests. Does not use Dear ImGui.
//
// idle → pending (pressed, moved less than 4 px) → move | turn | orbit | pan → idle; idle → span → idle.
#pragma once

#include "ui/scene_input/state.h"

namespace braitenlab::ui {

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
