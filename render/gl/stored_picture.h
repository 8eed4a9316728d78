// A picture that is drawn once and copied in later frames.
//
// The floor with its grid covers most pixels of a scene and takes a third of its time on a software renderer. While the
// camera does not move, the ground is drawn once into a picture; later frames begin with a copy of it. While nothing
// moves at all, as in a pause, the same holds for the whole scene. For Mesa's software renderer a copy is one of
// memory, which takes a seventh of the time of a shader that reads a texture, if both have the same format and the same
// order of rows: a window begins with the upper row, a framebuffer object with the lower one.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "render/gl/frame.h"
#include "render/gl/texture.h"
#include "render/view/camera.h"

namespace braitenlab::render {

// The frame block with the values cleared that the ground does not depend on: time and lamps that do not light it.
FrameBlock ground_of(FrameBlock);

class StoredPicture {
public:
    // Creates all GL objects. Precondition until destruction: a current GL context.
    // `frames_of_rest`: the content rests after this many frames that are equal to the one before them.
    explicit StoredPicture(int frames_of_rest = 1);
    StoredPicture(const StoredPicture&) = delete;
    StoredPicture& operator=(const StoredPicture&) = delete;
    ~StoredPicture();

    enum class Content {
        moves,  // the content differs from that of the last frames: draw it directly
        rests,  // the content is that of the last frames: store it now
        kept,   // the stored picture has the content of this frame
    };
    // The state of the content in this frame. Call once per frame. `instances`: a hash of what the content consists of
    // beyond the frame block.
    Content look(const FrameBlock&, std::uint64_t instances = 0);

    // Draw calls between begin_painting() and end_painting() draw into the stored picture, with a viewport of its size
    // and the frame block that begin_painting() returns. end_painting() restores the framebuffer and the viewport.
    FrameBlock begin_painting();
    void end_painting();
    // Copies the colours of the bound framebuffer into the stored picture.
    void store();

    // Copies these parts of the stored picture, in its pixels with y down, into the bound framebuffer: colours only.
    // Precondition: a buffer of it has been cleared in this frame. WebGL erases the canvas at the first clear or draw
    // call of a frame, and a copy is neither.
    void copy(std::span<const Rect> parts) const;

    // Discards the stored picture, for example after the shaders have changed.
    void forget();

private:
    struct Key {
        FrameBlock frame;
        std::uint64_t instances;
    };
    static bool same(const std::optional<Key>&, const Key&);
    void fit();

    std::optional<Key> last_, stored_;
    int frames_of_rest_, rested_ = 0;
    bool mirrored_ = false;  // the upper row is the first one, because the window is drawn into
    Texture picture_{Texture::Kind::picture, 1, 1};
    unsigned framebuffer_ = 0;
    int width_ = 0, height_ = 0;               // of the picture, px
    int bound_ = 0, viewport_before_[4] = {};  // framebuffer of this frame
};

}  // namespace braitenlab::render
