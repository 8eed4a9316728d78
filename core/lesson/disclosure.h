// Disclosure: what may be shown of an exercise, of a lecture's page and of hidden brains, so that nothing tells an
// answer before it is given.
#pragma once

#include "core/lesson/exercise.h"

namespace braitenlab {

// What is known at the displayed tick.
struct Known {
    bool predicted = false;          // an option is chosen or a path is drawn
    bool outcome = false;            // a run of the scene as given has shown it
    bool passed = false;             // with the present submission
    bool has_run = false;            // the exercise has been run at least once
    bool at_start = true;            // of a run; in a selection by hand also before the first choice
    bool as_given = true;            // see Referee::as_given
    bool free_play = false;          // all controls are shown
    bool together = false;           // the graded starts are shown in place of the exercise's run
    bool page_asks = false;          // the page of a lecture has a question
    bool page_answers = false;       // and shows its answer
    bool brain_revealed = true;      // by the lecture
    bool character_revealed = true;  // by the lecture
};

// Each member is true if it may be shown or done now. Without an exercise and a lecture all but open_prediction and
// solution_run are.
struct Disclosure {
    bool outcome = true;           // what the prediction asks for
    bool open_prediction = false;  // the prediction can be made or changed
    bool future = true;            // the coming seconds, the last run, the runs of slots
    bool solution_run = false;     // the run with the solution beside the student's
    bool brains = true;            // of kinds that are not secret, see is_secret()
    bool characters = true;        // their names, of these kinds
    bool why = true;               // the cause of a turn, of these kinds
    bool every_brain = true;       // no exercise asks for one of the vehicle's other brains, or it offers all controls
    bool other_brains = true;      // what other brains of the vehicle would do: the map of behaviour
    bool robots = true;            // what the brain would do on real robots
    friend bool operator==(const Disclosure&, const Disclosure&) = default;
};

// `exercise`: the open one, or null.
Disclosure disclosure_of(const Exercise* exercise, const Known&);

// True for a kind of the scene `now` whose brains are hidden by the scene or by the exercise (or null).
bool is_secret(const Exercise* exercise, const Scene& now, int kind);

}  // namespace braitenlab
