// Texts in UTF-8 of limited size.
#pragma once

#include <string>

namespace braitenlab {

// At most `most` bytes of the text, cut between two characters.
inline std::string utf8_cut(std::string text, std::size_t most) {
    if (text.size() <= most) return text;
    while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0U) == 0x80U) --most;
    text.resize(most);
    return text;
}

}  // namespace braitenlab
