// What adds nodes to the canvas's brain and takes them away: by key, by menu, from the clipboard.
#pragma once

#include "ui/wiring/ask.h"

namespace braitenlab {

void erase_selected(CanvasState&, const CanvasFrame&, Outbox&);

// Puts what is selected onto the clipboard; false, with the reason at the cursor, where there is nothing to copy.
bool copy_selected(CanvasState&, const CanvasFrame&);

// Where the mouse points; in the middle of the canvas when it points elsewhere.
void paste_copied(CanvasState&, const CanvasFrame&, Outbox&);

void duplicate(CanvasState&, const CanvasFrame&, Outbox&);

// A neuron of this kind where the menu was opened; at the end of the wire that was dropped there, if one was.
void add_chosen(CanvasState&, const CanvasFrame&, const CanvasMenu&, std::size_t kind, Outbox&);

// A neuron in the middle of a wire.
void insert_new(CanvasState&, const CanvasFrame&, WireEnds, Outbox&);

}  // namespace braitenlab
