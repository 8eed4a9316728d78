// Texts in UTF-8: their characters, and cuts between two of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace braitenlab {

struct CodePoint {
    char32_t code;     // U+FFFD if not valid
    std::size_t size;  // bytes, at least 1
    bool is_valid;
};

// The first character of a text that is not empty. Of bytes that are no UTF-8 it is the longest beginning of a
// character, or one byte, as chapter 3.9 of the Unicode Standard recommends for their replacement.
constexpr CodePoint first_code_point(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned lead = byte(0);
    if (lead < 0x80) return {lead, 1, true};
    const std::size_t size = lead < 0xC2 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : lead < 0xF5 ? 4 : 1;
    if (size == 1) return {0xFFFD, 1, false};
    // The range of the second byte leaves out overlong forms, surrogates and what is beyond U+10FFFF.
    unsigned least = lead == 0xE0   ? 0xA0
                     : lead == 0xF0 ? 0x90
                                    : 0x80,
             most = lead == 0xED   ? 0x9F
                    : lead == 0xF4 ? 0x8F
                                   : 0xBF;
    char32_t code = lead & (0x7Fu >> size);
    for (std::size_t i = 1; i < size; ++i) {
        if (i >= text.size() || byte(i) < least || byte(i) > most) return {0xFFFD, i, false};
        code = code << 6 | (byte(i) & 0x3Fu);
        least = 0x80, most = 0xBF;
    }
    return {code, size, true};
}

constexpr bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const CodePoint first = first_code_point(text);
        if (!first.is_valid) return false;
        text.remove_prefix(first.size);
    }
    return true;
}

// A control character other than tab and the ends of lines.
constexpr bool is_control(char32_t code) {
    return code != '\t' && code != '\n' && code != '\r' && (code < 0x20 || (code >= 0x7F && code < 0xA0));
}

// A mark that ends a line or changes the direction of writing, so that a text looks like another one.
constexpr bool is_layout_mark(char32_t code) {
    return code == 0x2028 || code == 0x2029 || code == 0x200E || code == 0x200F || code == 0x061C ||
           (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

// The text with U+FFFD for each byte that is no UTF-8 and each character with is_unwanted(char32_t).
template <class Unwanted>
std::string utf8_without(std::string_view text, const Unwanted& is_unwanted) {
    std::string kept;
    while (!text.empty()) {
        const CodePoint first = first_code_point(text);
        kept += !first.is_valid || is_unwanted(first.code) ? std::string_view("\uFFFD") : text.substr(0, first.size);
        text.remove_prefix(first.size);
    }
    return kept;
}

// True for all bytes of a character but its first.
constexpr bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; }

constexpr std::size_t count_characters(std::string_view text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return !continues_character(c); }));
}

// The last place at or before `at` where a character begins; the end of the text for a larger one.
constexpr std::size_t character_start(std::string_view text, std::size_t at) {
    if (at >= text.size()) return text.size();
    while (at > 0 && continues_character(text[at])) --at;
    return at;
}

// At most `most` bytes of the text, cut between two characters.
inline std::string utf8_cut(std::string text, std::size_t most) {
    text.resize(character_start(text, most));
    return text;
}

}  // namespace braitenlab
