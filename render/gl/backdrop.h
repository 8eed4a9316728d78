// The picture of the ground, stored while it does not change.
//
// The floor with its grid is most of a picture's pixels and a third of its cost on a software renderer. While the
// camera rests, the ground is drawn once into a texture and copied behind everything else in later frames.
#pragma once

#include <optional>

#include "render/gl/frame.h"
#include "render/gl/texture.h"

namespace braitenlab::render {

class Backdrop {
public:
    // Creates all GL objects. Precondition until destruction: a current GL context.
    Backdrop();
    Backdrop(const Backdrop&) = delete;
    Backdrop& operator=(const Backdrop&) = delete;
    ~Backdrop();

    enum class Ground {
        moves,  // differs from the last frame: draw it directly
        rests,  // same as in the last frame: draw it into the backdrop now
        kept,   // the backdrop holds it
    };
    // Call it once per frame.
    Ground look(const FrameBlock&);

    // Draw calls between these two draw into the backdrop, with a viewport of its size. end_painting() restores the
    // framebuffer and the viewport.
    void begin_painting();
    void end_painting();

    // Discards the stored picture, for example after the shaders have changed.
    void forget();

    void bind() const { picture_.bind(); }

private:
    std::optional<FrameBlock> last_, painted_;  // from ground_of()
    Texture picture_{Texture::Kind::picture, 1, 1};
    unsigned framebuffer_ = 0;
    int width_ = 0, height_ = 0;  // of the picture, px
    int bound_before_ = 0, viewport_before_[4] = {};
};

}  // namespace braitenlab::render
