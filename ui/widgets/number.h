// Numbers as text with a fixed number of decimals.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ui/widgets/ui.h"

namespace braitenlab::ui {

// "0.42"; the minus is U+2212, as wide as a plus. "—" for a value that is not finite or above 1e6.
std::string fixed(float value, int decimals, char decimal_mark = '.');

// "+0.42", "−0.42", and "0.00" for a value that rounds to zero.
std::string with_sign(float value, int decimals, char decimal_mark = '.');

// The second factor of a product: "0.40", "(−1.00)".
std::string as_factor(float value, int decimals, char decimal_mark = '.');

// The same with the decimal mark of the language: for every number that is shown.
inline std::string fixed(const Ui& ui, float value, int decimals) { return fixed(value, decimals, ui.decimal_mark); }
inline std::string with_sign(const Ui& ui, float value, int decimals) {
    return with_sign(value, decimals, ui.decimal_mark);
}
inline std::string as_factor(const Ui& ui, float value, int decimals) {
    return as_factor(value, decimals, ui.decimal_mark);
}

// The number typed, with a decimal comma or point and any kind of minus; nullopt for other text.
std::optional<float> typed_number(std::string_view);

}  // namespace braitenlab::ui
