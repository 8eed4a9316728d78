// The few solid things of the scene as small meshes: corners, directions, and which of its colours each part wears.
//
// World axes: x ahead, y left, z up; anticlockwise seen from outside. A hull is 1 long and 1 wide and in metres high,
// so that a body of any size scales it.
#pragma once

#include <cstdint>
#include <vector>

#include "core/maths/vec.h"
#include "core/scene/scene.h"

namespace braitenlab::render {

// What a part of a shape is painted as; the shaders know the same numbers.
enum class Paint { body, deck, dark, gauge, mark, light, inlay };

struct Corner {
    maths::vec3 place, normal;
    float paint = 0;
};

struct Shape {
    std::vector<Corner> corners;
    std::vector<std::uint16_t> indices;  // three a triangle
};

// Wedge-shaped nose for a predator, round at both ends for prey, square for others; wheel arches, a deck with an inlay
// for wires and an energy gauge. The arrowhead's corners are 0..1 along it and −1..1 across: the shader gives it size.
Shape hull_shape(Role);

// A whole vehicle as a flat outline, for one that is small on the screen: 1 long and 1 wide, with a rim round that.
// Paint says how far inside the outline a corner is; the shader draws the rim, wheels, eyes and arrowhead onto it.
Shape sign_shape(Role);

// A line round the silhouette of a hull with its wheels, and what it encloses. Normals point outwards, z says how far a
// corner of the outline stands out (1 on a straight side) and paint what a corner belongs to: 0 the line's foot, 1 its
// edge, 2 where it has faded, 3 the ground below the vehicle.
Shape rim_shape(Role);

// Radius 1, axis along y, from y = −0.5 to 0.5, open on its right, where the hull hides it. Some lugs of the tread and
// the spokes are lighter, so that turning shows.
Shape wheel_shape();

// A ball of radius 1 whose lens looks along +x.
Shape eye_shape();

// What stands for a source of a channel, in metres, on the floor's origin: a lamp for light, a brazier for heat, a
// blossom for smell, bubbles for oxygen.
Shape source_shape(Channel);

}  // namespace braitenlab::render
