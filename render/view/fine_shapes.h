// Meshes of a vehicle that is large on the screen: rounded edges with smooth normals. Axes and units as in shapes.h.
//
// Measures (m, of the standard vehicle of 1.0 m by 0.7 m): body 0.98 long and 0.52 wide between the wheels, bevel 0.08.
#pragma once

#include "render/view/shapes.h"

namespace braitenlab::render {

// A rounded body: a wedge-shaped nose for predators, a round one for prey, a blunt one for other roles. On it: a dark
// deck below the wires (Paint::inlay), the terminals of the motors (Paint::light) and the energy gauge.
Shape fine_hull_shape(Role);

// A wheel of radius 1 with its axis along y from −0.5 to 0.5: a tyre with tread blocks and, on the left side, a hub
// with holes that make the rotation visible. The right side is open, because the hull hides it.
Shape tyre_shape();

inline constexpr int tread_blocks = 20;

// A ball of radius 1 with its lens along +x, on a dark collar below it (Paint::dark).
Shape eyeball_shape();

// A source of a channel as in source_shape(), with smooth surfaces: a bulb on a ribbed socket, a flame in a bowl for
// heat, a blossom for smell, bubbles for oxygen.
Shape fine_source_shape(Channel);

}  // namespace braitenlab::render
