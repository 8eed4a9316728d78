// Lines drawn with the mouse during a lecture, over the whole window. A line stays on what it marks: over the scene it
// is on the floor and moves with the camera, over the wiring diagram it is on the diagram, over the values below the
// scene and over the card of a question it is there only while these are shown. Beside all of them it is in the window
// and scales with it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/maths/vec.h"
#include "ui/lab_view.h"
#include "ui/widgets/ui.h"
#include "ui/wiring/view.h"

namespace braitenlab::ui {

enum class MarkedPart { floor, diagram, strip, question, window };

struct MarkLine {
    MarkedPart on = MarkedPart::window;
    // On the floor: m; on the diagram: canvas units; else shares of the width and height of the part.
    std::vector<maths::vec2> points{};
    int asked = 0;  // MarkedParts::asked when a line on a question was drawn
};

struct Marks {
    bool drawing = false;           // the mouse draws
    bool pressed = false;           // the button is down: the last line grows
    std::vector<MarkLine> lines{};  // a line that leaves its part of the window goes on as another one
    std::uint64_t run_id = 0;       // of the document that they are drawn on
};

// The parts of the window that lines can be on. A rectangle without a width: the part is not shown.
struct MarkedParts {
    Rect scene;
    Rect diagram;
    wiring::View of_diagram;
    Rect strip;     // the values below the scene
    Rect question;  // the card of a question
    int asked = 0;  // tells the questions and the answers of the pages apart
    Rect bar;       // on top: the mouse does not draw there
    Rect window;
};

// The sign that drawing is on and how it ends (anchor marks.sign), at the left of this place in the bar: there it
// covers nothing that is drawn on.
void sign_of_pen(Ui&, Rect place);

// Draws the lines above everything; while drawing is on, adds points while the left button is down. Then the mouse does
// nothing else below the bar. Another document, and the end of the lecture, remove the lines. Call once a frame, after
// all cards.
void draw_marks(const LabView&, Marks&, Ui&, const MarkedParts&);

}  // namespace braitenlab::ui
