// Lines drawn with the mouse over the scene during a lecture. They are on the floor: they move with the camera.
#pragma once

#include <cstdint>
#include <vector>

#include "core/maths/vec.h"
#include "ui/lab_view.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

struct Marks {
    bool drawing = false;                           // the mouse draws
    bool pressed = false;                           // the button is down: the last line grows
    std::vector<std::vector<maths::vec2>> lines{};  // points on the floor, m
    std::uint64_t run_id = 0;                       // of the document that they are drawn on
};

// Draws the lines below the cards, and while drawing is on a sign at the lower edge of the scene (anchor marks.sign);
// adds points while the left button is down over the scene. Another document, and the end of the lecture, remove the
// lines. Call once a frame.
void draw_marks(const LabView&, Marks&, Ui&, Rect scene);

}  // namespace braitenlab::ui
