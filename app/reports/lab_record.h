// The record of a student's work on an exercise, as a page to print.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/lesson/grade.h"
#include "ui/words/strings.h"

namespace braitenlab {

struct LabRecord {
    std::shared_ptr<const Exercise> exercise;  // never null
    std::string student;                       // empty: a line to write the name on
    std::string date;                          // as shown
    int prediction = -1;                       // the option chosen, 0-based; −1: none
    bool outcome_known = false;                // a run has shown what was to be predicted
    bool shows_title = true;                   // false while it would tell the outcome
    std::optional<float> path_difference{};    // m, mean distance of the drawn path and the real one; none: not drawn
    bool shows_brain = true;                   // false while the exercise hides it
    int runs = 0, hints = 0;
    bool solution_shown = false;
    std::optional<StartResult> last_run;  // with its path and the verdicts up to now
    std::optional<Grade> grade;           // of all starts
    Submission submission;
    std::string notes;
};

// A self-contained, well-formed page that fits on two A4 sheets, unless notes are longer than about 2,500 characters.
// Texts of the exercise are translated where the strings have a translation. `language`: its code.
std::string lab_record_html(const LabRecord&, const Strings&, const std::string& language);

}  // namespace braitenlab
