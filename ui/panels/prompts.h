// Prompts: the highlighted widget and the hint for a beginner's next step. A prompt ends when the step is done.
#pragma once

#include <string>
#include <string_view>

#include "ui/lab_view.h"
#include "ui/panels/prompt_state.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

// Call once a frame.
Prompt next_prompt(PromptMemory&, const LabView&);

// True for the anchor of a slider of the brain.
bool is_slider(std::string_view anchor);

// The key of a few words for what the user may change now: what pulses, if it is a slider, the wiring, a sensor or the
// children, else what the exercise offers first, or the answer while the prediction is asked for. They fill the gap of
// the hint.* texts that have one; those of a slider have a gap for its key.
std::string_view next_change(const LabView&, std::string_view pulsing = {});

// For Ui::pulse: 0..1 with a period of 1.5 s; 1 where motion is reduced.
float pulse(const LabView&);

// Draws a pulsing ring around that lamp while Ui::highlight names it.
void point_to_lamp(const LabView&, Ui&);

}  // namespace braitenlab::ui
