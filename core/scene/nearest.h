// The known word nearest to a misspelt one, and quoting for messages.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/messages.h"

namespace braitenlab {

// Number of letters to add, remove or replace to make one word from the other (V. I. Levenshtein, 1966).
int edit_distance(std::string_view, std::string_view);

// True if the word, of three letters or more, is the beginning of two letters of the other word and then leaves out
// some of its letters: "secs" of "seconds".
bool is_abbreviation(std::string_view word, std::string_view of);

// The candidate at the smallest distance, the first of several; empty without candidates. One that the word abbreviates
// is at distance 1 at most.
std::string_view nearest_word(std::string_view word, std::span<const std::string_view> candidates);

// "; the nearest is 'prey'" when the distance is at most half the length, the word abbreviates it or there is one
// candidate; else "; known are 'none', 'predator', 'prey'", at most 12 of them. Empty without candidates.
std::string name_nearest(std::string_view word, std::span<const std::string_view> candidates);

// The names of things, as candidates. Valid as long as the things.
std::vector<std::string_view> known_names(const auto& all) {
    std::vector<std::string_view> names;
    for (const auto& one : all) names.emplace_back(one.name);
    return names;
}

// name_nearest() as a message.
Message nearest_of(std::string_view word, std::span<const std::string_view> candidates);

// The text in quotes for a one-line message: at most 60 bytes, control characters replaced by spaces.
std::string in_quotes(std::string_view);

}  // namespace braitenlab
