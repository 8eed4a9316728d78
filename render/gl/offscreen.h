// A framebuffer of any size, for pictures that are larger than the window or must not disturb it.
#pragma once

#include <memory>
#include <vector>

#include "render/gl/texture.h"

namespace braitenlab::render {

class Offscreen {
public:
    // px, at least 1; samples per pixel, 0: one. ready() is false where the driver allows no such size or has no memory
    // for it.
    // Precondition until destruction: a current GL context.
    Offscreen(int width, int height, int samples = 0);
    Offscreen(Offscreen&&) noexcept;
    Offscreen& operator=(Offscreen&&) noexcept;
    ~Offscreen();

    bool ready() const { return ready_; }
    int width() const { return width_; }
    int height() const { return height_; }
    int samples() const { return samples_; }
    unsigned framebuffer() const { return framebuffer_; }

    // Draw calls between bind() and release() draw into it; release() binds what was bound at bind().
    void bind();
    void release();

    // Its colours. Precondition: ready, without samples.
    const Texture& colours() const { return *colours_; }
    // RGB, rows from the top. Precondition: without samples.
    std::vector<unsigned char> pixels() const;

    // The largest width and height that the driver allows, px.
    static int largest();

private:
    int width_, height_, samples_;
    unsigned framebuffer_ = 0, samples_of_colours_ = 0, depths_ = 0;
    std::unique_ptr<Texture> colours_;  // null with samples
    int bound_before_ = 0;
    bool ready_ = false;
};

}  // namespace braitenlab::render
