// A prompt, and what the prompts store between frames.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/brain/graph.h"
#include "core/scene/scene.h"

namespace braitenlab::ui {

struct Prompt {
    std::string_view anchor;  // widget to use next; empty: none. Points into the exercise, the memory or to a constant
    std::string_view hint;    // key of the words for the hint bar; empty: the usual hint of the mode
};

// Anchor of the first lamp that the selected vehicle senses, recorded by point_to_lamp().
inline constexpr std::string_view lamp_anchor = "stage.lamp";

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

// The widget that pulses; see prompts.h.
struct Highlight {
    std::string anchor;    // in the last frame
    std::string hint;      // key of its words in the hint bar
    bool reveals = false;  // its card has not yet scrolled to it
};

// A brain and the sensors with which a run began.
struct TriedBrain {
    std::shared_ptr<const BrainGraph> brain;  // never null
    std::vector<Sensor> sensors;
};

// State of the prompts for one opened file.
struct PromptMemory {
    std::string opened;
    PromptsFollowed followed{};  // these two are kept when another file is opened
    Highlight highlight{};
    bool played = false;
    bool slider_known = false;                   // a slider was turned, or the run is long enough
    Suggested lamp, wiring, timeline;            // of free play, in this order
    int edits_before_wiring = -1;                // number of edits when the wiring was opened; −1: it is closed
    int hint = 0, edits_before_hint = 0;         // number of hints shown, and of edits when the last one came
    int runs_before_hint = 0;                    // the same of runs
    double blind_since = -1, still_since = -1;   // simulated seconds; negative: it sees a stimulus or stands; it moves
    double dark_since = -1;                      // the same; negative: it sees a stimulus
    std::optional<TriedBrain> at_start, failed;  // of the student's vehicle; nullopt: opened later, none has failed
    std::shared_ptr<const void> failed_base{};   // the breeding on its sheet when `failed` did, null: none
    int failed_generation = -1;                  // its last complete generation then
    std::string cell{};                          // anchor of the cell of the matrix that was suggested last
    bool has_begun = false;                      // the run is after its start
    bool halted_blind = false;                   // it rested without a stimulus in this run, at the start in the last
    std::vector<float> most_read;                // by each of its sensors in this run, at the start in the last one
    std::optional<std::uint64_t> past;           // tick to which a paused run went back
};

}  // namespace braitenlab::ui
