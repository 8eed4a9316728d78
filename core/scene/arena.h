// The shape of an arena: a rectangle, or the ellipse with the axes width × height (Arena::round).
#pragma once

#include <vector>

#include "core/scene/scene.h"

namespace braitenlab {

// True when the position is inside the arena, at least `margin` m away from its edge. On the edge counts as inside.
bool is_inside(const Arena&, maths::vec2 position, float margin = 0);

// A position with is_inside: the position itself; otherwise, in a rectangle the nearest one, in an ellipse the one
// towards the middle. The middle of the arena (in a rectangle: of that axis) where the arena is narrower than twice the
// margin.
maths::vec2 moved_inside(const Arena&, maths::vec2 position, float margin = 0);

// The corners of the regular polygon, on the ellipse, that stands for the edge of a round arena; counter-clockwise. It
// is at most 1 cm inside the ellipse up to 130 m, and 8 cm in the largest arena.
std::vector<maths::vec2> round_corners(const Arena&);

// A box of a round wall: its inner side covers one side of the polygon. `length` along the heading, m.
struct WallBox {
    maths::vec2 middle;
    float heading = 0, length = 0;
};

// The boxes of the wall round a round arena, counter-clockwise. Each is longer than its side by `thickness` (m) at
// either end, so that neighbours overlap outside the polygon and a body that slides along the wall meets no gap.
std::vector<WallBox> round_wall(const Arena&, float thickness);

}  // namespace braitenlab
