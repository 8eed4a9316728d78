// FNV-1a over 64 bits (G. Fowler, L. C. Noll, K.-P. Vo): http://www.isthe.com/chongo/tech/comp/fnv/
#pragma once

#include <cstdint>
#include <string_view>

namespace braitenlab::maths {

inline constexpr std::uint64_t fnv_start = 14695981039346656037U;

// The hash of a text; of texts one after the other with `hash` of the texts before.
constexpr std::uint64_t fnv(std::string_view text, std::uint64_t hash = fnv_start) {
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
    return hash;
}

}  // namespace braitenlab::maths
