// Sigmoid and hump as tables, for the header of an Arduino. An Uno takes 0.25 ms for expf() and a division.
//
// One table serves all curves of a response: they differ in centre and width only. It has 16 bits per value and is
// interpolated, in steps so small that a value differs by less than 0.00003 from the curve.
#pragma once

#include <optional>
#include <string>

#include "core/brain/curve.h"

namespace braitenlab::robots {

// The function brain_looked_up(), which the functions of both curves need.
std::string table_lookup();

// Table and function brain_sigmoid() or brain_hump(); nullopt for another response. The third parameter of the function
// is a table_scale().
std::optional<std::string> table_function(Response);

// Parts of 65,536 of a step of the table per unit of the input.
float table_scale(const Curve&);

}  // namespace braitenlab::robots
