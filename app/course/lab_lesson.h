// The open exercise: its grade, its prediction and its hints. Without an open exercise a function does nothing, unless
// its comment says otherwise.
#pragma once

#include "app/workspace.h"

namespace braitenlab {

// Call once per turn, after Jobs::deliver. When every step is done, grades the submission from all starts in the
// background and writes progress and grade to the lesson. An edit of the submission cancels grading and hides
// the grade of the earlier submission; if every step is still done, grading starts again. If the graded submission
// comes back, for example by undo, so does its grade.
void update_grading(Workspace&, Jobs&);

// Call once per turn, after Jobs::deliver. Once a run has begun, computes in the background how much each offered dial
// can gain for the present submission.
void update_gains(Workspace&, Jobs&);

void show_hint(Workspace&);

// Keeps an option or a path as the prediction while it can be made or changed, see Disclosure::open_prediction.
void predict(Workspace&, const PredictRequest&);
void predict(Workspace&, const PredictPathRequest&);

// Shows the run with the solution beside the student's, or ends it. Nothing is shown before the prediction is made and
// before a run; see Disclosure::solution_run.
void compare(Workspace&, const CompareRequest&);

// Shows the starts of the grade at once, if the exercise is passed.
void show_starts_together(Workspace&);

}  // namespace braitenlab
