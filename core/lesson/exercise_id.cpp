#include "core/lesson/exercise_id.h"

#include <algorithm>
#include <array>

namespace braitenlab {

namespace {

// Of Windows and macOS, in the languages of the lab.
constexpr std::array<std::string_view, 6> copy_words{" - Copy", " - Kopie", " - copia", " copy", " Kopie", " copia"};

std::string_view without_spaces_at_end(std::string_view name) { return name.substr(0, name.find_last_not_of(' ') + 1); }

// The name without " (1)" or "(1)" at its end.
std::string_view without_number(std::string_view name) {
    const std::size_t open = name.rfind('(');
    if (open == std::string_view::npos || open == 0 || !name.ends_with(')')) return name;
    const std::string_view inside = name.substr(open + 1, name.size() - open - 2);
    const bool is_number = !inside.empty() && inside.size() <= 3 &&
                           std::all_of(inside.begin(), inside.end(), [](char c) { return c >= '0' && c <= '9'; });
    return is_number ? without_spaces_at_end(name.substr(0, open)) : name;
}

}  // namespace

std::string_view without_copy_suffix(std::string_view name) {
    std::string_view rest = without_number(name);
    for (const std::string_view word : copy_words)
        if (rest.size() > word.size() && rest.ends_with(word)) {
            rest = without_spaces_at_end(rest.substr(0, rest.size() - word.size()));
            break;
        }
    return rest.empty() ? name : rest;
}

std::string exercise_id_of(const std::filesystem::path& file) {
    return std::string(without_copy_suffix(file.stem().string()));
}

bool is_for_exercise(std::string_view handed_in, std::string_view id) {
    return without_copy_suffix(handed_in) == without_copy_suffix(id);
}

}  // namespace braitenlab
