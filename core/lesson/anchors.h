// Ids of the widgets that a hint of an exercise can point to. A test of the window holds that they exist.
#pragma once

#include <string>
#include <vector>

#include "core/lesson/exercise.h"

namespace braitenlab {

// The widgets of the window with this exercise open, paused or in the wiring editor. Those of steps, prediction options
// and nodes depend on the exercise: "exercise.step.2", "pin.SL.out".
std::vector<std::string> anchors_of(const Exercise&);

// The list as Markdown, for docs/exercise-format.md.
std::string describe_anchors();

}  // namespace braitenlab
