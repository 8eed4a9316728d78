// Finds font files of the system.
#pragma once

#include <functional>
#include <string>

namespace braitenlab::render {

// Path of a font file that has the character; for 0 of the default font. Empty when there is none.
using FindFont = std::function<std::string(char32_t)>;

// With fontconfig, preferring Noto Sans and DejaVu Sans; without it by their usual paths.
std::string find_font(char32_t);

}  // namespace braitenlab::render
