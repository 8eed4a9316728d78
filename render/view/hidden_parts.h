// The parts of a window that something opaque hides, and the others. A software renderer spends most of a picture's
// time on pixels, so nothing is drawn or copied where it is hidden.
#pragma once

#include <vector>

#include "render/view/picture.h"

namespace braitenlab {

// What Picture::opaque hides, without the round corners of cards, in whole pixels.
std::vector<Rect> hidden_parts(const Picture&);

// The rest of the window in rectangles that do not overlap, in whole pixels if `hidden` is.
std::vector<Rect> visible_parts(const Rect& window, const std::vector<Rect>& hidden);

}  // namespace braitenlab
