// A map of behaviour as an SVG file with axes, ticks, legend and title.
#pragma once

#include <string>
#include <string_view>

#include "core/insight/map.h"
#include "ui/strings.h"

namespace braitenlab {

// The text of the file. The largest y is at the top. Cells have their colour, those of a map of kinds also a mark where
// they are large enough. The legend has the kinds that occur, or the scale of the numbers.
// Precondition: all cells are there.
std::string map_file(const insight::MapQuestion&, const insight::MapCells&, insight::MapMeasure, std::string_view title,
                     const Strings&);

}  // namespace braitenlab
