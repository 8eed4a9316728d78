// Resets of the run, and what an exercise gives back with one. Without an open exercise a function does nothing, unless
// its comment says otherwise.
#pragma once

#include "app/lab.h"

namespace braitenlab {

// Gives the subject's kind a submission of the exercise, in one step of undo, and resets the run. False if the kind was
// removed.
bool give_submission(Lab&, const Submission&);

// Gives the subject's kind the exercise's solution, in one step of undo, and resets the run.
void show_solution(Lab&);

// Resets the run; see Session::reset. Works for every document.
void reset(Lab&);
void reset(Lab&, std::uint64_t seed);  // with another seed

// Takes every change of the student back and resets the run; undo brings the changes back. The prediction, the opened
// hints and the notes stay; the prediction may be changed again. Without an exercise: reset().
void start_over(Lab&);

// As start_over(), and the prediction and the hints are as on opening: for another student.
void restart_exercise(Lab&);

}  // namespace braitenlab
