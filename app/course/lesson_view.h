// What the panels see of the open exercise, and what may be shown now.
#pragma once

#include "app/lab.h"
#include "core/lesson/disclosure.h"

namespace braitenlab {

// What may be shown at the displayed tick, of the open exercise, the page of a lecture or a scene.
Disclosure disclosure_of(const Lab&);

// True for a kind whose brains are hidden by the scene or by the exercise.
bool is_secret(const Lab&, int kind);

// True if this vehicle's brain drives it and may be shown now.
bool shows_driving_brain(const Lab&, const Disclosure&, const VehicleView&);

// Precondition: an exercise is open. Points into it.
LessonView lesson_view_of(const Lab&);

}  // namespace braitenlab
