// Executes the actions of keys and the rows of menus on the canvas and its brain. No Dear ImGui.
#pragma once

#include "ui/wiring/canvas.h"

namespace braitenlab::wiring {

// Opens the menu of the selection at a window pixel.
void open_menu(CanvasState&, const CanvasFrame&, maths::vec2 at);

// Opens the menu of neurons at the pointer, for a wire that was dropped there. `pin`: the pin that it starts from.
void open_drop_menu(CanvasState&, const CanvasFrame&, Hit pin);

// Cancels a drag and restores the state at the press.
void cancel_drag(CanvasState&, const CanvasFrame&, Outbox&);

void execute(CanvasState&, const CanvasFrame&, Action, Outbox&);

// `menu`: the menu that the row is from.
void execute(CanvasState&, const CanvasFrame&, const MenuRow&, const CanvasMenu& menu, Outbox&);

// Closes the menu and executes its row of this index; −1: none.
void choose(CanvasState&, const CanvasFrame&, int row, Outbox&);

}  // namespace braitenlab::wiring
