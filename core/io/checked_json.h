// The JSON library, with whole numbers that are checked: it would cast any number to any integer type, and C++ does not
// define the result for a double beyond the range. Only this header includes the library.
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include <nlohmann/json.hpp>

namespace braitenlab::io {

// The value of a JSON number, or nullopt unless it is whole and in the range of T. 2.0 and 2e3 are whole.
template <std::integral T>
std::optional<T> whole_number(const auto& json) {
    const auto if_in_range = [](auto number) {
        return std::in_range<T>(number) ? std::optional(static_cast<T>(number)) : std::nullopt;
    };
    if (json.is_number_unsigned()) return if_in_range(json.template get_ref<const std::uint64_t&>());
    if (json.is_number_integer()) return if_in_range(json.template get_ref<const std::int64_t&>());
    using Limits = std::numeric_limits<T>;
    const double number = json.template get_ref<const double&>();
    const bool is_in_range = number >= static_cast<double>(Limits::min()) && number < std::ldexp(1, Limits::digits);
    return is_in_range && !(number > std::floor(number)) ? std::optional(static_cast<T>(number)) : std::nullopt;
}

// The JSON as text, in lines with the given indent; −1: one line. Names of files may be no UTF-8; the library would
// throw.
std::string json_text(const auto& json, int indent = -1) {
    return json.dump(indent, ' ', false, std::decay_t<decltype(json)>::error_handler_t::replace);
}

}  // namespace braitenlab::io

// Every conversion of the library from JSON to an integer, also to one in a vector, a map or a struct, calls this one.
// Throws type_error 302, as the library does for a wrong type, unless the value is such a whole number.
template <std::integral T>
requires(!std::same_as<T, bool>) struct nlohmann::adl_serializer<T, void> {
    template <class Json>
    static void from_json(const Json& json, T& value) {
        using Limits = std::numeric_limits<T>;
        if (!json.is_number())
            throw Json::type_error::create(302, std::string("type must be number, but is ") + json.type_name(), &json);
        const auto number = braitenlab::io::whole_number<T>(json);
        if (!number)
            throw Json::type_error::create(302,
                                           json.dump() + " is no whole number from " + std::to_string(Limits::min()) +
                                               " to " + std::to_string(Limits::max()),
                                           &json);
        value = *number;
    }
    template <class Json>
    static void to_json(Json& json, T value) {
        nlohmann::to_json(json, value);
    }
};
