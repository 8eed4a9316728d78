// Places the characters of labels on the screen.
#pragma once

#include <vector>

#include "core/maths/vec.h"
#include "render/text/lettering.h"
#include "render/view/draw_list.h"
#include "render/view/picture.h"

namespace braitenlab::render {

// One character: a rectangle of the framebuffer that shows a rectangle of the same size of the sheet.
struct LetterInstance {
    maths::vec4 box;    // x, y, width, height; pixels, y down from the top
    maths::vec4 sheet;  // x, y of the rectangle in the sheet; pixels
    maths::vec4 colour;
};

// Places each label centred on its position, or beside it in the direction Label::away, or at one of the spots
// elsewhere: the first at which it covers neither what is in the label space nor a label of lower rank. It is omitted
// if there is none. Labels behind the camera or outside the window are omitted. Rectangles are Lettering::room larger
// on every side, for the outline.
void set_type(std::vector<LetterInstance>&, const std::vector<Label>&, Lettering&, const Picture&, LabelSpace = {});

}  // namespace braitenlab::render
