// The results of a study: the table of its runs, and medians and quartiles.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/insight/study.h"
#include "core/maths/spread.h"

namespace braitenlab::insight {

// The long-form table: run (from 1), seed, a column for each value and each measure, named with the unit. Cells that
// are not finite are empty.
std::string study_header(const Study&);
std::string study_line(const StudyBase&, std::size_t run, const StudyRow&);
// The row of a line; nullopt unless study_line() gives this line for the row.
std::optional<StudyRow> read_study_line(const StudyBase&, std::size_t run, std::string_view line);

// A measure in all runs of a combination, and against the first combination with the same seeds.
struct StudySummary {
    maths::Spread spread;  // without the runs that have no such object
    double paired = 0;     // median of the differences from the first combination; NAN without pairs of finite numbers
    std::size_t present = 0;                    // runs with a finite number
    std::size_t more = 0, less = 0, pairs = 0;  // seeds with a larger and a smaller number than the first combination
};
// rows: of all runs in order; a missing one is empty. `measure`: index in Study::measures.
StudySummary summary_of(const Study&, const std::vector<StudyRow>& rows, std::size_t combination, std::size_t measure);

}  // namespace braitenlab::insight
