// Numbers that change: always the same number of digits, so that nothing jumps.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace braitenlab {

// "0.42"; a minus is the sign U+2212, as wide as a plus. "—" for what is not finite or beyond a million.
std::string fixed(float value, int decimals);

// "+0.42", "−0.42", and "0.00" for what is zero at these decimals.
std::string with_sign(float value, int decimals);

// The second factor of a product: "0.40", "(−1.00)".
std::string as_factor(float value, int decimals);

// What a person typed, with a comma or a point and any minus; nothing when it is no number.
std::optional<float> typed_number(std::string_view);

}  // namespace braitenlab
