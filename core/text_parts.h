// Texts that a person types, in parts and as numbers.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace braitenlab {

// What stands between the separators; the whole text without one.
inline std::vector<std::string> parts_of(std::string_view text, char separator) {
    std::vector<std::string> parts(1);
    for (const char c : text)
        if (c == separator)
            parts.emplace_back();
        else
            parts.back() += c;
    return parts;
}

// Without these characters at both ends.
inline std::string_view trimmed(std::string_view text, const char* blanks = " \t") {
    const std::size_t first = text.find_first_not_of(blanks), last = text.find_last_not_of(blanks);
    return first == text.npos ? std::string_view() : text.substr(first, last - first + 1);
}

// The integer that the whole text is, of those that the type has.
template <class Integer>
std::optional<Integer> whole_number(std::string_view text) {
    Integer number = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
    return problem == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

// The finite number that the whole text is. By strtod, because libc++ has no from_chars for floating point. The program
// uses the C locale only.
inline std::optional<double> real_number(std::string_view text) {
    const std::string whole(text);
    char* end = nullptr;
    const double number = std::strtod(whole.c_str(), &end);
    if (whole.empty() || *end != '\0' || !std::isfinite(number)) return std::nullopt;
    return number;
}

}  // namespace braitenlab
