// The results of a study as an SVG file: a panel for each measure.
#pragma once

#include <string>
#include <vector>

#include "app/reports/map_file.h"
#include "core/insight/study_table.h"
#include "ui/words/strings.h"

namespace braitenlab {

// The text of the file. Along the horizontal axis is the value with most levels, the first of several. Each combination
// of the other values is a line through the medians, with a bar from the lower to the upper quartile. A strip above the
// frame counts the runs that never come to a number; where the median is such a run, the line has a gap. Without labels
// the title is that of the study and an axis has the label of its file,
// else the name of the value or the measure with its unit; a label of the vertical axis is that of the first panel.
// rows: of all runs, in order.
std::string study_drawing(const insight::Study&, const std::vector<insight::StudyRow>& rows, const FigureLabels&,
                          const Strings&);

}  // namespace braitenlab
