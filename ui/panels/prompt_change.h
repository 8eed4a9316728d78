// Which control the prompts suggest to change.
#pragma once

#include "ui/lab_view.h"
#include "ui/panels/prompt_state.h"

namespace braitenlab::ui {

// The first lamp that a sensor of the selected vehicle measures; null if there is none.
const SourceView* telling_lamp(const LabView&);

// A change that the user sees at once: of a weight, or of the stimulus if the sensors read nothing.
// (In an exercise a run with a moved lamp does not count.)
Prompt first_change(const LabView&);

// The control that gains most in the next run (LessonView::gains). Where none is known to, one of which another value
// makes the next run another one: as first_change() in an exercise, but judged by the most that the sensors have read
// in the run. A bias comes first where the vehicle came to rest without a stimulus,
// since no weight moves it from there; then a weight that has still the value of the file, then any bias or weight.
Prompt change_for_next_run(const PromptMemory&, const LabView&);

}  // namespace braitenlab::ui
