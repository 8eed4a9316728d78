// What leads a newcomer to the next useful action, and goes away when it is done.
#pragma once

#include <string_view>

#include "ui/lab_view.h"

namespace braitenlab {

// The anchor of the widget to press next, for Ui::highlight; empty when there is nothing to suggest. Lives as long as
// the exercise in the view.
std::string_view next_prompt(const LabView&);

// For Ui::pulse: 0..1, twice in three seconds; steady 1 where motion is reduced.
float pulse(const LabView&);

}  // namespace braitenlab
