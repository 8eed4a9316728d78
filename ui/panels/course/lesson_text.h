// Values of an exercise's steps in words.
#pragma once

#include <string>

#include "core/lesson/goals.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

// "best 0.83 m, need ≤ 0.60 m"; "reached 0.55 m (≤ 0.60 m)" if the step is done.
std::string measure_text(const Ui&, const Measure&, bool done);

}  // namespace braitenlab::ui
