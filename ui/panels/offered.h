// Which controls the open exercise offers, and what it hides until the student has made the prediction.
#pragma once

#include "core/lesson/submission.h"
#include "ui/lab_view.h"

namespace braitenlab::ui {

// False outside an exercise, in free play, and in an exercise that offers all controls.
inline bool offers_some(const LabView& view) {
    return view.lesson && !view.lesson->free_play && !offers_all(*view.lesson->exercise);
}

// True for a control that is shown: a dial, or one of offer_parts.
template <class Control>
bool is_offered(const LabView& view, Control control) {
    return !offers_some(view) || offers(*view.lesson->exercise, control);
}

// True while the prediction is asked and neither made nor shown by a run: nothing may tell the outcome.
inline bool hides_outcome(const LabView& view) {
    return view.lesson && !view.lesson->exercise->prediction.options.empty() && view.lesson->prediction < 0 &&
           !view.lesson->outcome_known;
}

// True while also the wires may not be shown.
inline bool hides_brain(const LabView& view) {
    return hides_outcome(view) && view.lesson->exercise->prediction.hides_brain;
}

}  // namespace braitenlab::ui
