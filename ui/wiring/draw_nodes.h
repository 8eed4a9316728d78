// Draws the nodes: cards with name, value and icon, and their pins.
#pragma once

#include "ui/wiring/draw.h"

namespace braitenlab::wiring {

void draw_nodes(const Pen&, const Picture&);

}  // namespace braitenlab::wiring
