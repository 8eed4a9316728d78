// A slider for one number: a track filled from 0, a knob, and the number, which can be typed.
//
// Mouse: dragging moves the knob (with Shift ten times finer); a right click restores the home value; a double click or
// Ctrl+click edits the number. Keys: ← and → move by a nudge, with Shift by the smallest step; Del restores; Enter
// edits the number. A typed number is kept as it is typed, also between two steps, and may have its unit or one of the
// same kind ("35 cm/s"); outside the range it is clamped, with a notice. Other text changes nothing, with a notice.
//
// A wide track serves a range of several powers of ten, such as 0.05 .. 1000: it is linear within ± SliderLook::knee
// and logarithmic beyond. The mouse and the arrow keys then give numbers of three digits, in steps that grow with the
// value.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "ui/widgets/ui.h"

namespace braitenlab::ui {

// State of all sliders of the window. At most one slider is dragged or edited at a time.
struct SliderState {
    std::string dragged;        // anchor of the dragged slider
    float grip = 0;             // knob minus pointer, window pixels
    float asked = 0;            // last value returned in this gesture
    float pressed_at = 0;       // the value when the mouse went down
    std::string pressed;        // anchor of the slider at that time
    std::uint64_t gesture = 0;  // last gesture number used
    std::string nudged;         // anchor of the slider moved by keys; presses within a second are one gesture
    double nudged_at = 0;       // wall seconds
    double set_at = -1;         // wall seconds of the last edit other than a drag; negative: none yet
    std::string typed;          // anchor of the slider being edited
    char text[24] = {};
    std::string opened_text;               // at first; leaving it as it is changes nothing
    bool text_opened = false;              // its text field is active
    bool text_drawn = false;               // in this frame
    bool commit = false, give_up = false;  // Enter and Esc while typing, set by press_key
};

// Ends typing and dragging at a slider that is not drawn any more, for instance because its vehicle is gone: its text
// field would take every key. Call once a frame after all sliders.
void keep_drawn(SliderState&);

// Gesture number of the edit by keys, by typing or by a right click that was made less than a second ago; 0: none was.
// Call after the sliders of the frame have been drawn.
std::uint64_t gesture_by_keys(const SliderState&, double wall_seconds);

inline constexpr float slider_height = 28;  // layout pixels

struct SliderLook {
    std::string_view words;  // "LL"
    std::string_view tooltip;
    float low = -2, high = 2;       // filled from 0 when 0 is between them, else from `low`
    float home = 0;                 // value restored by a right click
    float step = 0.01f;             // 1/n; mouse and arrow keys give multiples
    float mouse = 5;                // steps per movement of the mouse; with Shift one
    float nudge = 5;                // steps per press of an arrow key; with Shift one
    int decimals = 2;               // shown at least, up to 4 where the value has them; 10^-decimals <= step
    bool whole = false;             // a count: typed numbers are rounded
    std::string_view unit{};        // after the number, with its space: " m", "°"
    std::string_view typed_unit{};  // of typed numbers, where `unit` is not shown
    bool signed_number = true;
    bool wide = false;                          // the track is logarithmic beyond ± knee
    float knee = 1;                             // above 0
    bool trimmed = false;                       // the number is shown without trailing zeros
    bool meaning = true;                        // orange above 0, blue below; else grey
    float words_width = 26, number_width = 46;  // layout pixels
    float height = slider_height;               // layout pixels
};

struct SliderEdit {
    float value = 0;            // within low..high, finite
    std::uint64_t gesture = 0;  // the same for all edits of one drag
};

// Draws the slider at the cursor, `width` window pixels wide. Returns the edit made in this frame.
std::optional<SliderEdit> slider(Ui&, SliderState&, std::string_view id, float value, float width, double wall_seconds,
                                 const SliderLook&);

}  // namespace braitenlab::ui
