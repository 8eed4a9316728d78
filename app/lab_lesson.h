// The open exercise: its referee, its hints, and its reset. Each function does nothing where no exercise is open,
// except where it says otherwise.
#pragma once

#include "app/lab.h"

namespace braitenlab {

// Shows the current moment to the referee and its verdicts to the panels.
void watch(Lab&);

// Tells the referee that the user has applied this command.
void tell_referee(Lab&, const Command&);

// Call once per turn, after Jobs::deliver. Once every step is done, grades the submission from all starts in the
// background; shows progress and grade in the lesson's view. An edit of the submission cancels grading, and starts it
// again while every step is done.
void update_grading(Lab&, Jobs&);

void show_hint(Lab&);

// Resets the run; see Session::reset. Works for every document.
void reset(Lab&);

// Resets the run, the brains and the progress to their state on opening. Without an exercise: reset().
void restart_exercise(Lab&);

}  // namespace braitenlab
