// A slider for one number: a track filled from its zero, a knob, and the number, which can be typed.
//
// Dragging moves the knob (with Shift ten times finer), a right click brings back the value it came with, a double
// click or Ctrl+click opens the number for typing; with the keyboard ← and → move it by a nudge, with Shift by the
// smallest step, Del brings back, and Enter opens the number. What is typed is clamped; what is no number changes
// nothing.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "ui/widgets/ui.h"

namespace braitenlab {

// What the sliders of the window remember between frames: at most one is dragged or typed into.
struct SliderState {
    std::string dragged;        // anchor of the one that the mouse holds
    float grip = 0;             // knob minus pointer at press, in units of the value
    float asked = 0;            // last value given out in this gesture
    float pressed_at = 0;       // the value when the mouse went down
    std::string pressed;        // and the anchor it went down on
    std::uint64_t gesture = 0;  // last gesture number used
    std::string nudged;         // anchor of the one that keys move; quick presses are one gesture
    double nudged_at = 0;       // wall seconds
    std::string typed;          // anchor of the one that is typed into
    char text[16] = {};
    bool text_opened = false;              // it has got the cursor
    bool commit = false, give_up = false;  // Enter and Esc while typing, set by press_key
};

struct SliderLook {
    std::string_view words;  // "LL"
    std::string_view tooltip;
    float low = -2, high = 2;  // filled from 0 when that lies between, else from `low`
    float home = 0;            // what a right click brings back
    float step = 0.01f;        // 1/n: every value is a multiple of it; the mouse moves in fives, a nudge is ten
    int decimals = 2;          // shown; 10^-decimals is not above `step`
    std::string_view unit{};   // after the number, with a space where it wants one: " m", "°"
    bool signed_number = true;
    bool meaning = true;                        // orange above 0, blue below; else the quiet colour
    float words_width = 26, number_width = 46;  // layout pixels
};

struct SliderEdit {
    float value = 0;            // within low..high, finite, rounded to the step
    std::uint64_t gesture = 0;  // the same for all edits of one drag
};

// Draws the slider at the cursor, `width` window pixels wide. Returns what the person made of the value in this frame.
std::optional<SliderEdit> slider(Ui&, SliderState&, std::string_view id, float value, float width, double wall_seconds,
                                 const SliderLook&);

inline constexpr float slider_height = 28;  // layout pixels

}  // namespace braitenlab
