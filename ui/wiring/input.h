// Mouse and keys on the canvas, actions and rows of menus become view state and edits. No Dear ImGui.
//
// idle → pending (pressed, moved less than 4 px) → pan | map | box | move_nodes | drag_wire | drag_weight → idle.
#pragma once

#include "ui/wiring/canvas_state.h"

namespace braitenlab::wiring {

// Processes one frame: actions of keys, then the mouse.
void handle_input(CanvasState&, const CanvasFrame&, Outbox&);

// Queues a key's action for the next frame. False when the canvas does not use the action now: an Esc with nothing to
// cancel can end the wiring mode.
bool press_key(CanvasState&, Action);

// The rest is in actions.cpp.

// Opens the menu of the selection at a window pixel.
void open_menu(CanvasState&, const CanvasFrame&, maths::vec2 at);

// Opens the menu of neurons at the pointer, for a wire that was dropped there. `pin`: the pin that it starts from.
void open_drop_menu(CanvasState&, const CanvasFrame&, Hit pin);

// Cancels a drag and restores the state at the press.
void cancel_drag(CanvasState&, const CanvasFrame&, Outbox&);

void execute(CanvasState&, const CanvasFrame&, Action, Outbox&);
bool is_of_canvas(Action);  // has an effect there; Action::cancel is not one of them

// `menu`: the menu that the row is from.
void execute(CanvasState&, const CanvasFrame&, const MenuRow&, const CanvasMenu& menu, Outbox&);

// Closes the menu and executes its row of this index; −1: none.
void choose(CanvasState&, const CanvasFrame&, int row, Outbox&);

}  // namespace braitenlab::wiring
