// Finds font files of the system.
#pragma once

#include <functional>
#include <string>

namespace braitenlab::render {

// Path of a font file that contains the character; the default font for the character 0. Empty if there is none.
using FindFont = std::function<std::string(char32_t)>;

// Searches with fontconfig and prefers Noto Sans and DejaVu Sans. Without fontconfig, searches the usual paths of these
// fonts.
std::string find_font(char32_t);

}  // namespace braitenlab::render
