// The meshes that only number their corners: the shaders place them.
#pragma once

#include "render/view/shapes.h"

namespace braitenlab::render {

Shape quad();              // x and y −1..1
Shape strip(int squares);  // squares in a row along x from 0 to 1, y from −1 to 1
Shape fan();               // x is the corner's number 0..3, as field.vert wants it

// The sides, the chamfer and the top of a prism of up to eight corners, as block.vert wants them: x is the edge's
// number, y its end, z the level; and the shadow round its feet.
Shape prism();
Shape skirt();

}  // namespace braitenlab::render
