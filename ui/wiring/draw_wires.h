// Draws the wires: curve, signal, end sign, and the label with the weight.
#pragma once

#include <cstdint>

#include "ui/wiring/draw.h"

namespace braitenlab::wiring {

void draw_wires(const Pen&, const Picture&);
void draw_labels(const Pen&, const Picture&);

// The sign at a wire's end, pointing right at `tip`: ▶ excites, ● inhibits.
void draw_end_sign(const Pen&, maths::vec2 tip, float size, bool excites, Colour);

// The signal's dots move along a wire with every tick: distance of the first one from the start of the wire; the others
// follow at `dot_gap`.
inline constexpr float dot_gap = 44;  // units
float first_dot(std::uint64_t tick);

}  // namespace braitenlab::wiring
