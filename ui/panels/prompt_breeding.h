// What the prompts suggest in an exercise that is solved by breeding.
#pragma once

#include "ui/lab_view.h"
#include "ui/panels/prompt_state.h"

namespace braitenlab::ui {

// The next step: play, start the breeding, wait, look at two cells of the matrix, take the champion, play; after it has
// failed, choose other opponents and breed again.
Prompt of_breeding(PromptMemory&, const LabView&);

}  // namespace braitenlab::ui
