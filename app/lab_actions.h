// Executes the actions that keys, menus and buttons share.
#pragma once

#include "app/lab.h"

namespace braitenlab {

// Does nothing for the actions that panels execute.
void act(Lab&, Action);

}  // namespace braitenlab
