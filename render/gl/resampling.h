// A framebuffer with more or fewer samples than the window has pixels: for smooth edges, or for slow graphics.
#pragma once

#include <optional>

#include "render/gl/offscreen.h"
#include "render/view/camera.h"

namespace braitenlab::render {

class Resampling {
public:
    // Precondition: the window's framebuffer is bound; until destruction: a current GL context.
    Resampling();

    // Draw calls until end() draw with several samples. `window`: the part that is drawn, px.
    // False, and nothing changes, where the bound framebuffer has samples or the driver allows none or has no memory.
    bool begin_smooth(const Rect& window);
    // Draw calls until end() draw a picture of `share` times the width and height of `window`, at 0, 0, with a viewport
    // of its size. False, and nothing changes, where the bound framebuffer has samples or there is no memory.
    bool begin_coarse(const Rect& window, float share);
    // Binds the framebuffer that was bound at the beginning, and copies the smooth picture into it. Does nothing if no
    // beginning was successful.
    void end();
    // The picture after begin_coarse() and end(), to be enlarged.
    const Texture& coarse() const { return target_->colours(); }

    // Samples per pixel of the window; 0: no multisampling.
    int samples_of_window() const { return samples_of_window_; }

private:
    bool begin(int width, int height, int samples);

    std::optional<Offscreen> target_;  // kept from frame to frame
    int most_samples_ = 0, samples_of_window_ = 0;
    Rect window_;  // px
    bool active_ = false;
};

}  // namespace braitenlab::render
