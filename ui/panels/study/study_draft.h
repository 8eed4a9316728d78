// A study of the open scene as it is put together on the sheet of the studies.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/insight/axis_value.h"
#include "core/insight/study_file.h"
#include "ui/lab_view.h"
#include "ui/widgets/slider.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

// One varied value: levels in equal steps from `from` to `to`.
struct DraftValue {
    std::string id;  // insight::AxisValue::id; empty: none
    float from = 0, to = 1;
    int levels = 3;
};

struct StudyDraft {
    bool open = false;      // the sheet shows it instead of a study
    std::uint64_t run = 0;  // LabView::run_id of the scene that it is about
    std::array<DraftValue, 2> values;
    int seeds = 20;
    float seconds = 20;
    std::vector<insight::StudyMeasure> measures;  // in the order of the table
    int unfolded = -1;                            // the value whose list is shown
    insight::ValueGroup group = insight::ValueGroup::body;
};

// The levels, rounded to a thousandth of the range.
std::vector<double> levels_of(const DraftValue&);

// The study that the draft describes; nullopt without a value or a measure.
std::optional<insight::Study> study_of(const StudyDraft&, const Ui&, const LabView&, const VehicleView&,
                                       const std::vector<insight::AxisValue>&);

// Why the scene has no study: a string key; empty: it can have one.
std::string_view why_no_draft(const LabView&);

// Draws the rows of the draft at the cursor. Returns the study that the draft describes. Precondition: why_no_draft()
// is empty.
std::optional<insight::Study> study_builder(const LabView&, StudyDraft&, SliderState&, Ui&, float width);

}  // namespace braitenlab::ui
