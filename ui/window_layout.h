// Rectangles of the parts of the window: bars, two columns of cards, and the free middle that the camera frames.
#pragma once

#include "render/view/camera.h"
#include "ui/lab_view.h"

namespace braitenlab::ui {

// In window pixels. A rectangle of width 0 is not shown.
struct WindowLayout {
    Rect window, menu_bar, toolbar, hint_bar;  // no menu bar in a lecture
    Rect left, right;                          // columns of cards
    Rect charts;                               // the chart card, below the scene, while it is open
    Rect timeline;                             // below canvas or scene
    bool exercise_on_right = false;            // its card has no left column and is above the cards of the right one
    bool left_on_right = false;                // so are all cards of the left column: one column has all cards
    Rect canvas;  // the wiring canvas; in Mode::wiring, or beside or below the scene while it is watched
    bool card_replaces_diagram = false;  // a card that was asked for has the room of a watched diagram
    Rect border;                         // between canvas and scene while it is watched; can be dragged
    Rect scene;  // no card covers it: the camera fits the arena into it; anchor `viewport`. In Mode::wiring an inset
    Rect caption, question, notes;  // of a page of a lecture; the question also without one
    Rect tools;  // the tool palette is in its upper left corner: in the scene, or above it beside the chart card
    float scale = 1;
};

// The cards that take space of the scene while they are open.
struct OpenCards {
    bool charts = false;                    // the chart card
    bool left = false;                      // any card of the left column
    bool right = false;                     // any card of the right column
    int folded_left = 0, folded_right = 0;  // how many folded cards a column has of which no card is open
    float notes = 0;     // wanted height of the lecturer's notes, window pixels; 0: they are not shown
    float question = 0;  // wanted height of the page's question, window pixels
    bool sum = false;    // the diagram beside the scene shows the sum of the selected neuron or motor
};

// The scale, window pixels per layout pixel, reduced until bars and cards fit into the window. In steps of an eighth,
// because each change loads the fonts again. A lecture has few cards, so it fits into fewer layout pixels. At least 1,
// in a window of less than 768 × 560 pixels at least 0.625, but for an upright one and for fingers (a page that is
// shown reduced already).
float fitting_scale(float scale, Rect window, bool lecture, bool fingers = false);

// True if not even that makes bars and cards fit: the window then asks for more room and shows nothing else.
bool window_too_small(const WindowLayout&);

// `scale`: window pixels per layout pixel. The layout fits windows of at least 1024 × 768 layout pixels. In a window
// that is narrower than 900 all cards are in one column, as in an upright one, so that the scene has three fifths of
// the width, as the diagram has in the wiring editor. A column whose cards are all folded is as wide as their headings,
// and the scene is beside or below them. In a lecture open cards leave it half of the width, or of the height where the
// diagram is shown, too. In an upright window all cards are in one column below the scene or the diagram, as wide as
// the window.
WindowLayout lay_out(float window_width, float window_height, float scale, const LabView&, OpenCards = {});

}  // namespace braitenlab::ui
