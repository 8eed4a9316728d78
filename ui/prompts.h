// What leads a newcomer to the next useful action, and goes away when it is done.
#pragma once

#include <string>
#include <string_view>

#include "ui/lab_view.h"

namespace braitenlab {

// The anchor of the widget to press next, for Ui::highlight; empty when there is nothing to suggest. Lives as long as
// the exercise in the view.
std::string_view next_prompt(const LabView&);

// What the window remembers of its suggestions, for one opened file.
struct PromptMemory {
    std::string opened;
    bool slider_known = false;  // turned once, or watched for long enough
};

// `prompt`, or empty where it is the slider that next_prompt suggests of itself and that has had its time: a reset does
// not bring it back. What a hint points to is never left out. Call once a frame.
std::string_view still_wanted(PromptMemory&, const LabView&, std::string_view prompt);

// For Ui::pulse: 0..1, twice in three seconds; steady 1 where motion is reduced.
float pulse(const LabView&);

}  // namespace braitenlab
