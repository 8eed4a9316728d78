// Fingers as a mouse: one finger is the left button, two drag as the middle button, zoom as the wheel and turn the
// view. A finger that rests, or taps twice, is the right button where that opens a menu.
#pragma once

#include <deque>
#include <optional>

struct EmscriptenTouchEvent;

namespace braitenlab::web {

// What the fingers do in one frame. x, y: pixels of the page.
struct Touch {
    double x = 0, y = 0;  // of the finger, or between two
    int fingers = 0;
    bool holds = false, presses = false;
    float notches = 0;  // of the wheel, by the distance of two fingers
    float twist = 0;    // rad, by which two fingers have turned, counter-clockwise
};

class Touches {
public:
    // Adds an event of the page.
    void follow(int type, const EmscriptenTouchEvent&);

    // What the next frame gets; nullopt without a finger. A new finger first moves the pointer and is pressed a frame
    // later, as a mouse would, so that the widget below it is known.
    std::optional<Touch> take();

    // Where a right click opens a menu (`opens`), the place at which a finger asks for it, after all steps before:
    // the finger has rested for half a second, or has tapped twice. Once for each. `now`: ms, on the page's clock.
    struct Place {
        double x = 0, y = 0;  // pixels of the page
    };
    std::optional<Place> take_menu(double now, bool opens);

private:
    // A finger that is set or lifted alone, for take_menu().
    void begin_tap(Place, double now);
    void end_tap(double now);

    // Ends what the fingers do where they were last: a second finger must not drag the first one's object to their
    // middle.
    void lift();

    std::deque<Touch> steps_;
    Touch last_;
    bool is_over_ = false;             // one of two fingers was lifted: the other one does nothing until it is, too
    double distance_ = 0, angle_ = 0;  // between two fingers; of the line through them, rad

    std::optional<Place> tap_, menu_;  // where the finger was set, while it has not moved since; asked for
    Place last_tap_;
    double tapped_at_ = 0, last_tapped_at_ = -1e9;  // ms, at which tap_ was set; at which the last tap ended
};

}  // namespace braitenlab::web
