// Numbers as text with a fixed number of decimals, without Dear ImGui.
#pragma once

#include <string>

namespace braitenlab::ui {

// "0.42"; the minus is U+2212, as wide as a plus. "—" for a value that is not finite or above 1e8.
std::string fixed(double value, int decimals, char decimal_mark = '.');

// "+0.42", "−0.42", and "0.00" for a value that rounds to zero.
std::string with_sign(float value, int decimals, char decimal_mark = '.');

// The second factor of a product: "0.40", "(−1.00)".
std::string as_factor(float value, int decimals, char decimal_mark = '.');

// The decimals that write the value exactly, `least` to `most`, with five digits in all; `least` for a value that has
// more, as a computed one.
int decimals_of(float value, int least, int most);

// The unit as it follows a number: " m", "°"; empty for none.
inline std::string unit_after(std::string_view unit) {
    return (unit.empty() || unit == "°" ? "" : " ") + std::string(unit);
}

}  // namespace braitenlab::ui
