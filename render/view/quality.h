// Chooses the level of quality and the resolution from measured frame times.
#pragma once

#include "render/view/picture.h"

namespace braitenlab {

// Steps down as soon as frames are slow, and up after many fast ones. A level that has been too slow is not chosen
// again until start_over().
class QualityChoice {
public:
    // Begins with this level and all pixels.
    explicit QualityChoice(Quality first = Quality::medium) : first_(first), level_(first) {}

    Quality level() const { return level_; }

    // Pixels drawn per pixel of the window, in width and in height: less than 1 where low quality is very slow too, as
    // on a software renderer in a browser.
    float resolution() const { return coarse_ ? coarse_resolution : 1; }

    // True if this frame's time shall be measured: a measurement waits for the graphics hardware, so few frames are.
    // `copied`: the last frame was a copy at rest. Fewer are then measured, because a measured frame is drawn; none at
    // the lower resolution, at which it would look different.
    bool measures(int frame, bool copied = false) const {
        if (copied) return !coarse_ && frame % frames_between_if_copied == 0;
        return frame % (coarse_ ? frames_between_if_coarse : frames_between) == 0;
    }

    // The time of drawing a scene at level(), s.
    void add(double seconds);

    // For another scene.
    void start_over() { *this = QualityChoice(first_); }

    static constexpr int frames_between = 8;
    static constexpr int frames_between_if_copied = 64;
    static constexpr int frames_between_if_coarse = 60;  // each measurement stops such a slow machine for a moment
    static constexpr double slow = 0.030, fast = 0.005;  // s
    // With widgets a scene of 60 ms gives 12 pictures a second. In software a quarter of the pixels takes about half of
    // the time, because it is enlarged, so the limits are more than a factor of 2 apart.
    static constexpr double very_slow = 0.060, fast_if_coarse = 0.025;  // s
    static constexpr float coarse_resolution = 0.5f;

private:
    Quality first_, level_, highest_ = Quality::high;
    int slow_in_a_row_ = 0, fast_in_a_row_ = 0;
    bool coarse_ = false;
};

}  // namespace braitenlab
