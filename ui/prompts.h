// What leads a newcomer to the next useful action, and goes away when it is done.
#pragma once

#include <string>
#include <string_view>

#include "ui/lab_view.h"

namespace braitenlab {

struct Prompt {
    std::string_view anchor;  // of the widget to use next, which pulses; empty: none. Lives as long as the exercise
    std::string_view hint;    // key of the words for the hint bar; empty: nothing beyond what the mode offers
};

// A suggestion that was made and has had its time: it does not come back.
struct Suggested {
    bool known = false;
    double since = -1;  // wall seconds; negative: not made yet
};

// What the window remembers of its suggestions, for one opened file.
struct PromptMemory {
    std::string opened;
    bool played = false;
    bool slider_known = false;                  // turned once, or watched for long enough
    Suggested lamp, wiring, timeline;           // of free play, in this order
    int edits_before_wiring = -1;               // how many there were when the wiring was opened; −1: it is not open
    int hint = 0, edits_before_hint = 0;        // the newest one, and how many edits there were when it came
    double blind_since = -1, still_since = -1;  // simulated seconds; negative: it sees something, it moves
};

// Over the lamp that can be dragged: point_to_lamp() in ui/panels lets it pulse.
inline constexpr std::string_view lamp_anchor = "stage.lamp";

// Call once a frame.
Prompt next_prompt(PromptMemory&, const LabView&);

// For Ui::pulse: 0..1, twice in three seconds; steady 1 where motion is reduced.
float pulse(const LabView&);

}  // namespace braitenlab
