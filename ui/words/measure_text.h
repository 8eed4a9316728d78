// Values of an exercise's steps and of axes in words, without Dear ImGui.
#pragma once

#include <string>

#include "core/insight/axis_value.h"
#include "core/insight/study_file.h"
#include "core/lesson/goals.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

// The value and what is needed, with spaces that break no line: "0.83 m, goal ≤ 0.60"; "best 0.83 m, goal ≤ 0.60" of a
// value that is the best so far, until the step is done; "2.0 of 5.0 s". Empty for a distance of 0 that is reached.
std::string measure_text(const Strings&, const Measure&, bool done);

// The measured value alone: "0.55 m".
std::string value_text(const Strings&, const Measure&);

// A level of a study's value with its unit, as text of figures and sheets: "−1.5 m".
std::string level_words(const Strings&, const insight::StudyValue&, std::size_t level);

// The name of a value of an axis: "mass", "lamp strength"; of dials "LL = RR", "θ LL".
std::string axis_name(const Strings&, const insight::AxisValue&);

}  // namespace braitenlab::ui
