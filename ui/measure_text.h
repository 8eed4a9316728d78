// Values of an exercise's steps in words, without Dear ImGui.
#pragma once

#include <string>

#include "core/lesson/goals.h"
#include "ui/strings.h"

namespace braitenlab::ui {

// Empty for a distance of 0 that is reached.
// "best 0.83 m, need ≤ 0.60 m"; "reached 0.55 m (≤ 0.60 m)" if the step is done.
std::string measure_text(const Strings&, const Measure&, bool done);

// The measured value alone: "0.55 m".
std::string value_text(const Strings&, const Measure&);

}  // namespace braitenlab::ui
