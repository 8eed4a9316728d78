// Mouse and keys on the canvas become view state and edits. No Dear ImGui.
//
// idle → pending (pressed, moved less than 4 px) → pan | map | box | move_nodes | drag_wire | drag_weight → idle.
#pragma once

#include "ui/wiring/canvas.h"

namespace braitenlab::wiring {

// Processes one frame: actions of keys, then the mouse.
void handle_input(CanvasState&, const CanvasFrame&, Outbox&);

// Queues a key's action for the next frame. False when the canvas does not use the action now: an Esc with nothing to
// cancel can end the wiring mode.
bool press_key(CanvasState&, Action);

}  // namespace braitenlab::wiring
