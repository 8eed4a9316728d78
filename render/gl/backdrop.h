// The picture of the ground, kept for as long as it stays the same.
//
// The floor with its grid is most of a picture's pixels, and on a software renderer a third of its cost. While the
// camera rests it is the same in every frame: painted once, it is then laid behind everything.
#pragma once

#include <optional>

#include "render/gl/frame.h"
#include "render/gl/texture.h"

namespace braitenlab::render {

class Backdrop {
public:
    // Objects of the graphics library are made here alone; needs a current context for its whole life.
    Backdrop();
    Backdrop(const Backdrop&) = delete;
    Backdrop& operator=(const Backdrop&) = delete;
    ~Backdrop();

    enum class Ground {
        moves,  // another one than a frame ago: keeping it would not pay
        rests,  // the same for two frames: worth painting into the backdrop now
        kept,   // what the backdrop holds
    };
    // To be asked once a frame.
    Ground look(const FrameBlock&);

    // What is drawn between these two goes into the backdrop, from a viewport of its own size; the framebuffer that was
    // bound and its viewport come back at the end.
    void begin_painting();
    void end_painting();

    // As if nothing had been painted: its shaders have changed.
    void forget();

    void bind() const { picture_.bind(); }

private:
    std::optional<FrameBlock> last_, painted_;  // without what the ground does not show
    Texture picture_{Texture::Kind::picture, 1, 1};
    unsigned framebuffer_ = 0;
    int width_ = 0, height_ = 0;  // of the picture, pixels
    int bound_before_ = 0, viewport_before_[4] = {};
};

}  // namespace braitenlab::render
