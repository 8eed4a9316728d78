// Pictures as PNG: W3C Recommendation Portable Network Graphics, second edition.
#pragma once

#include <string>
#include <vector>

namespace braitenlab {

// The content of a file; `rgb` holds three bytes per pixel, rows from the top.
std::string png(int width, int height, const std::vector<unsigned char>& rgb);

}  // namespace braitenlab
