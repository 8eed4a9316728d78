// PNG files without compression, for programs that are built without the library of the window.
#pragma once

#include <string>
#include <vector>

namespace braitenlab {

// The content of a PNG file; `rgb` holds three bytes per pixel, rows from the top. The file is a little larger than the
// pixels. Format: W3C Recommendation Portable Network Graphics, second edition; RFC 1950 and 1951 (stored blocks).
std::string plain_png(int width, int height, const std::vector<unsigned char>& rgb);

}  // namespace braitenlab
