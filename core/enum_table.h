// Tables of enumerations: one constexpr row per enumerator.
//
// A row is a struct with the members `value` (the enumerator), `word` (its name in files, on the command line and in
// keys of strings) and any further traits. `table_of(E)` returns the table of E as a std::array and stands in the
// namespace of E. Everything that lists the enumerators (readers, writers, menus, palettes, tests) loops over the
// table.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

namespace braitenlab {

// The row of an enumeration whose enumerators have a word and no further traits.
template <class Enum>
struct Word {
    Enum value;
    std::string_view word;
};

// True when `value` is one of the enumerators. The compiler spells other values as a cast: "(Channel)15".
template <auto value>
consteval bool is_enumerator() {
#if defined(__GNUC__)
    const std::string_view name = __PRETTY_FUNCTION__;
    return name.substr(name.rfind("value = ") + 8, 1) != "(";
#else
    return false;
#endif
}

// True when the enumerators are 0 … count − 1, so that an array of this size can be indexed by them.
template <class Enum, std::size_t count>
consteval bool has_enumerators() {
    return is_enumerator<static_cast<Enum>(count - 1)>() && !is_enumerator<static_cast<Enum>(count)>();
}

// True when row i holds enumerator i and no enumerator is without a row. Each table has a static_assert of it.
template <const auto& table>
consteval bool is_complete_table() {
    for (std::size_t i = 0; i < table.size(); ++i)
        if (static_cast<std::size_t>(table[i].value) != i || table[i].word.empty()) return false;
    using Enum = decltype(table[0].value);
    return !is_enumerator<static_cast<std::remove_cvref_t<Enum>>(table.size())>();
}

// The row of an enumerator. Precondition: `value` is an enumerator.
template <class Enum>
constexpr const auto& row_of(Enum value) {
    return table_of(value)[static_cast<std::size_t>(value)];
}

// The word of an enumerator, e.g. word(Role::prey) == "prey"; empty for any other value.
template <class Enum>
constexpr std::string_view word(Enum value) {
    const auto& table = table_of(value);
    const auto i = static_cast<std::size_t>(value);
    return i < table.size() ? table[i].word : std::string_view{};
}

// The enumerator with this word in a table.
template <class Row, std::size_t size>
constexpr auto find_word(const std::array<Row, size>& table, std::string_view word) {
    std::optional<decltype(Row::value)> found;
    for (const Row& row : table)
        if (row.word == word) found = row.value;
    return found;
}

// The words of a table in its order.
template <class Row, std::size_t size>
std::vector<std::string_view> words_of(const std::array<Row, size>& table) {
    std::vector<std::string_view> words;
    for (const Row& row : table) words.push_back(row.word);
    return words;
}

}  // namespace braitenlab
