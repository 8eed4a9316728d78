// Values of resistors.
#pragma once

#include <string>

namespace braitenlab::robots {

// The nearest value of the series E24 (IEC 60063), by ratio.
double nearest_e24(double ohms);

std::string ohms_text(double ohms);  // "120 kΩ"

}  // namespace braitenlab::robots
