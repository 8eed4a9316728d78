// A map of behaviour as an SVG file with axes, ticks, legend and title.
#pragma once

#include <string>

#include "core/insight/map.h"
#include "ui/words/strings.h"

namespace braitenlab {

// What a person calls a figure and its axes; empty: see the figure.
struct FigureLabels {
    std::string title, x, y;
};

// The text of the file. Without labels the title is that of the scene, and an axis has the name and unit of its value;
// of dials and of values without a name it has the path, without the kind where both axes are about one. The largest y
// is at the top. Cells have their colour, those of a map of kinds also a mark where they are large enough. The legend
// has the kinds that occur, or the scale of the numbers. Precondition: all cells are there.
std::string map_file(const insight::MapQuestion&, const insight::MapCells&, insight::MapMeasure, const FigureLabels&,
                     const Strings&);

}  // namespace braitenlab
