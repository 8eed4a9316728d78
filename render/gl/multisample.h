// A framebuffer with several samples per pixel, for smooth edges where the window has none.
#pragma once

#include "render/view/camera.h"

namespace braitenlab::render {

class Multisample {
public:
    // Creates all GL objects. Precondition until destruction: a current GL context.
    Multisample();
    Multisample(const Multisample&) = delete;
    Multisample& operator=(const Multisample&) = delete;
    ~Multisample();

    // Draw calls between begin() and end() draw with several samples; end() copies the picture into the framebuffer
    // that was bound at begin() and binds it. Does nothing where the bound framebuffer has samples or the driver allows
    // none or has no memory for it. `window`: the part that is drawn, px.
    void begin(const Rect& window);
    void end();

private:
    unsigned framebuffer_ = 0, colours_ = 0, depths_ = 0;
    int width_ = 0, height_ = 0;  // px
    int samples_ = 0;
    int bound_before_ = 0;
    Rect window_;
    bool active_ = false;
};

}  // namespace braitenlab::render
