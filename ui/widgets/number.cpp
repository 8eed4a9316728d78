#include "ui/widgets/number.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

namespace braitenlab::ui {

namespace {

constexpr float largest_number = 1e6f;

// True when it is written with a minus; −0.001 at two decimals is 0.00.
bool is_negative(float value, int decimals) {
    return std::round(value * std::pow(10.0f, static_cast<float>(decimals))) < 0;
}

}  // namespace

std::string fixed(float value, int decimals, char decimal_mark) {
    if (!std::isfinite(value) || std::fabs(value) > largest_number) return "—";
    std::string digits = fmt::format("{:.{}f}", std::fabs(value), decimals);
    std::replace(digits.begin(), digits.end(), '.', decimal_mark);
    return (is_negative(value, decimals) ? "−" : "") + digits;
}

std::string with_sign(float value, int decimals, char decimal_mark) {
    const std::string bare = fixed(value, decimals, decimal_mark);
    const bool is_zero = bare == fixed(0, decimals, decimal_mark);
    return std::isfinite(value) && !is_zero && !is_negative(value, decimals) ? "+" + bare : bare;
}

std::string as_factor(float value, int decimals, char decimal_mark) {
    const std::string bare = fixed(value, decimals, decimal_mark);
    return is_negative(value, decimals) ? "(" + bare + ")" : bare;
}

std::optional<float> typed_number(std::string_view typed) {
    std::string plain;
    for (std::size_t i = 0; i < typed.size(); ++i) {
        if (typed.substr(i, 3) == "−") {
            plain += '-';
            i += 2;
        } else if (typed[i] != ' ') {
            plain += typed[i] == ',' ? '.' : typed[i];
        }
    }
    // strtof, because libc++ has no from_chars for floating point. The program uses the C locale only.
    char* end = nullptr;
    const float value = std::strtof(plain.c_str(), &end);
    if (plain.empty() || end != plain.c_str() + plain.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

}  // namespace braitenlab::ui
