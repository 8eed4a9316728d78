// What the parts of the draw list share while one picture is made. Only draw_list.cpp and draw_vehicles.cpp need it.
#pragma once

#include "render/view/draw_list.h"
#include "render/view/palette.h"

namespace braitenlab {

// All that is asked for again and again while one picture is made.
struct Sheet {
    DrawList& list;
    const Snapshot& now;
    const Picture& picture;
    Palette colours;
    float crowd;  // 1 for a few vehicles, less the more there are
};

inline maths::vec4 rgb_with(Colour c, float w) { return {c.r, c.g, c.b, w}; }

// Adds every vehicle with all its parts.
void add_vehicles(Sheet&, const Trails&);

}  // namespace braitenlab
