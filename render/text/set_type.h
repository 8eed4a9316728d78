// Labels of the scene as boxes on the screen.
#pragma once

#include <vector>

#include "core/maths/vec.h"
#include "render/text/lettering.h"
#include "render/view/draw_list.h"
#include "render/view/picture.h"

namespace braitenlab::render {

// One character: pixels of the framebuffer that show as many of the sheet.
struct LetterInstance {
    maths::vec4 box;    // x, y, width, height; pixels, y down from the top
    maths::vec4 sheet;  // x, y of the same in the sheet; pixels
    maths::vec4 colour;
};

// Sets each label centred on its place, or beside it where it has a side to stand on. Of two that overlap the one of
// lower rank stays; what is behind the eye or outside the window is left out. Boxes are grown by Lettering::room each
// way for the halo.
void set_type(std::vector<LetterInstance>&, const std::vector<Label>&, Lettering&, const Picture&);

}  // namespace braitenlab::render
