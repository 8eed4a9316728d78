// What the parts of the lab ask of each other. For app/lab.cpp and the files that it is split into.
#pragma once

#include "app/lab.h"

namespace braitenlab {

// Something stays selected as long as there is a vehicle.
void keep_selection(Lab&);

// Shows the moment to the exercise's judge, and what it says to the panels.
void watch(Lab&);

}  // namespace braitenlab
