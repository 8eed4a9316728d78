// The canvas's picture: ground, wires, cards, and what goes on under the cursor.
#pragma once

#include "ui/wiring/interaction.h"
#include "ui/wiring/pen.h"

namespace braitenlab {

struct CanvasPicture {
    const LabView& view;
    const VehicleView& vehicle;
    const BrainGraph& graph;
    const Layout& layout;
    const CanvasState& state;
    float value(NodeId id) const { return node_value(*view.now, vehicle, id); }
};

void draw_ground(const Pen&, Rect area);
void draw_wires(const Pen&, const CanvasPicture&);
void draw_nodes(const Pen&, const CanvasPicture&);

// The selected neuron's sum, the wire or box being drawn, and the reason of a refusal.
void draw_cursor(const Pen&, const CanvasPicture&, const CanvasFrame&);

// The sign at a wire's end, pointing right at `tip`: ▶ excites, ● inhibits.
void draw_end_sign(const Pen&, maths::vec2 tip, float size, bool excites, Colour);

}  // namespace braitenlab
