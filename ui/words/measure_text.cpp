#include "ui/words/measure_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "ui/words/number_text.h"

namespace braitenlab::ui {

namespace {

const std::string no_break = "\u00a0";

// A value and its need stay on one line.
std::string unbroken(std::string words) {
    for (std::size_t at = 0; (at = words.find(' ', at)) != std::string::npos; at += no_break.size())
        words.replace(at, 1, no_break);
    return words;
}

// Units that are words are translated.
std::string unit_text(const Strings& strings, std::string_view unit) {
    if (unit == "°") return "°";
    if (unit == "correlation") return {};  // a number
    return unit.empty() ? "" : no_break + std::string(strings.find("unit." + std::string(unit), unit));
}

int decimals(std::string_view unit) {
    constexpr std::string_view two[]{"m", "m/s", "×", "rounds", "laps"};
    if (std::find(std::begin(two), std::end(two), unit) != std::end(two)) return 2;
    return unit == "s" ? 1 : 0;
}

std::string with_unit(const Strings& strings, float value, std::string_view unit, int digits) {
    return fixed(value, digits, decimal_mark(strings)) + unit_text(strings, unit);
}

// True if the value is written without loss with so many digits.
bool fits(float value, int digits) {
    const float scaled = value * std::pow(10.0f, static_cast<float>(digits));
    return std::fabs(scaled - std::round(scaled)) < 1e-3f;
}

// True for a time, a number and a share, which begin at 0 and must reach what is needed.
bool grows(const Measure& measure) {
    constexpr std::string_view others[]{"m", "m/s", "°"};
    return !measure.at_most && std::find(std::begin(others), std::end(others), measure.unit) == std::end(others);
}

// The number of digits that shows the needed value, at most two, and, until the step is done, which of two values is
// larger: 10.4° and 10.0°.
int telling_decimals(const Measure& measure, bool done) {
    int digits = decimals(measure.unit);
    const float most_needed = measure.needed_most.value_or(measure.needed);
    while (digits < 2 && !(fits(measure.needed, digits) && fits(most_needed, digits))) ++digits;
    const bool differ = !done && std::fabs(measure.value - measure.needed) > 1e-4f;
    for (const int most = std::min(digits + 2, 3); digits < most && differ; ++digits)
        if (fixed(measure.value, digits) != fixed(measure.needed, digits)) break;
    return digits;
}

}  // namespace

std::string value_text(const Strings& strings, const Measure& measure) {
    return with_unit(strings, measure.value, measure.unit, decimals(measure.unit));
}

std::string measure_text(const Strings& strings, const Measure& measure, bool done) {
    const int digits = telling_decimals(measure, done);
    const std::string value = with_unit(strings, measure.value, measure.unit, digits);
    const auto number = [&](float wanted) { return fixed(wanted, digits, decimal_mark(strings)); };
    const auto needed = [&](float wanted) { return with_unit(strings, wanted, measure.unit, digits); };
    if (measure.needed_most)
        return unbroken(
            fill(strings("exercise.now_between"), {value, number(measure.needed), needed(*measure.needed_most)}));
    if (measure.at_most && measure.needed == 0 && measure.unit == "m")  // the check mark says the rest
        return done ? std::string() : unbroken(fill(strings("exercise.to_go"), {value}));
    if (grows(measure))
        return unbroken(fill(strings("exercise.so_far"), {fixed(measure.value, digits, decimal_mark(strings)),
                                                          with_unit(strings, measure.needed, measure.unit, digits)}));
    const std::string_view key = measure.best && !done ? "exercise.best_at_most"
                                 : measure.at_most     ? "exercise.now_at_most"
                                                       : "exercise.now_at_least";
    return unbroken(fill(strings(key), {value, needed(measure.needed)}));
}

std::string level_words(const Strings& strings, const insight::StudyValue& value, std::size_t level) {
    std::string words = level_text(value, level);
    std::replace(words.begin(), words.end(), '.', decimal_mark(strings));
    return words.starts_with('-') ? "−" + words.substr(1) : words;
}

std::string axis_name(const Strings& strings, const insight::AxisValue& value) {
    constexpr std::string_view of_threshold = "threshold_";
    constexpr std::array owners{"", "sensor_", "body_", "start_", "source_", "arena_"};  // by ValueOwner
    if (value.dials.empty())
        return fill(strings(std::string("map.value.") + owners[static_cast<std::size_t>(value.owner)] + value.key),
                    {value.source});
    std::string words;
    for (const Dial dial : value.dials) {
        const std::string_view key = name(dial);
        words += words.empty() ? "" : " = ";
        words += key.starts_with(of_threshold) ? "θ " + std::string(key.substr(of_threshold.size())) : std::string(key);
    }
    return words;
}

}  // namespace braitenlab::ui
