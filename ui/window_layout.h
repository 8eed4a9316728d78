// Where everything stands: the toolbar and the hint bar, two columns of cards, and the free middle that the camera
// frames.
#pragma once

#include "render/view/camera.h"
#include "ui/lab_view.h"

namespace braitenlab {

// All in window pixels. A rectangle of width 0 is not shown.
struct WindowLayout {
    Rect window, toolbar, hint_bar;
    Rect left;      // the exercise or the scene card may fill it
    Rect right;     // the brain card, and below it the information card
    Rect charts;    // the large pictures, below the free middle; where they are open
    Rect timeline;  // below canvas or scene
    Rect canvas;    // the wiring canvas; in Mode::wiring alone
    Rect scene;     // what no card covers: the camera frames the arena here, and the anchor `viewport` is here. In
                    // Mode::wiring a small inset, so that the scene stays in sight
    Rect tools;     // the palette of tools stands in its upper left corner: over the scene, or above it where the large
                    // pictures leave no room for both
    float scale = 1;
};

// `scale` is window pixels per layout pixel, at least 1. Holds from 1024 × 768 layout pixels on; below that the free
// middle shrinks, never below a quarter of the width.
WindowLayout lay_out(float window_width, float window_height, float scale, const LabView&, bool charts = false);

}  // namespace braitenlab
