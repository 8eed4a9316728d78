// A still picture in a texture of its own, for lists of scenes.
#pragma once

#include <cstdint>
#include <vector>

#include "render/gl/renderer.h"
#include "render/gl/texture.h"

namespace braitenlab::render {

class Still {
public:
    // Precondition until destruction: a current GL context.
    Still(int width, int height);

    // Draws the snapshot with Renderer::draw_still(). The picture's camera view must have the size of the still. The
    // bound framebuffer stays bound. False where the driver has no memory for it.
    bool draw(Renderer&, const Snapshot&, const Picture&);

    // RGBA, rows from the bottom.
    std::vector<std::uint8_t> pixels() const;
    void fill(const std::vector<std::uint8_t>&);

    unsigned texture() const { return texture_.id(); }
    int width() const { return width_; }
    int height() const { return height_; }

private:
    int width_, height_;
    Texture texture_;
};

}  // namespace braitenlab::render
