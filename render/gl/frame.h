// The uniform block `Frame` (std140) of shaders/common.glsl, member by member.
#pragma once

#include <array>

#include "render/view/draw_list.h"

namespace braitenlab::render {

struct FrameBlock {
    maths::mat4 view_projection;
    maths::vec4 eye;        // camera position, GL coordinates; w: pixels per metre where clip w is 1
    maths::vec4 right, up;  // of the picture, GL coordinates, for billboards
    maths::vec4 sun;        // unit vector to the sun, GL coordinates
    maths::vec4 sun_light, sky_light, ground_light;
    maths::vec4 sky, floor_colour, grid_colour;
    maths::vec4 ink, paper;  // darkest and lightest colour of objects in this theme
    maths::vec4 shadow;
    maths::vec4 window;  // width, height of the picture, pixels; its lower left corner in the framebuffer
    maths::vec4 arena;   // half the width, half the height, m; simulated seconds; display pixels per layout pixel
    maths::vec4
        counts;  // x: lamps; y: 1 in the light theme; z: how far sensor fields reach beyond the arena, m; w: boundary
    maths::vec4 form;  // x: 1 if the arena is an ellipse; y: scale_of() the arena; z, w: m between lines, their width
    maths::vec4 law;   // 1/half_distance², 1/range² of the light law; lamps that light the floor; Quality
    std::array<Lamp, most_lamps> lamps;
};
static_assert(sizeof(FrameBlock) == 64 + 18 * 16 + most_lamps * 32);

FrameBlock frame_block(const Snapshot&, const Picture&, const DrawList&);

// The block for the same picture with `share` times the pixels in width and in height, at 0, 0 of its framebuffer.
FrameBlock at_resolution(FrameBlock, float share);

}  // namespace braitenlab::render
