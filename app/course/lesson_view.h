// What the panels see of the open exercise, and what may be shown now.
#pragma once

#include "app/workspace.h"
#include "core/lesson/disclosure.h"

namespace braitenlab {

inline constexpr double seconds_between_hints = 30;  // after which the next hint is available without a run

// What may be shown at the displayed tick, of the open exercise, the page of a lecture or a scene.
Disclosure disclosure_of(const Workspace&);

// True for a kind whose brains are hidden by the scene or by the exercise.
bool is_secret(const Workspace&, int kind);

// True if this vehicle's brain drives it and may be shown now.
bool shows_driving_brain(const Workspace&, const Disclosure&, const VehicleView&);

// Notes that the run has shown what the prediction asks for. Call after the session has moved to another tick. Without
// an open exercise does nothing.
void watch(Workspace&);

// Precondition: an exercise is open. Points into it.
LessonView lesson_view_of(const Workspace&);

}  // namespace braitenlab
