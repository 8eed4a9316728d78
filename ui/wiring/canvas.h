// The wiring canvas: a brain as a diagram that the user edits with the mouse or with keys alone.
//
// The canvas stores no graph. It reads the selected vehicle's brain from the snapshot in every frame and stores view
// state only: camera, selection, the drag in progress. Every edit is sent as an EditRequest through the outbox:
// TurnDial for the weights LL, LR, RL, RR (the sliders' numbers), PlaceNodes for node positions, SetBrain for all other
// edits. All edits of one drag have the same gesture.
#pragma once

#include "ui/widgets/ui.h"
#include "ui/wiring/canvas_state.h"

namespace braitenlab::wiring {

// Draws the canvas over `area` (window pixels, free of cards) and sends the user's edits. Anchors: canvas,
// canvas.arrange, canvas.fit, canvas.minimap, pin.<node>.out, pin.<node>.in, node.<node>, name.<node> (the letters;
// beside the scene only), wire.LL … or wire.<from>-<to> (the weight's label), curve.LL … (a point of the curve beside
// its label), menu and menu.<row> while a menu is open, says.<node> while a note describes the node, selected.<node or
// wire>, refused.<reason>. canvas.arrange and canvas.fit are not shown beside the scene of a lecture.
void draw_canvas(const LabView&, CanvasState&, ui::Ui&, Rect area);

}  // namespace braitenlab::wiring
