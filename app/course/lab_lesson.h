// The open exercise: its referee, its hints and its reset. Without an open exercise a function does nothing, unless its
// comment says otherwise.
#pragma once

#include "app/lab.h"

namespace braitenlab {

inline constexpr double seconds_between_hints = 30;  // after which the next hint is available without a run

// Notes that the run has shown what the prediction asks for. Call after the session has moved to another tick.
void watch(Lab&);

// Call once per turn, after Jobs::deliver. When every step is done, grades the submission from all starts in the
// background and writes progress and grade to the lesson. An edit of the submission cancels grading and hides
// the grade of the earlier submission; if every step is still done, grading starts again. If the graded submission
// comes back, for example by undo, so does its grade.
void update_grading(Lab&, Jobs&);

void show_hint(Lab&);

// Keeps an option or a path as the prediction while it can be made or changed, see Disclosure::open_prediction.
void predict(Lab&, const PredictRequest&);
void predict(Lab&, const PredictPathRequest&);

// Shows the run with the solution beside the student's, or ends it. Nothing is shown before the prediction is made and
// before a run; see Disclosure::solution_run.
void compare(Lab&, const CompareRequest&);
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
