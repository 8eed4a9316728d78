// The results of a breeding as SVG files: curves over the generations, and the matrix of a tournament.
#pragma once

#include <string>

#include "app/reports/breeding_table.h"
#include "app/reports/map_file.h"
#include "core/evolve/tournament.h"
#include "ui/words/strings.h"

namespace braitenlab {

// A panel for each side that evolves: best, median and, if there is a panel of opponents, the score against it, by
// generation. Without labels the title is that of the breeding; a label of the vertical axis is that of the first
// panel. Precondition: a generation is complete.
std::string curves_drawing(const evolve::BreedingBase&, const evolve::BreedingState&, const FigureLabels&,
                           const Strings&);

// A panel for each side that evolves: its champions from the bottom to the top, their opponents from the left to the
// right, a colour for each score. Cells that are large enough have their score as a number.
std::string matrix_drawing(const evolve::BreedingBase&, const evolve::Tournament&, MatrixKind, const FigureLabels&,
                           const Strings&);

}  // namespace braitenlab
