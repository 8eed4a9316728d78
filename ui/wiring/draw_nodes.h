// Draws the nodes: cards with name, value and icon, and their pins.
#pragma once

#include "ui/wiring/draw.h"

namespace braitenlab::wiring {

// The input at the right end of a neuron's curve glyph, at least 1: the glyph always contains the step or the peak.
float glyph_reach(const Curve&);

void draw_nodes(const Pen&, const Picture&);

}  // namespace braitenlab::wiring
