// The student's progress in the open exercise: taken from the lesson, and given to it when an exercise is opened.
#pragma once

#include "app/lab.h"

namespace braitenlab {

// Call once per turn, after update_grading(). After another exercise was opened or another student was chosen, gives
// the student's notes to the lesson; then takes what has changed to Lab::students.
void follow_progress(Lab&);

// Adds the progress of a file to that of the student of this name, as merged_progress() does, and goes on with this
// student. False if there are too many students.
bool take_progress(Lab&, const StudentProgress&);

// Executes a request, except StudentEdit::save and save_progress, which need files. Another student, and a reset, begin
// the open exercise anew; its brain can be restored by undo. Renaming the student without a name gives the progress to
// a new student.
void edit_students(Lab&, const StudentRequest&);

// Gives the vehicle the submission that the student's progress has, in one step of undo, and resets the run.
void take_kept_submission(Lab&);

// True if the student's progress has this submission of the open exercise.
bool is_kept(const Lab&, const Submission&);

}  // namespace braitenlab
