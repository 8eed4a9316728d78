// Cache of the picture of the ground.
//
// The floor with its grid covers most pixels of a picture and takes a third of its time on a software renderer. While
// the camera does not move, the ground is drawn once into a picture; later frames begin with a copy of the picture.
// For Mesa's software renderer that is a copy of memory, which takes a seventh of the time of a shader that reads a
// texture, if both have the same format and the same order of rows: a window begins with the upper row, a framebuffer
// object with the lower one.
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
        moves,  // the ground differs from that of the last frame: draw it directly
        rests,  // the ground is that of the last frame: draw it into the backdrop now
        kept,   // the backdrop contains the ground of this frame
    };
    // The state of the ground in this frame. Call once per frame.
    Ground look(const FrameBlock&);

    // Draw calls between begin_painting() and end_painting() draw into the backdrop, with a viewport of its size and
    // the frame block that begin_painting() returns. end_painting() restores the framebuffer and the viewport.
    FrameBlock begin_painting();
    void end_painting();

    // Copies the picture into the bound framebuffer: colours only.
    void copy() const;

    // Discards the stored picture, for example after the shaders have changed.
    void forget();

private:
    std::optional<FrameBlock> last_, painted_;  // from ground_of()
    bool mirrored_ = false;                     // the upper row is the first one, because the window is drawn into
    Texture picture_{Texture::Kind::picture, 1, 1};
    unsigned framebuffer_ = 0;
    int width_ = 0, height_ = 0;               // of the picture, px
    int bound_ = 0, viewport_before_[4] = {};  // framebuffer of this frame
};

}  // namespace braitenlab::render
