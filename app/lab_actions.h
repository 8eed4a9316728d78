// Executes the actions that keys, menus and buttons share.
#pragma once

#include "app/lab.h"

namespace braitenlab {

// Does nothing for the actions that only panels execute.
void act(Lab&, Action);

// True for an action on the exercise's own run: the graded starts that run at once end first.
bool acts_on_own_run(Action);

}  // namespace braitenlab
