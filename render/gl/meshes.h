// Meshes whose corners hold numbers; the shaders compute the positions.
#pragma once

#include "render/view/shapes.h"

namespace braitenlab::render {

Shape quad();              // x and y −1..1
Shape strip(int squares);  // squares in a row along x from 0 to 1, y from −1 to 1
Shape fan();               // x: number of the corner 0..3, for field.vert

// prism(): sides, chamfer and top of a prism of up to eight corners, for block.vert: x: number of the edge, y: its end
// 0 or 1, z: level. skirt(): the shadow around its feet.
Shape prism();
Shape skirt();

}  // namespace braitenlab::render
