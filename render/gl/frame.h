// What every shader knows of a frame: the std140 block `Frame` of shaders/common.glsl, member by member.
#pragma once

#include <array>

#include "render/view/draw_list.h"

namespace braitenlab::render {

struct FrameBlock {
    maths::mat4 view_projection;
    maths::vec4 eye;        // GL coordinates; w: pixels a metre where clip w is 1
    maths::vec4 right, up;  // of the picture, GL coordinates, for billboards
    maths::vec4 sun;        // towards it, GL coordinates
    maths::vec4 sun_light, sky_light, ground_light;
    maths::vec4 sky, floor_colour, grid_colour;
    maths::vec4 ink, paper;  // text and ground of the theme: the darkest and lightest that things wear
    maths::vec4 shadow;
    maths::vec4 window;  // width, height of the picture, pixels; its left lower corner in the framebuffer
    maths::vec4 arena;   // half the width, half the height, m; simulated seconds; display pixels a layout pixel
    maths::vec4 counts;  // x: lamps; y: 1 in the light theme; z: how far one sees beyond the arena, m; w: its edge
    std::array<Lamp, most_lamps> lamps;
};
static_assert(sizeof(FrameBlock) == 64 + 16 * 16 + most_lamps * 32);

FrameBlock frame_block(const Snapshot&, const Picture&, const DrawList&);

}  // namespace braitenlab::render
