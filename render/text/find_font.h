// Where the system keeps its fonts.
#pragma once

#include <functional>
#include <string>

namespace braitenlab::render {

// A font file that has the character; for 0 the usual one for reading. Empty where there is none.
using FindFont = std::function<std::string(char32_t)>;

// By fontconfig, which prefers Noto Sans and DejaVu Sans; without fontconfig by looking where systems put these two.
std::string find_font(char32_t);

}  // namespace braitenlab::render
