// What keys and the menu do to the canvas and its brain.
#pragma once

#include "ui/wiring/align.h"
#include "ui/wiring/ask.h"
#include "ui/wiring/focus.h"
#include "ui/wiring/interaction.h"

namespace braitenlab {

// Opens the menu for the selection, at a pixel of the window.
void open_menu(CanvasState&, const CanvasFrame&, maths::vec2 at);

// Opens the menu of what a dropped wire can end at.
void open_drop_menu(CanvasState&, const CanvasFrame&, Hit pin);

// Esc in mid-drag: everything as it was at the press.
void cancel_drag(CanvasState&, const CanvasFrame&, Outbox&);

void obey(CanvasState&, const CanvasFrame&, Action, Outbox&);

// Does what a row of the menu says; `menu` is the one that it stood in.
void carry_out(CanvasState&, const CanvasFrame&, const MenuRow&, const CanvasMenu& menu, Outbox&);

// Closes the menu and carries out the row at this index; −1 for none.
void choose(CanvasState&, const CanvasFrame&, int row, Outbox&);

}  // namespace braitenlab
