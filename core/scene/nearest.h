// Finds the word that a person most likely meant.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace braitenlab {

// How many letters must be added, dropped or replaced to turn one word into the other (V. I. Levenshtein, 1966).
int edit_distance(std::string_view, std::string_view);

// The candidate at the smallest distance (the first of several), or an empty view when there is no candidate.
std::string_view nearest_word(std::string_view word, std::span<const std::string_view> candidates);

// "; the nearest is 'prey'" when a candidate is about as long as the distance is small, else "; known are 'none',
// 'predator', 'prey'", cut after a dozen; empty without candidates.
std::string name_nearest(std::string_view word, std::span<const std::string_view> candidates);

// 'text', fit for a one-line message: cut after 60 bytes, without control characters.
std::string in_quotes(std::string_view);

}  // namespace braitenlab
