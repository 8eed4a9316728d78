// The colours of a picture with few colours: chosen from its own colours, and the nearest one to a pixel.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace braitenlab {

using Rgb = std::array<std::uint8_t, 3>;

// How often each colour occurs, in 64 steps per channel.
class ColourCount {
public:
    ColourCount();
    // Three bytes per pixel.
    void add(std::span<const unsigned char> rgb);

    // At most `most` colours. The box of colours with the largest spread is halved at its mean until there are enough
    // (as median cut, P. Heckbert, SIGGRAPH 1982). A colour counts by the square root of its number of pixels, so that
    // small things keep their colours beside a large floor.
    std::vector<Rgb> choose(std::size_t most) const;

private:
    struct Bin {
        std::uint64_t count = 0;
        std::array<std::uint64_t, 3> sum{};
    };
    std::vector<Bin> bins_;
};

// Finds the nearest of at most 255 colours.
class ColourTable {
public:
    // Precondition: 1 to 255 colours.
    explicit ColourTable(std::vector<Rgb> colours);

    const std::vector<Rgb>& colours() const { return colours_; }

    // The number of the nearest colour, with an ordered dither of a few levels that depends on the place only: what
    // rests in a clip keeps its colours.
    std::uint8_t nearest(Rgb, int x, int y);

private:
    std::uint8_t search(Rgb) const;
    std::vector<Rgb> colours_;
    std::vector<std::int16_t> known_;  // by 128 steps per channel; −1: not searched yet
};

}  // namespace braitenlab
