// Chooses the level of quality from measured frame times.
#pragma once

#include "render/view/picture.h"

namespace braitenlab {

// Steps down as soon as frames are slow, and up after many fast ones. A level that has been too slow is not chosen
// again until start_over().
class QualityChoice {
public:
    Quality level() const { return level_; }

    // True if this frame's time shall be measured: a measurement waits for the graphics hardware, so few frames are.
    bool measures(int frame) const { return frame % frames_between == 0; }

    // The time of drawing a scene at level(), s.
    void add(double seconds);

    // For another scene.
    void start_over() { *this = {}; }

    static constexpr int frames_between = 8;
    static constexpr double slow = 0.030, fast = 0.005;  // s

private:
    Quality level_ = Quality::medium, highest_ = Quality::high;
    int slow_in_a_row_ = 0, fast_in_a_row_ = 0;
};

}  // namespace braitenlab
