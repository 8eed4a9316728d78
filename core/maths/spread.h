// Minimum, quartiles and maximum of numbers.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace braitenlab::maths {

struct Spread {
    double least = 0, lower = 0, median = 0, upper = 0, most = 0;
    std::size_t count = 0;
};

// Quantiles by linear interpolation between the two nearest numbers. Numbers may be infinite, not NaN. All 0 without
// numbers.
inline Spread spread_of(std::vector<double> numbers) {
    if (numbers.empty()) return {};
    std::sort(numbers.begin(), numbers.end());
    const auto quantile = [&](double share) {
        const double place = share * static_cast<double>(numbers.size() - 1);
        const auto below = static_cast<std::size_t>(place);
        const double part = place - static_cast<double>(below), low = numbers[below];
        const double high = numbers[std::min(below + 1, numbers.size() - 1)];
        return part == 0 || low == high ? low : low + part * (high - low);  // ∞ − ∞ is NaN
    };
    return {quantile(0), quantile(0.25), quantile(0.5), quantile(0.75), quantile(1), numbers.size()};
}

}  // namespace braitenlab::maths
