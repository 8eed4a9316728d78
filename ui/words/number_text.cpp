#include "ui/words/number_text.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace braitenlab::ui {

namespace {

constexpr double largest_number = 1e8;  // seconds of three years

// True when it is written with a minus; −0.001 at two decimals is 0.00.
bool is_negative(double value, int decimals) { return std::round(value * std::pow(10.0, decimals)) < 0; }

}  // namespace

std::string fixed(double value, int decimals, char decimal_mark) {
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

int decimals_of(float value, int least, int most) {
    constexpr float rounding = 5e-7f;  // relative: of an angle in degrees that is stored in radians
    const float size = std::fabs(value);
    float unit = std::pow(10.0f, static_cast<float>(least));
    for (int decimals = least; decimals <= most && size * unit < 1e5f; ++decimals, unit *= 10)
        if (std::fabs(std::round(size * unit) - size * unit) <= rounding * size * unit) return decimals;
    return least;
}

}  // namespace braitenlab::ui
