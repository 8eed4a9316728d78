// Angles of edited objects. A file has them in degrees and reads them with one rounding; radians() in angle.h rounds
// twice, so a file would have 34.9999987 for 35.
#pragma once

#include <cmath>

#include "core/maths/portable.h"

namespace braitenlab::maths {

// The angle (rad) that a file reads from these degrees.
inline float from_degrees(double degrees) { return static_cast<float>(degrees * (pi_d / 180)); }

// The nearest angle (rad) of a whole number of steps of this many degrees.
inline float to_degree_steps(float angle, double step = 1) {
    return from_degrees(std::round(static_cast<double>(angle) * (180 / pi_d) / step) * step);
}

}  // namespace braitenlab::maths
