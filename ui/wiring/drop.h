// What happens to a wire's end or to nodes when the button is let go.
#pragma once

#include "ui/wiring/interaction.h"

namespace braitenlab {

// Precondition: the phase is drag_wire. Joins, takes off, opens the menu of what may stand there, or says why not.
void drop_wire(CanvasState&, const CanvasFrame&, Outbox&);

// Precondition: the phase is move_nodes. A lone neuron on a wire is put into it; else the move can be undone.
void drop_nodes(CanvasState&, const CanvasFrame&, Outbox&);

}  // namespace braitenlab
