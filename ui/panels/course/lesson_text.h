// Values of an exercise's steps in words.
#pragma once

#include <string>

#include "core/lesson/goals.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

// What is measured: "Smallest distance (red lamp)"; empty where the unit says it.
std::string measure_name(const Ui&, const Measure&);

// Name, value and what is needed: "Angle best 10.4° (max. 10.0)".
std::string measure_text(const Ui&, const Measure&, bool done);

// Which part of a line from 0 to 1 is as needed, and where on it the measured value is. Not for a need of 0.
struct Gauge {
    float from, to, value;
};
Gauge gauge_of(const Measure&);

}  // namespace braitenlab::ui
