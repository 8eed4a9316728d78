#include "ui/widgets/number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>

namespace braitenlab::ui {

namespace {

// A unit as a factor and the unit without its prefix: "mm/s" is 0.001 "m/s".
struct SplitUnit {
    float factor = 1;
    std::string_view base;
};

// The readings of a unit: whole and, if it is a known unit with a prefix, without that.
std::array<SplitUnit, 2> readings_of(std::string_view unit) {
    constexpr std::string_view bases[]{"m", "m/s", "s", "g", "N", "V", "lx", "cd"};
    const float factor = unit.starts_with("m")   ? 1e-3f
                         : unit.starts_with("c") ? 1e-2f
                         : unit.starts_with("k") ? 1e3f
                                                 : 0;
    const std::string_view rest = unit.substr(std::min<std::size_t>(unit.size(), 1));
    const bool is_known = std::find(std::begin(bases), std::end(bases), rest) != std::end(bases);
    return {{{1, unit}, factor > 0 && is_known ? SplitUnit{factor, rest} : SplitUnit{1, unit}}};
}

std::string_view without_spaces_around(std::string_view text) {
    const std::size_t first = text.find_first_not_of(' ');
    if (first == text.npos) return {};
    return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

// The factor from the typed unit to the wanted one.
std::optional<float> conversion(std::string_view typed, std::string_view wanted) {
    if (typed.empty() || typed == wanted) return 1.0f;
    if (typed == "%" && wanted.empty()) return 0.01f;
    for (const SplitUnit& from : readings_of(typed))
        for (const SplitUnit& to : readings_of(wanted))
            if (from.base == to.base) return from.factor / to.factor;
    return std::nullopt;
}

// The text with a point and the minus of the keyboard, without spaces around it and after its sign.
std::string plain_number(std::string_view typed) {
    std::string plain;
    for (std::size_t i = 0; i < typed.size(); ++i) {
        if (typed.substr(i, 3) == "−") {
            plain += '-';
            i += 2;
        } else if (typed[i] != ' ' || plain.find_first_of("0123456789") != plain.npos) {
            plain += typed[i] == ',' ? '.' : typed[i];
        }
    }
    return plain;
}

}  // namespace

std::optional<float> typed_number(std::string_view typed, std::string_view unit) {
    const std::string plain = plain_number(typed);
    // strtof, because libc++ has no from_chars for floating point. The program uses the C locale only.
    char* end = nullptr;
    const float value = std::strtof(plain.c_str(), &end);
    if (end == plain.c_str()) return std::nullopt;
    const auto factor = conversion(without_spaces_around(end), without_spaces_around(unit));
    if (!factor || !std::isfinite(value)) return std::nullopt;
    // A quotient, because 35 / 100 is the float nearest to 0.35.
    return *factor < 1 ? value / std::round(1 / *factor) : value * *factor;
}

}  // namespace braitenlab::ui
