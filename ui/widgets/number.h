// Numbers as text with the decimal mark of the language, and numbers that are typed.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ui/widgets/ui.h"
#include "ui/words/number_text.h"

namespace braitenlab::ui {

// fixed() and the others with the decimal mark of the language: for every number that is shown.
inline std::string fixed(const Ui& ui, double value, int decimals) { return fixed(value, decimals, ui.decimal_mark); }
inline std::string with_sign(const Ui& ui, float value, int decimals) {
    return with_sign(value, decimals, ui.decimal_mark);
}
inline std::string as_factor(const Ui& ui, float value, int decimals) {
    return as_factor(value, decimals, ui.decimal_mark);
}

// The number typed, with a decimal comma or point and any kind of minus, in this unit: "35", "35 m/s". Another metric
// prefix is converted: "350 mm/s" is 0.35 in m/s, and so is "%" for a number without a unit. nullopt for other text.
std::optional<float> typed_number(std::string_view, std::string_view unit = {});

}  // namespace braitenlab::ui
