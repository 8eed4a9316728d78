// What the prompts suggest in an exercise that is solved by breeding.
#pragma once

#include "ui/lab_view.h"
#include "ui/panels/prompt_state.h"

namespace braitenlab::ui {

// The next step: start the breeding, wait, take the champion, reset, play. A hint, or a champion that has failed, leads
// to other opponents first.
Prompt of_breeding(const PromptMemory&, const LabView&);

}  // namespace braitenlab::ui
