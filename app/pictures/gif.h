// Moving pictures as GIF. A picture after the first one holds only what has changed since the one before. Where much
// changes, small differences wait up to a second and then every other picture is left out, so that 10 s of 640 × 400
// pixels stay below about 3 MB.
// Format: Graphics Interchange Format, version 89a (CompuServe, 1990), with the application extension for loops.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/pictures/colour_table.h"

namespace braitenlab {

class GifWriter {
public:
    // `hundredths`: of a second, the time of each picture; at least 2, because browsers show faster ones slowly.
    // Precondition: sizes 1 to 65535.
    GifWriter(int width, int height, std::vector<Rgb> colours, int hundredths);

    // Each function returns the next bytes of the file. `rgb` holds three bytes per pixel, rows from the top.
    std::string begin() const;
    std::string picture(const std::vector<unsigned char>& rgb);
    static std::string end() { return ";"; }

private:
    std::string block_of(int left, int top, int right, int bottom, const std::vector<std::uint8_t>& numbers) const;
    // Levels of a channel, of 255, by which a pixel may differ from its colour.
    int tolerance() const;

    int width_, height_, hundredths_;
    ColourTable table_;
    std::vector<unsigned char> shown_;  // the last colours of each pixel; empty before the first picture
    std::size_t pictures_ = 0, drawn_ = 0, bytes_ = 0;  // so far; drawn: without those left out
};

// The numbers, each below 256, compressed by LZW with codes of 9 to 12 bits, in blocks of at most 255 bytes.
std::string gif_compressed(const std::vector<std::uint8_t>& numbers);

}  // namespace braitenlab
