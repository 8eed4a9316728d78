// Meshes of the scene's objects: corners with normal and paint.
//
// Axes: x ahead, y left, z up; triangles are counter-clockwise from outside. A hull has length 1 and width 1, scaled by
// the body; its height is in metres.
#pragma once

#include <cstdint>
#include <vector>

#include "core/maths/vec.h"
#include "core/scene/scene.h"

namespace braitenlab::render {

// The colour of a part. Same numbers in shaders/common.glsl.
enum class Paint { body, deck, dark, gauge, mark, light, inlay };

struct Corner {
    maths::vec3 place, normal;
    float paint = 0;
};

struct Shape {
    std::vector<Corner> corners;
    std::vector<std::uint16_t> indices;  // three per triangle
};

// Coarse meshes have no chamfers and fewer facets: for vehicles on whose picture these are about a pixel wide.
enum class Mesh { full, coarse };

// A hull: a wedge-shaped front for predators, round ends for prey, square ends for other roles. It has wheel arches, a
// deck with an inlay below the wires, an energy gauge and an arrowhead. The corners of the arrowhead are 0..1 along and
// −1..1 across; the shader scales them.
Shape hull_shape(Role, Mesh = Mesh::full);

// A flat outline of length 1 and width 1 with a rim, for a vehicle that is small on the screen. `paint` is the distance
// inside the outline. The shader draws rim, wheels, sensors and arrowhead.
Shape sign_shape(Role);

// A line around the silhouette of a hull with its wheels, and the area inside it. Normals point outwards. z is the
// mitre factor of the corner (1 on a straight side). `paint`: 0 inner side of the line, 1 outer side, 2 end of its
// fade, 3 area inside.
Shape rim_shape(Role);

// A wheel of radius 1 with its axis along y from −0.5 to 0.5. The right side is open, because the hull hides it.
// Lighter lugs and spokes make the rotation visible.
Shape wheel_shape(Mesh = Mesh::full);

// A source of a channel, m, with its foot at the origin: a brazier for heat, a blossom for smell, bubbles for oxygen, a
// lamp for all other channels.
Shape source_shape(Channel);

}  // namespace braitenlab::render
