// A response curve as a small picture: axes through zero, the curve, and where a neuron stands on it now.
#pragma once

#include <optional>

#include "core/brain/graph.h"
#include "ui/widgets/ui.h"

struct ImDrawList;

namespace braitenlab {

struct CurvePlot {
    Rect rect;  // window pixels
    float low_x = -1, high_x = 1;
    float low_y = -1, high_y = 1;
    // Window pixels; y outside its range is brought to the edge.
    maths::vec2 at(float x, float y) const;
};

// The plot of a curve that shows what is worth seeing of it: inputs −1..1 and as far as its peak reaches.
CurvePlot plot_of(const Curve&, Rect);

// `now`: the input and the answer that a dot marks.
void draw_plot(ImDrawList&, const Ui&, const CurvePlot&, const Curve&, std::optional<maths::vec2> now = {});

// The curve alone, for a row or a button.
void draw_curve_sign(ImDrawList&, const Ui&, Rect, const Curve&, Colour);

}  // namespace braitenlab
