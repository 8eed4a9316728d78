// Prompts: the highlighted widget and the hint for a beginner's next step. A prompt ends when the step is done.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "ui/lab_view.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

struct Prompt {
    std::string_view anchor;  // widget to use next; empty: none. Points into the exercise or to a constant
    std::string_view hint;    // key of the words for the hint bar; empty: the usual hint of the mode
};

// A suggestion is shown once, for a limited time.
struct Suggested {
    bool known = false;  // followed or timed out
    double since = -1;   // wall seconds of its start; negative: not shown yet
};

// What the person has done at least once, in any file and at any earlier start: it is not suggested again.
struct PromptsFollowed {
    bool slider = false, lamp = false, wiring = false, timeline = false;
    friend bool operator==(const PromptsFollowed&, const PromptsFollowed&) = default;
};

// State of the prompts for one opened file.
struct PromptMemory {
    std::string opened;
    PromptsFollowed followed{};  // kept when another file is opened
    bool played = false;
    bool slider_known = false;                  // a slider was turned, or the run is long enough
    Suggested lamp, wiring, timeline;           // of free play, in this order
    int edits_before_wiring = -1;               // number of edits when the wiring was opened; −1: it is closed
    int hint = 0, edits_before_hint = 0;        // number of hints shown, and of edits when the last one came
    double blind_since = -1, still_since = -1;  // simulated seconds; negative: it sees a stimulus or stands; it moves
    double dark_since = -1;                     // the same; negative: it sees a stimulus
    std::shared_ptr<const BrainGraph> brain_at_start;  // of the single vehicle; null: the run was opened later
};

// Anchor of the first lamp that the selected vehicle senses, recorded by point_to_lamp().
inline constexpr std::string_view lamp_anchor = "stage.lamp";

// Call once a frame.
Prompt next_prompt(PromptMemory&, const LabView&);

// The key of a few words for what the user may change now: a slider, a wire, a sensor or a child, or the answer while
// the prediction is asked for. They fill the gap of the hint.* texts that have one.
std::string_view next_change(const LabView&);

// For Ui::pulse: 0..1 with a period of 1.5 s; 1 where motion is reduced.
float pulse(const LabView&);

// Draws a pulsing ring around that lamp while Ui::highlight names it.
void point_to_lamp(const LabView&, Ui&);

}  // namespace braitenlab::ui
