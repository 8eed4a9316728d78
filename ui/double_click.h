// Double clicks by the time of the presses. Dear ImGui 1.86 sees the buttons once a frame and measures the time between
// two presses by frames.
#pragma once

#include <cmath>

namespace braitenlab::ui {

// Most time between the presses of a double click, as on common desktops, and their largest distance in window pixels.
inline constexpr double double_click_seconds = 0.5;
inline constexpr double double_click_reach = 6;

class DoubleClick {
public:
    // A press of the left button. True if it completes a double click; the next press then begins another one.
    bool press(double seconds, double x, double y) {
        const bool twice =
            seconds - pressed_at_ <= double_click_seconds && std::hypot(x - x_, y - y_) <= double_click_reach;
        pressed_at_ = twice ? never : seconds;
        x_ = x, y_ = y;
        return twice;
    }

private:
    static constexpr double never = -1e9;
    double pressed_at_ = never, x_ = 0, y_ = 0;
};

}  // namespace braitenlab::ui
