// Draws the parts over wires and nodes: the minimap, the wire or box being dragged, and notes at the pointer.
#pragma once

#include "ui/wiring/draw.h"

namespace braitenlab::wiring {

void draw_minimap(const Pen&, const Picture&, Rect area);

// The selected node's sum or description, the wire or box being dragged, and the reason of a refusal.
void draw_cursor(const Pen&, const Picture&, const CanvasFrame&);

}  // namespace braitenlab::wiring
