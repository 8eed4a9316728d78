// The check of the open exercise for its author, in the background: how many starts pass as shipped, with the solution
// and with each wrong answer. The result is a notice that stays for a minute. `braitenctl check` says more.
#pragma once

#include <memory>
#include <vector>

#include "app/jobs/jobs.h"
#include "core/lesson/exercise.h"
#include "core/lesson/grade.h"

namespace braitenlab {

struct Lab;

struct ExerciseCheck {
    std::shared_ptr<const Exercise> exercise;
    std::vector<Job<Grade>> jobs{};  // as shipped, with the solution, with each wrong answer
    std::vector<Grade> grades{};     // of the jobs that have ended, in their order
    bool begun = false;              // the jobs are submitted
};

// Checks the exercise of the document from now on. Does nothing without an exercise.
void check_exercise_for_author(Lab&);

// Call once per turn, after Jobs::deliver. Shows the result as a notice once every start has been run. A check ends
// without a notice if another exercise has been opened.
void update_exercise_check(Lab&, Jobs&);

}  // namespace braitenlab
