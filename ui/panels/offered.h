// Which controls the open exercise offers.
#pragma once

#include "core/lesson/submission.h"
#include "ui/lab_view.h"

namespace braitenlab::ui {

// False outside an exercise, in free play, and in an exercise that offers all controls.
inline bool offers_some(const LabView& view) {
    return view.lesson && !view.lesson->attempt.work.free_play && !offers_all(*view.lesson->exercise);
}

// True for a control that is shown: a dial, or offer_parts::curves and ::sensors. The wiring editor is always
// reachable; what it changes outside the offers is not graded.
template <class Control>
bool is_offered(const LabView& view, Control control) {
    return !offers_some(view) || offers(*view.lesson->exercise, control);
}

// True in an exercise that is solved by breeding.
inline bool is_bred(const LabView& view) { return view.lesson && !offered_breeding(*view.lesson->exercise).empty(); }

}  // namespace braitenlab::ui
