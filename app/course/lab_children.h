// Selection by hand in the open exercise: the runs of a brain's children in the background, and the choice of one. In
// an exercise that does not offer selection, a function does nothing.
#pragma once

#include "app/lab.h"

namespace braitenlab {

// Call once per turn, after Jobs::deliver. Runs the parent and its children from the start that Play shows, then the
// children that stay there from other_starts more where several do, and writes the runs to the lesson's view. Follows
// the vehicle's brain: undo takes choices back; a brain edited by hand becomes the parent in place of the last one.
void update_children(Lab&, Jobs&);

// Gives the vehicle the brain of a child, in one step of undo, resets the run, and makes the child the parent. −1: the
// parent itself, which gets other children. Does nothing while the runs are computed, after the last generation of the
// exercise, or if there is no such child.
void choose_child(Lab&, int child);

// Takes the last choice back: the brain before it, and the same children.
void take_choice_back(Lab&);

}  // namespace braitenlab
