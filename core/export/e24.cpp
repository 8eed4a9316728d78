#include "core/export/e24.h"

#include <cmath>

#include <fmt/format.h>

namespace braitenlab::robots {

double nearest_e24(double ohms) {
    constexpr double series[] = {1.0, 1.1, 1.2, 1.3, 1.5, 1.6, 1.8, 2.0, 2.2, 2.4, 2.7, 3.0, 3.3,
                                 3.6, 3.9, 4.3, 4.7, 5.1, 5.6, 6.2, 6.8, 7.5, 8.2, 9.1, 10.0};
    const double decade = std::pow(10.0, std::floor(std::log10(ohms)));
    double best = series[0];
    for (const double value : series)
        if (std::fabs(std::log(value * decade / ohms)) < std::fabs(std::log(best * decade / ohms))) best = value;
    return best * decade;
}

std::string ohms_text(double ohms) {
    if (ohms >= 1e6) return fmt::format("{:.4g} MΩ", ohms / 1e6);
    return ohms >= 1e3 ? fmt::format("{:.4g} kΩ", ohms / 1e3) : fmt::format("{:.4g} Ω", ohms);
}

}  // namespace braitenlab::robots
