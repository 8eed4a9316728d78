// Mutants of a text that keep most of its structure: of random changes of bytes only a sixth passes a parser.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace braitenlab::fuzz {

// One to four changes: a number becomes an unusual one, a word becomes another word of the texts, a line is removed,
// repeated, moved or taken from `others`. JSON in one line counts as lines that end with commas.
std::string mutant_of(std::string_view text, std::uint64_t seed, std::span<const std::string> others);

}  // namespace braitenlab::fuzz
