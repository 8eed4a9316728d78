// Keys for the prediction of the open exercise.
#pragma once

#include "ui/lab_view.h"
#include "ui/panels/panel_state.h"
#include "ui/request.h"
#include "ui/shortcuts.h"

namespace braitenlab::ui {

// While the prediction is not made (in a lecture: never), 1 to 9 choose an answer; afterwards they select sliders.
// While it can be changed, Space chooses the answer that has a visible focus and is not chosen yet; else, and so at the
// second press, it plays. True if the key is handled.
bool key_for_prediction(const LabView&, PanelState&, KeyPress, Outbox&);

}  // namespace braitenlab::ui
