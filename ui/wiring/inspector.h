// The card below the canvas: the numbers of the one neuron or wire that is selected, to be seen and changed.
#pragma once

#include "ui/widgets/slider.h"
#include "ui/wiring/canvas.h"

namespace braitenlab {

// The part of the canvas's room that the card takes, at its lower end; less when it is folded.
Rect inspector_place(const Ui&, const CanvasState&, Rect canvas);

// Draws the card there and reports what the person changed, as the canvas does. A wire's weight and threshold and a
// motor's bias are the sliders' own numbers. Anchors: card.inspector, inspector.weight, .threshold, .bias, .memory,
// .peak, .width, .learning, .decay, .lesion, inspector.kind.<n> for the curves, inspector.column … for many nodes.
void wiring_inspector(const LabView&, CanvasState&, SliderState&, Ui&, Rect);

}  // namespace braitenlab
