// Lines drawn with the mouse during a lecture, over the whole window. A line over the scene is on the floor: it moves
// with the camera. A line beside the scene, for example over the diagram, is in the window and scales with it.
#pragma once

#include <cstdint>
#include <vector>

#include "core/maths/vec.h"
#include "ui/lab_view.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

struct MarkLine {
    bool on_floor = false;
    std::vector<maths::vec2> points{};  // on the floor: m; else shares of the window's width and height
};

struct Marks {
    bool drawing = false;           // the mouse draws
    bool pressed = false;           // the button is down: the last line grows
    std::vector<MarkLine> lines{};  // a line that leaves the scene goes on as another one
    std::uint64_t run_id = 0;       // of the document that they are drawn on
};

// Draws the lines above everything, and while drawing is on a sign at the lower edge of the scene (anchor marks.sign);
// adds points while the left button is down. Then the mouse does nothing else below `bar`, the bar on top. Another
// document, and the end of the lecture, remove the lines. Call once a frame, after all cards.
void draw_marks(const LabView&, Marks&, Ui&, Rect scene, Rect bar, Rect window);

}  // namespace braitenlab::ui
