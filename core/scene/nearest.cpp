#include "core/scene/nearest.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "core/utf8.h"

namespace braitenlab {

namespace {

constexpr std::size_t longest_shown = 60;
constexpr std::size_t most_listed = 12;

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
    std::vector<int> row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (std::size_t i = 0; i < a.size(); ++i) {
        int diagonal = row[0];  // the distance of a[0, i) and b[0, j)
        row[0] = static_cast<int>(i) + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const int replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
        }
    }
    return row[b.size()];
}

bool is_abbreviation(std::string_view word, std::string_view of) {
    if (word.size() < 3 || word.size() >= of.size() || word.substr(0, 2) != of.substr(0, 2)) return false;
    std::size_t at = 0;
    for (const char c : of)
        if (at < word.size() && word[at] == c) ++at;
    return at == word.size();
}

std::string_view nearest_word(std::string_view word, std::span<const std::string_view> candidates) {
    word = word.substr(0, 2 * longest_shown);  // bounds the time for very long keys
    std::string_view nearest;
    std::pair smallest{std::numeric_limits<int>::max(), 0};
    for (const std::string_view candidate : candidates) {
        const int letters = edit_distance(word, candidate);
        const std::pair distance{is_abbreviation(word, candidate) ? std::min(letters, 1) : letters, letters};
        if (distance >= smallest) continue;
        smallest = distance;
        nearest = candidate;
    }
    return nearest;
}

std::string name_nearest(std::string_view word, std::span<const std::string_view> candidates) {
    return nearest_of(word, candidates).text;
}

Message nearest_of(std::string_view word, std::span<const std::string_view> candidates) {
    const std::string_view nearest = nearest_word(word, candidates);
    if (candidates.empty()) return {};
    const auto letters = static_cast<int>(std::max(word.size(), nearest.size()));
    if (candidates.size() == 1 || is_abbreviation(word, nearest) ||
        edit_distance(word.substr(0, 2 * longest_shown), nearest) * 2 <= letters)
        return message_of("nearest", in_quotes(nearest));
    std::vector<std::string_view> listed;  // each once
    for (std::size_t i = 0; i < candidates.size() && listed.size() <= most_listed; ++i)
        if (std::find(listed.begin(), listed.end(), candidates[i]) == listed.end()) listed.push_back(candidates[i]);
    std::string words;
    for (std::size_t i = 0; i < std::min(listed.size(), most_listed); ++i)
        words += (i > 0 ? ", " : "") + in_quotes(listed[i]);
    return message_of("known", words + (listed.size() > most_listed ? " …" : ""));
}

std::string in_quotes(std::string_view text) {
    std::string shown = "'";
    for (const char c : text.substr(0, character_start(text, longest_shown)))
        shown += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
    return shown + (text.size() > longest_shown ? "…'" : "'");
}

}  // namespace braitenlab
