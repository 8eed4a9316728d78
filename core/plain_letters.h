// Texts in small letters, also without accents, to search them and to name files.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/utf8.h"

namespace braitenlab {

// Of ASCII letters.
constexpr char lower_case(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
inline std::string lower_case(std::string text) {
    for (char& c : text) c = lower_case(c);
    return text;
}

// Small ASCII letters and digits, and single '-' for what is between them; `others`: letters of other scripts stay.
inline std::string with_dashes(std::string_view text, bool others = false) {
    std::string name;
    for (const char letter : text) {
        const char c = lower_case(letter);
        const bool is_plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        if (is_plain || (others && static_cast<unsigned char>(c) >= 0x80))
            name += c;
        else if (!name.empty() && name.back() != '-')
            name += '-';
    }
    while (name.ends_with('-')) name.pop_back();
    return name;
}

enum class Umlauts { as_vowels, spelled };  // ä as "a", or as "ae" as German spells it without umlauts

// "Über" becomes "uber" or "ueber", "Straße" "strasse", "Łukasz" "lukasz"; "-" stands for the signs × and ÷. Letters
// beyond Latin Extended-A stay. An accent may be a character of its own behind its letter, as in names of files that
// macOS has written.
inline std::string plain_letters(std::string_view text, Umlauts umlauts) {
    // U+00E0 .. U+00FF; U+00C0 .. U+00DF are their capitals, but for ß.
    constexpr std::array<std::string_view, 32> latin{"a",  "a", "a", "a", "ae", "a", "ae", "c", "e",  "e", "e",
                                                     "e",  "i", "i", "i", "i",  "d", "n",  "o", "o",  "o", "o",
                                                     "oe", "-", "o", "u", "u",  "u", "ue", "y", "th", "y"};
    // U+0100 .. U+017F, the letter below each accent.
    constexpr std::string_view extended =
        "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiiiiijjkkkllllllllllnnnnnnnnnoooooooo"
        "rrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs";
    static_assert(extended.size() == 0x80);
    std::string plain;
    while (!text.empty()) {
        const auto [code, size, is_valid] = first_code_point(text);
        if (code == 0xDF) {
            plain += "ss";
        } else if (code >= 0xC0 && code <= 0xFF) {
            const std::string_view letters = latin[code & 0x1F];
            const bool is_umlaut = (code | 0x20) == 0xE4 || (code | 0x20) == 0xF6 || (code | 0x20) == 0xFC;
            plain += is_umlaut && umlauts == Umlauts::as_vowels ? letters.substr(0, 1) : letters;
        } else if (code >= 0x100 && code < 0x180) {
            plain += extended[code - 0x100];
        } else if (code >= 0x300 && code < 0x370) {
            constexpr std::string_view vowels = "aou";
            const bool is_umlaut = code == 0x308 && !plain.empty() && vowels.find(plain.back()) != vowels.npos;
            if (is_umlaut && umlauts == Umlauts::spelled) plain += 'e';
        } else {
            plain += lower_case(std::string(text.substr(0, size)));
        }
        text.remove_prefix(size);
    }
    return plain;
}

}  // namespace braitenlab
