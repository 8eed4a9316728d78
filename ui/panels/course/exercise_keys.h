// Keys of the open exercise: answers of the prediction, Play before the prediction is made, and Enter once it is
// passed.
#pragma once

#include "ui/lab_view.h"
#include "ui/panels/panel_state.h"
#include "ui/request.h"
#include "ui/shortcuts.h"

namespace braitenlab::ui {

// True if 1 to 9 choose an answer wherever the focus is: not in a lecture, nor once a run with an answer has begun.
// Then they select sliders, also where the answer can still be changed, unless an answer has a visible focus.
// Precondition: view.lesson.
bool digits_choose_answer(const LabView&);

// While the prediction can be made or changed, 1 to 9 choose an answer as digits_choose_answer() tells.
// While it can be changed, Space chooses the answer that has a visible focus and is not chosen yet; else, and so at the
// second press, it plays. True if the key is handled.
bool key_for_prediction(const LabView&, PanelState&, KeyPress, Outbox&);

// Enter presses the button for the next exercise once this one is passed, unless another widget has a visible focus.
// True if the key is handled.
bool key_for_next_exercise(const LabView&, PanelState&, KeyPress);

// True if Play or a step is not carried out now, because the prediction is neither made nor skipped. The card then
// points to the question; the same action asked for again skips it. Never in a lecture, in free play and once the
// exercise has run.
bool holds_play(const LabView&, PanelState&, Action, Outbox&);

// True while the card points to the question.
bool is_play_held(const LabView&, const PanelState&);

// Forgets the held Play once the prediction is made or skipped. Call once a frame.
void follow_held_play(const LabView&, PanelState&);

}  // namespace braitenlab::ui
