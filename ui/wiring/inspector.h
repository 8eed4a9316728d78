// The card below the canvas with the parameters of the selected neuron or wire.
#pragma once

#include "ui/widgets/slider.h"
#include "ui/wiring/canvas.h"

namespace braitenlab::wiring {

// The card's rectangle at the lower end of the canvas's area; lower when it is folded.
Rect inspector_rect(const ui::Ui&, const CanvasState&, Rect canvas);

// Draws the card and sends the user's edits. A direct wire's weight and threshold and a motor's bias are the sliders'
// numbers. Anchors: card.inspector, inspector.weight, .threshold, .bias, .memory, .peak, .width, .learning, .decay,
// .lesion, inspector.kind.<n> for the curves, inspector.column … for several nodes.
void draw_inspector(const LabView&, CanvasState&, ui::SliderState&, ui::Ui&, Rect);

}  // namespace braitenlab::wiring
